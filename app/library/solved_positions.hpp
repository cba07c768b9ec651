// Solutions in positions of a driver that a caller writes as text.
#pragma once

#include <string>
#include <vector>

#include "constructions/solving/solve.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/solution/solution.hpp"
#include "kinegraph/mechanism.hpp"

namespace kinegraph::app {

/// In the order of `wanted.at`; the title of each names its position. Errors: bad_input for a text that is no position
/// or one out of reach, no_unique_answer at a change point, and those of the drawing.
Result<std::vector<Solution>> solved_positions(const Mechanism& mechanism, const PositionsWanted& wanted,
                                               Arithmetic arithmetic);

}  // namespace kinegraph::app
