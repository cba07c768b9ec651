// What marks of figures go with elsewhere than where they were drawn: of a solution the elements, under the names of
// engine/solution/held.hpp.
#pragma once

#include <vector>

#include "engine/solution/moving.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Of forces, under all loads and under those of one body alone, of curvature and of powers; what vanishes has no
/// element.
std::vector<MovingPlan::Held> held_by(const Solution& solution);

}  // namespace kinegraph
