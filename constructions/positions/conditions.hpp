// Conditions of an exercise, held against the results of a solution. Knows no paper: whether a polygon can be read is
// asked of whoever draws it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constructions/positions/named_results.hpp"
#include "engine/mechanism/exercise.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Whether a comparison holds of these results. Equal is what differs by less than 1e-9 of the larger. Errors: a result
/// that the solution has not got (bad input, or no unique answer), or that is of another kind than what it is compared
/// with.
Result<bool> holds(const Condition& condition, const Solution& solution, const std::vector<NamedResult>& results);

/// What an exercise asks for, compares or wants to be readable, and its solution has not got, each at its place:
/// missing_result, or a polygon that is not drawn. `results`: results_for.
Errors missing_in(const Solution& solution, const std::vector<NamedResult>& results);
/// The same of a file that may have no exercise; nothing where not all is found, which the solution tells itself.
Errors missing_in(const Solution& solution);

/// Of a condition on a polygon: that it is not drawn; nothing where it is, or where not all is found.
std::optional<Error> missing_polygon(const Solution& solution, const Condition& condition);

/// Whether the first driver makes a whole turn in both senses: from its drawn position no limit stops it.
bool crank_turns_fully(const Mechanism& mechanism, const Pose& pose);

}  // namespace kinegraph
