// Exercise: what a file asks of those who solve it, which parameters take other values from copy to copy, and which
// conditions every copy meets. Results go by the names that they have in the rows of a sweep
// (engine/results/result_names.hpp). Knows no values of results: those are constructions/positions/named_results.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/file/formula.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// One of the results that are asked for.
struct AskedResult {
    std::string name;   ///< "v B", "omega 3", "effort M"
    std::string where;  ///< JSON pointer
};

/// A parameter that has another value from copy to copy: one of `choices`, or from, from + step, from + 2 step …
struct Variation {
    std::string parameter;
    std::string where;
    std::vector<std::string> choices;  ///< as the file writes them: "30°", "3"; empty: it goes in steps
    Exact from, step;                  ///< in `unit`
    std::string unit;                  ///< empty: bare numbers
    std::uint64_t count = 1;           ///< of values

    /// The i-th value as a parameter may be written: "45 mm", "3", exactly.
    std::string value(std::uint64_t i) const;
};

/// One side of a condition: a result, or a formula of parameters.
struct Operand {
    std::string text;                                 ///< as the file writes it
    std::string result;                               ///< its name; empty: a formula
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
        polygon_readable    ///< no vector that is sought in `polygon` is short on paper
    } kind = Kind::compares;
    enum class Relation { less, at_most, equal, at_least, greater } relation = Relation::less;
    Operand left{}, right{}, upper{};
    enum class Polygon { velocity, acceleration, force } polygon = Polygon::velocity;
    std::optional<bool> holds =
        std::nullopt;  ///< where parameters alone decide: whether it holds with their own values
};

/// A sought vector shorter than this on paper cannot be read with an accuracy worth the name, mm.
inline constexpr double readable_length = 8;

struct Exercise {
    std::vector<AskedResult> ask;  ///< none twice
    std::vector<Variation> vary;   ///< no parameter twice
    std::vector<Condition> require;
    std::string comes_to{};  ///< the values of the file's formulas: two variants with the same are one mechanism
};

/// What a mechanism asks for; nothing where its file says nothing of it.
inline const std::vector<AskedResult>& asked_of(const Mechanism& mechanism) {
    static const std::vector<AskedResult> nothing;
    return mechanism.exercise ? mechanism.exercise->ask : nothing;
}

}  // namespace kinegraph
