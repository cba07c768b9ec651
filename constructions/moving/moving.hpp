// Plans a mechanism piece by piece along the travel of its drivers, and records the programs for replay.
#pragma once

#include "constructions/moving/moving_parameters.hpp"
#include "engine/solution/moving.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// From a solution in its drawn position, for each of its drivers. None if nothing moves it: no driver, no joints, or
/// motion not determined. A new plan is made where no earlier one is valid, up to `most_plans`; positions beyond that
/// have no plan. Without `rereading`, which reads the file of the solution again, no parameter can be changed.
std::optional<Moving> moving_of(const Solution& solution, const Rereading& rereading = {});

}  // namespace kinegraph
