// Formulas in running text: scalar equations with italic letters and subscripts, and quantities with their units.
// Independent of the quantities of a solution.
#pragma once

#include <string>
#include <string_view>

#include "engine/solution/problem_solution.hpp"
#include "render/text/rich_text.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

/// Rich text from a template: {p_0} is the letter p with the subscript 0, {a^2} has an exponent, ^{1/3} is an exponent
/// of what precedes it, {!v} is a vector. Letters are italic, those of vectors bold, digits of subscripts upright.
RichText formula(std::string_view text);
/// The same for names of vectors: letters are bold italic.
RichText vector_formula(std::string_view text);
/// A symbol by its name in results: "p_0", "τ_max".
RichText symbol_of(const std::string& name);

/// For `digits`: print the number as the file gives it.
constexpr int as_given = 0;
/// A quantity for readers, in the file's unit. Pressures of a file in Pa, and very small lengths, use a prefix that
/// suits the value.
std::string amount(double si, QuantityKind kind, const Units& units, Language language, int digits = 4);
/// The unit that amount() uses.
Unit suitable_unit(double si, QuantityKind kind, const Units& units);
/// The same in every language, for sentences.
Words amount(double si, QuantityKind kind, const Units& units, int digits = 4);
/// A dimensionless number in every language.
Words numeral(double value, int digits = 4);

}  // namespace kinegraph::render
