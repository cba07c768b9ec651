// Formulas of a file: "= 2*r + 10 mm" evaluated to a quantity, exactly where it is rational, else within 2^-200 of its
// size, with its dimension checked at every step. Roots and sines are computed to 600 bits, and each value carries an
// error bound. A value within its error bound of zero is zero; this is decided before a division or a root. Independent
// of JSON and of the formula's position. The grammar: engine/file/formula_syntax.hpp.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "engine/file/units.hpp"
#include "engine/number/exact.hpp"
#include "lang/words.hpp"

namespace kinegraph {

struct Syntax;

/// Exponents of the base quantities. The angle is one of them, so that a length plus an angle is an error. In a product
/// it is dropped where the radian is (ω² r is an acceleration).
struct Dimension {
    int length = 0, mass = 0, time = 0, angle = 0;
    bool is_a_number() const { return length == 0 && mass == 0 && time == 0 && angle == 0; }
    // NOLINTNEXTLINE(modernize-use-nullptr): as in quantity.hpp
    friend bool operator==(const Dimension&, const Dimension&) = default;
    friend Dimension operator*(const Dimension& a, const Dimension& b) {
        return {a.length + b.length, a.mass + b.mass, a.time + b.time, a.angle + b.angle};
    }
    friend Dimension operator/(const Dimension& a, const Dimension& b) {
        return {a.length - b.length, a.mass - b.mass, a.time - b.time, a.angle - b.angle};
    }
};
/// The dimension to the power top/below; none: an exponent would not be whole.
std::optional<Dimension> power_of(const Dimension& dimension, long top, long below);

/// Of a quantity of a kind.
Dimension dimension_of(QuantityKind kind);
/// The kind of a dimension; where no kind has just this one, an angle counts as a number (ω² r is an acceleration).
/// None: there is no such kind.
std::optional<QuantityKind> kind_of(const Dimension& dimension);
/// "kg m^2/s".
std::string base_units(const Dimension& dimension);
/// "a length", "a quantity in kg m^2/s".
Words described(const Dimension& dimension);

/// A value of a formula.
struct Measured {
    Exact value;       ///< in m, kg, s and degrees, so that 60° and 120 rpm stay rational
    Exact error = {};  ///< bound on the error of the value; zero where it is rational
    Dimension dimension;
    bool is_bare = false;         ///< made of bare numbers alone: where a quantity is wanted it is in the file's unit
    bool is_in_radians = false;   ///< bare, and contains π: as an angle it is in radians
    bool is_approximate = false;  ///< contains a root or a sine
};

/// Looks up a name of a formula. Error: why there is no such value.
using LookUp = std::function<tl::expected<Measured, Words>(std::string_view name)>;

/// Whether the text is a formula: "= …".
bool is_formula(std::string_view text);
/// The value of "= …". Errors, in words that quote the place: syntax, unknown names and functions, incompatible
/// dimensions, division by zero, roots of negative numbers, numbers beyond 1e±300, more than 100 nested brackets.
tl::expected<Measured, Words> evaluate(std::string_view formula, const LookUp& look_up);
/// A parameter's text: "40 mm", "= 2*r", or (on the command line) "3".
tl::expected<Measured, Words> read_measured(std::string_view text, const LookUp& look_up);
/// A number of a formula, with its unit. Error: it is no decimal.
tl::expected<Measured, Words> measured(const Syntax& number);
Measured measured(const WrittenQuantity& written);
/// The same quantity as a number: degrees converted to radians.
Measured in_radians(Measured of);
/// A bare number.
Measured bare(Exact value);
/// In SI units, angles in radians.
Exact in_si(const Measured& value);

/// As a quantity of a kind, to 2^-200 of its size where it contains a root or a sine; `bare_unit` is the unit of a bare
/// number. Error: it is of another kind.
tl::expected<WrittenQuantity, Words> as_quantity(const Measured& value, QuantityKind kind, const KnownUnit& bare_unit);
/// As a bare number: a ratio, a component of a direction.
tl::expected<Exact, Words> as_number(const Measured& value);
/// "a length", "a bare number", "a quantity in kg m²/s".
Words described(const Measured& value);

/// Whether the name is valid for a parameter: a letter, then letters, digits and underscores; neither a function's name
/// nor pi.
bool is_parameter_name(std::string_view name);
/// sin, cos, … and pi.
std::span<const std::string_view> formula_words();

}  // namespace kinegraph
