// Conditions of an exercise, evaluated on the results of a solution. The caller decides whether a polygon is readable.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constructions/positions/named_results.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/exercise.hpp"

namespace kinegraph {

struct Solution;

/// Whether a comparison holds. Values that differ by less than 1e-9 of the larger are equal. Errors: a result that does
/// not exist (bad input, or no unique answer), or of another kind than the one it is compared with.
Result<bool> holds(const Condition& condition, const Solution& solution, const std::vector<NamedResult>& results);

/// Results and polygons used by an exercise that the solution does not have, each at its place: missing_result, or a
/// polygon that is not drawn. `results`: from results_for.
Errors missing_in(const Solution& solution, const std::vector<NamedResult>& results);
/// The same for a file that may have no exercise. Empty if results are unsolved; the solution then gives the
/// reasons.
Errors missing_in(const Solution& solution);

/// The error if a condition uses a polygon that is not drawn; none if it is drawn or results are unsolved.
std::optional<Error> missing_polygon(const Solution& solution, const Condition& condition);

/// Whether the first driver makes a whole turn in both senses without reaching a limit.
bool crank_turns_fully(const Mechanism& mechanism, const Pose& pose);

}  // namespace kinegraph
