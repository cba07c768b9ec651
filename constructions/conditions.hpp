// Conditions of an exercise, held against the results of a solution. Knows no paper: whether a polygon can be read is asked of
// whoever draws it.
#pragma once

#include <string>
#include <vector>

#include "constructions/named_results.hpp"
#include "engine/exercise.hpp"
#include "engine/solution.hpp"

namespace kinegraph {

/// Whether a comparison holds of these results. Equal is what differs by less than 1e-9 of the larger. Errors: a result that the
/// solution has not got (bad input, or no unique answer), or that is of another kind than what it is compared with.
Result<bool> holds(const Condition& condition, const Solution& solution, const std::vector<NamedResult>& results);

/// Whether the first driver makes a whole turn in both senses: from its drawn position no limit stops it.
bool crank_turns_fully(const Mechanism& mechanism, const Pose& pose);

}  // namespace kinegraph
