// The sections of a file that make an exercise of it: "ask", "vary", "require". Each fault where it stands.
#pragma once

#include "engine/mechanism/exercise.hpp"
#include "engine/reading/law_reader.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph {

/// What the reader of a mechanism file is built on, beside its sections.
class ExerciseReader : protected LawReader {
protected:
    /// To be read last, when all that has results is known.
    void read_exercise(const Members& file, Mechanism& mechanism);

private:
    void read_ask(JsonValue ask, Exercise& exercise);

    void read_vary(JsonValue vary, Exercise& exercise);
    void read_variation(JsonValue member, Exercise& exercise);
    /// The value that the file gives a parameter, against which the values that it takes are held: told where `--set`
    /// gives another kind. Null: it has none that could be read.
    const Measured* own_value(std::string_view name, const Parameter& parameter, std::optional<Measured>& of_the_file);
    void read_choices(JsonValue choose, const Measured* own, Variation& variation);
    void read_steps(const Members& form, const Measured* own, Variation& variation);
    /// A value that a parameter may take: a number or a quantity, of the kind that the parameter has.
    std::optional<Measured> value_of_parameter(JsonValue value, const Measured* own);

    void read_require(JsonValue require, const Mechanism& mechanism, Exercise& exercise);
    std::optional<Condition> condition(JsonValue value, const Mechanism& mechanism);
    std::optional<Condition> phrase(JsonValue value, std::string_view text, const Mechanism& mechanism);
    std::optional<Operand> operand(JsonValue at, std::string_view text, bool is_problem);
    /// What the sides of a condition are must go together; where parameters alone decide it is seen whether it holds.
    void match_sides(JsonValue at, Condition& condition);
    /// Of two limits that no parameter moves: the lower one lies above the upper one.
    bool never_holds(const Condition& condition) const;
    void hold_sides_together(JsonValue at, Condition& condition);
    std::optional<int> compared(JsonValue at, const Operand& left, const Operand& right);
    const Column* result_named(std::string_view name) const;

    std::vector<Column> results_;  ///< that the mechanism may have
    bool knows_results_ = false;
    bool knows_uses_ = false;  ///< which parameters are used: all else could be read, and as it stands in the file
};

}  // namespace kinegraph
