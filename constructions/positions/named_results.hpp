// Named results: what a solution holds under the names that the rows of a sweep have, one by one. Computes no
// mechanics.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/mechanism/exercise.hpp"
#include "engine/number/exact.hpp"
#include "engine/sentences/column.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// One value of a solution that a column can hold. Without an element it vanishes.
struct FoundValue {
    Quantity quantity;
    ElementIndex element;
    VectorOf<double> vector;  ///< of a component: the whole vector
    double scalar = 0;
    Exact exact;  ///< the scalar, or the component
};
/// In the order of the columns of a sweep. Of action and reaction the one that the results name first, or both.
std::vector<FoundValue> found_values(const Solution& solution, bool with_reactions = false);
/// The columns that these give rise to, angles, places and slides with them.
std::vector<Column> columns_found(const Solution& solution, bool with_reactions = false);

struct NamedResult {
    Column column;          ///< its name, and what it is of
    double value = 0;       ///< SI
    std::string unit = {};  ///< SI, of what has no kind: "N s", "J"
};
/// The same exactly, SI; none of what took a root (a length, an angle) or hangs on what the compass left over.
std::optional<Exact> exact_value(const NamedResult& result, const Solution& solution);
/// All that a solution holds: the results of a sweep's row (without turn, time and slides, which are nothing in one
/// position), the lengths of vectors ("v B"), and of a problem its values. Two of them never have one name.
std::vector<NamedResult> named_results(const Solution& solution);
/// The results that an exercise speaks of: all named ones, and the transmission angle where it speaks of it (that takes
/// a whole cycle) and the mechanism has one.
std::vector<NamedResult> results_for(const Exercise& exercise, const Solution& solution);
/// Null: none of that name.
const NamedResult* result_named(const std::vector<NamedResult>& results, const std::string& name);
/// What the file asks for, in its order, of results_for; of the bars of a truss the force in them, tension positive.
/// Errors, each at its place: missing_result.
Result<std::vector<NamedResult>> asked_of_results(const Solution& solution, const std::vector<NamedResult>& results);
Result<std::vector<NamedResult>> asked_results(const Solution& solution);
/// That there is no such result: none of that name, with the nearest (bad input), or none in this position (no unique
/// answer).
Error missing_result(const Solution& solution, const std::vector<NamedResult>& results, const std::string& name,
                     const std::string& where);

/// In the file's unit, with that unit's symbol ("" for a bare number).
struct ToldResult {
    double value = 0;
    std::string unit;
};
ToldResult told(const NamedResult& result, const Units& units);
/// The unit in which a file tells quantities of a kind.
Unit unit_of(QuantityKind kind, const Units& units);

}  // namespace kinegraph
