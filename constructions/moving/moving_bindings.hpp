// Binds marks of figures to the elements of a solution that place them, by the names of engine/solution/bindings.hpp.
#pragma once

#include <vector>

#include "engine/solution/moving.hpp"

namespace kinegraph {

struct Solution;

/// Elements of forces (under all loads and under those of one body alone), of curvature and of powers. A quantity that
/// vanishes has no element.
std::vector<MovingPlan::Binding> bindings_of(const Solution& solution);

}  // namespace kinegraph
