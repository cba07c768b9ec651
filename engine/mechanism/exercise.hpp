// Exercise: the results that students are to find, the parameters that vary between copies, and the conditions on
// every copy. Results are named as in the rows of a sweep (engine/results/result_names.hpp). Values of results are
// elsewhere: constructions/positions/named_results.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/file/formula.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// One of the wanted results.
struct AskedResult {
    std::string name;   ///< "v B", "omega 3", "effort M"; of an expression its own name, or its text
    std::string where;  ///< JSON pointer
};

/// A parameter that varies between copies: one of `choices`, or from, from + step, from + 2 step …
struct Variation {
    std::string parameter;
    std::string where;
    std::vector<std::string> choices;  ///< as the file writes them: "30°", "3"; empty: a range in steps
    Exact from, step;                  ///< in `unit`
    std::string unit;                  ///< empty: bare numbers
    std::uint64_t count = 1;           ///< of values

    /// The i-th value as a parameter may be written: "45 mm", "3", exactly.
    std::string value(std::uint64_t i) const;
    /// The same for any value, in the unit of this parameter.
    std::string text_of(const Exact& value) const;
};

/// One side of a condition: a result, or a formula of parameters.
struct Operand {
    std::string text;                                 ///< as the file writes it
    std::string result;                               ///< name of the result; empty: a formula
    bool absolute = false;                            ///< |omega 3|
    std::optional<Measured> measured = std::nullopt;  ///< of a formula: its value with the parameters' own values
};
struct Condition {
    std::string text;   ///< as the file writes it
    std::string where;  ///< JSON pointer
    enum class Kind {
        compares,           ///< `left` with `right`
        lies_between,       ///< `left` between `right` and `upper`, these included
        crank_turns_fully,  ///< the first driver makes a whole turn
        polygon_readable    ///< no unknown vector in `polygon` is short on paper
    } kind = Kind::compares;
    enum class Relation { less, at_most, equal, at_least, greater } relation = Relation::less;
    Operand left{}, right{}, upper{};
    enum class Polygon { velocity, acceleration, force } polygon = Polygon::velocity;
    std::optional<bool> holds =
        std::nullopt;  ///< where it depends on parameters only: whether it holds with their own values
};

/// An unknown vector shorter than this on paper cannot be measured accurately, mm.
inline constexpr double readable_length = 8;

struct Exercise {
    std::vector<AskedResult> ask;  ///< none twice
    std::vector<Variation> vary;   ///< no parameter twice
    std::vector<Condition> require;
    /// Expressions of results in `ask` and `require`, as the file writes them (engine/results/result_expression.hpp).
    /// Wanted results and conditions refer to them by their names.
    std::vector<std::string> expressions;
    std::string comes_to{};  ///< the values of the file's formulas: two variants with the same values are one mechanism
};

/// The wanted results of a mechanism; empty where its file has none.
inline const std::vector<AskedResult>& asked_of(const Mechanism& mechanism) {
    static const std::vector<AskedResult> nothing;
    return mechanism.exercise ? mechanism.exercise->ask : nothing;
}

}  // namespace kinegraph
