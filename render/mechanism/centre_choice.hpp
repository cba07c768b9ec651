// Which instant centres the figure of the mechanism shows where there are many. Independent of scale and paper.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/solution/solution.hpp"

namespace kinegraph::render::drawing {

/// Index into Solution::centres of the centre of two bodies.
std::size_t index_of_centre(const Mechanism& mechanism, BodyIndex i, BodyIndex j);

/// By centre: whether it belongs to the absolute and primary ones, to those on which a sentence measures, or to those
/// whose joins determine one of these.
std::vector<bool> needed_centres(const Solution& solution);

}  // namespace kinegraph::render::drawing
