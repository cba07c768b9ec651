// Named results: the values of a solution under the names of the columns of a sweep.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/mechanism/exercise.hpp"
#include "engine/number/exact.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph {

struct Solution;

/// One value of a solution that a column can contain. Without an element it is zero.
struct FoundValue {
    Quantity quantity;
    ElementIndex element;
    VectorOf<double> vector{};  ///< for a component: the whole vector
    double scalar = 0;
    std::optional<Exact> exact{};  ///< the scalar, or the component; none: it is not in the record
    ElementIndex from{};           ///< of a distance: the place where it begins; none: the quantity's point
};
/// In the order of the columns of a sweep. Of action and reaction, the one that comes first in the results, or both.
std::vector<FoundValue> found_values(const Solution& solution, bool with_reactions = false);
/// The columns for these values, and those of angles, places and slides; also those on request.
std::vector<Column> columns_found(const Solution& solution, bool with_reactions = false);

struct NamedResult {
    Column column;          ///< its name and quantity
    double value = 0;       ///< SI
    std::string unit = {};  ///< SI, if the quantity has no kind: "N s", "J"
};
/// The exact value, SI; none if it involves a root (a length, an angle) or a rounded drawing.
std::optional<Exact> exact_value(const NamedResult& result, const Solution& solution);
/// All values of a solution: the results of a sweep's row (without turn, time and slides, which have no meaning in one
/// position), the lengths of vectors ("v B"), and the values of a problem. The names are unique.
std::vector<NamedResult> named_results(const Solution& solution);
/// The file's parameters, for expressions of results.
std::vector<NamedResult> parameters_of(const Mechanism& mechanism);
/// The least transmission angle over the whole travel of the first driver; none if there is no travel or no coupler.
std::optional<NamedResult> least_transmission_angle(const Solution& solution);
/// The results for an exercise: all named ones, and the transmission angle if the exercise uses it (it needs a whole
/// cycle) and the mechanism has one.
std::vector<NamedResult> results_for(const Exercise& exercise, const Solution& solution);
/// The value of an expression of these results (engine/results/result_expression.hpp). Errors: it cannot be read (bad
/// input), or has no value here (no unique answer).
tl::expected<NamedResult, Error> result_of_expression(std::string_view text, const std::vector<NamedResult>& results);
/// Null if there is none.
const NamedResult* result_named(const std::vector<NamedResult>& results, const std::string& name);
/// The results in the file's "ask", in its order, from results_for; for a bar of a truss its force, tension positive.
/// Errors, each at its place: missing_result.
Result<std::vector<NamedResult>> asked_of_results(const Solution& solution, const std::vector<NamedResult>& results);
Result<std::vector<NamedResult>> asked_results(const Solution& solution);
/// The error for a missing result: unknown name, with the nearest one (bad input), or no value in this position (no
/// unique answer).
Error missing_result(const Solution& solution, const std::vector<NamedResult>& results, const std::string& name,
                     const std::string& where);

/// In the file's unit, with that unit's symbol ("" for a bare number).
struct ToldResult {
    double value = 0;
    std::string unit;
};
ToldResult told(const NamedResult& result, const Units& units);

}  // namespace kinegraph
