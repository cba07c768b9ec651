// Formulas: scalar equations as they are typed, with letters in italics and their indices. Knows no quantity.
#pragma once

#include <string>
#include <string_view>

#include "engine/solution/problem_solution.hpp"
#include "render/text/rich_text.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

/// Text in which {p_0} is the letter p with the subscript 0, {a^2} with an exponent, and ^{1/3} an exponent of what
/// stands before it; digits of indices are upright, letters in italics.
RichText formula(std::string_view text);
/// A symbol as results name it: "p_0", "τ_max".
RichText symbol_of(const std::string& name);

/// Digits of a number that is said as the file gives it.
constexpr int as_given = 0;
/// A quantity for readers, in the file's unit; pressures where the file has them in Pa, and very small lengths, in the
/// one that suits.
std::string amount(double si, QuantityKind kind, const Units& units, Language language, int digits = 4);
/// The unit in which amount() says it.
Unit suitable_unit(double si, QuantityKind kind, const Units& units);
/// The same in all languages, for sentences.
Words amount(double si, QuantityKind kind, const Units& units, int digits = 4);
/// A bare number in all languages.
Words numeral(double value, int digits = 4);

}  // namespace kinegraph::render
