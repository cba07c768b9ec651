// The sections of an exercise: "ask", "vary", "require". Each fault is reported at its place.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "engine/mechanism/exercise.hpp"
#include "engine/reading/law_reader.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph {

/// The base of the mechanism file reader, besides its sections.
class ExerciseReader : protected LawReader {
protected:
    /// Must be read last, when everything that has results is known.
    void read_exercise(const Members& file, Mechanism& mechanism);

private:
    void read_ask(JsonValue ask, Exercise& exercise);

    void read_vary(JsonValue vary, Exercise& exercise);
    void read_variation(JsonValue member, Exercise& exercise);
    /// The value that the file gives a parameter; its variations are compared with it. Reports a `--set` of another
    /// kind. Null: the parameter has no readable value.
    const Measured* own_value(std::string_view name, const Parameter& parameter, std::optional<Measured>& of_the_file);
    void read_choices(JsonValue choose, const Measured* own, Variation& variation);
    void read_steps(const Members& form, const Measured* own, Variation& variation);
    /// A value of a variation: a number or a quantity, of the parameter's kind.
    std::optional<Measured> value_of_parameter(JsonValue value, const Measured* own);

    void read_require(JsonValue value, const Mechanism& mechanism, Exercise& exercise);
    std::optional<Condition> condition(JsonValue value, const Mechanism& mechanism, Exercise& exercise);
    std::optional<Condition> phrase(JsonValue value, std::string_view text, const Mechanism& mechanism);
    std::optional<Operand> operand(JsonValue at, std::string_view text, bool is_problem, Exercise& exercise);
    /// Checks that the sides of a condition are of the same kind. If the condition depends on parameters only, checks
    /// whether it is satisfied.
    void match_sides(JsonValue at, Condition& condition);
    /// Whether both limits are constant and the lower one exceeds the upper one.
    bool never_holds(const Condition& condition) const;
    void hold_sides_together(JsonValue at, Condition& condition);
    std::optional<int> compared(JsonValue at, const Operand& left, const Operand& right);
    const Column* result_named(std::string_view name) const;
    bool needs_curvature(const Exercise& exercise) const;
    /// Adds an expression of results to the exercise; its column. Error: why it is none.
    tl::expected<Column, Words> add_expression(std::string_view text, Exercise& exercise);

    std::vector<Column> results_;      ///< of the mechanism
    std::vector<Column> expressions_;  ///< of results, which the file has named so far
    std::vector<Column> parameter_columns_;
    bool knows_results_ = false;
    bool knows_uses_ = false;  ///< the uses of parameters are known: the rest was readable, with the file's own values
};

}  // namespace kinegraph
