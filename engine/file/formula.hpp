// Formulas of a file: "= 2*r + 10 mm" evaluated to a quantity, exactly where it is rational, else within 2^-200 of its
// size, with its dimension checked at every step. Roots and sines are known to 600 bits, and each value carries what it
// may be off by: what that does not tell from zero is zero, before anything is divided by it or a root is taken of it.
// Knows nothing of JSON nor of where a formula stands.
//
//   sum      = product { ("+" | "-") product }
//   product  = factor { ("*" | "/") factor }
//   factor   = ("+" | "-") factor | power
//   power    = operand [ "^" factor ]
//   operand  = number [ unit ] | name | function "(" sum { "," sum } ")" | "(" sum ")"
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "engine/file/units.hpp"
#include "engine/file/words.hpp"
#include "engine/number/exact.hpp"

namespace kinegraph {

/// Exponents of the base quantities. The angle is one of them, so that a length plus an angle is seen to be wrong; in a
/// product it falls away where it must (ω² r is an acceleration), as the radian.
struct Dimension {
    int length = 0, mass = 0, time = 0, angle = 0;
    bool is_a_number() const { return length == 0 && mass == 0 && time == 0 && angle == 0; }
    // NOLINTNEXTLINE(modernize-use-nullptr): as in quantity.hpp
    friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// What a formula works with.
struct Measured {
    Exact value;       ///< in m, kg, s and degrees, so that 60° and 120 rpm stay rational
    Exact error = {};  ///< by how much the value may be off, at most; none where it is rational
    Dimension dimension;
    bool is_bare =
        false;  ///< of bare numbers alone: where a quantity is wanted it is in the file's unit, as a number is
    bool is_in_radians = false;   ///< bare, and π took part: as an angle it is in radians
    bool is_approximate = false;  ///< a root or a sine took part
};

/// How a formula's names are looked up. Error: why there is no such value.
using LookUp = std::function<tl::expected<Measured, Words>(std::string_view name)>;

/// True of what a file means as a formula: "= …".
bool is_formula(std::string_view text);
/// The value of "= …". Errors, in words that quote the place: syntax, unknown names and functions, dimensions that do
/// not go together, division by zero, roots of negative numbers, numbers beyond 1e±300, more than 100 brackets within
/// each other.
tl::expected<Measured, Words> evaluate(std::string_view formula, const LookUp& look_up);
/// A parameter's text: "40 mm", "= 2*r", or (on the command line) "3".
tl::expected<Measured, Words> read_measured(std::string_view text, const LookUp& look_up);
/// A bare number.
Measured bare(Exact value);

/// As a quantity of a kind, to 2^-200 of its size where a root or a sine took part; `bare_unit` is what a bare number
/// is in. Error: it is of another kind.
tl::expected<WrittenQuantity, Words> as_quantity(const Measured& value, QuantityKind kind, const KnownUnit& bare_unit);
/// As a bare number: a ratio, a component of a direction.
tl::expected<Exact, Words> as_number(const Measured& value);
/// "a length", "a bare number", "a quantity in kg m²/s".
Words described(const Measured& value);

/// Whether a parameter may have this name: a letter, then letters, digits and underscores; no function's name and not
/// pi.
bool is_parameter_name(std::string_view name);
/// sin, cos, … and pi.
std::span<const std::string_view> formula_words();

}  // namespace kinegraph
