// Units: the table of every unit that a file may write, and the exact parsing of decimals and of quantities ("31.8 cm",
// "120 rpm"). Independent of JSON and of the use of a quantity.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "engine/number/exact.hpp"
#include "lang/words.hpp"

namespace kinegraph {

/// What a unit measures. Dimensionless is a bare number (a ratio, a component of a direction) and has no unit.
enum class QuantityKind {
    dimensionless,
    length,
    angle,
    angular_velocity,
    angular_acceleration,
    velocity,
    acceleration,
    mass,
    force,
    moment,
    inertia,
    pressure,
    time,
    area,
    force_per_length,     ///< of distributed loads and of springs, N/m
    torsional_stiffness,  ///< N m/rad
    power,                ///< of a force or a couple
    wear,                 ///< volume worn off per unit of (friction work / coefficient): m³/(N m)
};

inline constexpr std::size_t count_of_quantity_kinds = static_cast<std::size_t>(QuantityKind::wear) + 1;

/// "length", "angular velocity": the key in `units`.
Words name_of(QuantityKind kind);
/// "a length", "an angle".
Words with_article(QuantityKind kind);

/// One row of the table: `si` is the unit's size in m, rad, rad/s, rad/s², m/s, m/s², kg, N, N m, kg m², Pa, s, m²,
/// N/m, N m/rad or m²/N.
struct KnownUnit {
    QuantityKind kind = QuantityKind::dimensionless;
    std::string_view symbol;  ///< as printed: "kg m²"
    Exact si;
};

/// All units, kind by kind, the SI unit of each kind (for angles: deg) first.
std::span<const KnownUnit> known_units();
/// The unit of this spelling, or null. `·`, `⋅`, `*` and space are alike, `²` is `^2`, `°` is deg.
const KnownUnit* unit_spelt(std::string_view text);
/// The first unit of a kind, used where a file sets none.
const KnownUnit& default_unit(QuantityKind kind);
/// "m, cm, mm, in, ft".
std::string units_of(QuantityKind kind);
/// `unknown unit "Nm" (did you mean "N m"?); units of moment are N m, …`. If `wanted` is dimensionless, there is no
/// list.
Words unknown_unit_message(std::string_view text, QuantityKind wanted);

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// Length of the number at the text's beginning; an `e` counts only if digits follow ("2 e" has none).
std::size_t number_length(std::string_view text);
/// A decimal as JSON writes it (a leading + is accepted), exactly. Errors, with the reason: not a decimal; more than
/// 1000 digits; a non-zero magnitude so far outside 1e-60 … 1e60 that no unit brings it back. The cost is linear in the
/// text's length, whatever the exponent.
tl::expected<Exact, Words> read_decimal(std::string_view text);

/// The rule of magnitudes: zero, or 1e-60 ≤ |in_si| ≤ 1e60.
bool is_within_range(const Exact& in_si);

/// A quantity as a file writes it.
struct WrittenQuantity {
    Exact value;  ///< in `unit`
    const KnownUnit* unit = nullptr;
    Exact in_si() const { return value * unit->si; }
};

/// Number, optional space, unit. `wanted` is used in messages only: the unit may be of another kind.
tl::expected<WrittenQuantity, Words> read_quantity(std::string_view text, QuantityKind wanted);

/// A user's text as a message may show it: quoted, control characters and invalid UTF-8 escaped, long text cut.
std::string quoted(std::string_view text);
/// An overload for each type; otherwise std::quoted, which standard headers bring in, would be the better match for
/// strings.
inline std::string quoted(const char* text) { return quoted(std::string_view(text)); }
inline std::string quoted(const std::string& text) { return quoted(std::string_view(text)); }
inline std::string quoted(std::string& text) { return quoted(std::string_view(text)); }
/// The same without the quotes; `longest` in bytes.
std::string shown(std::string_view text, std::size_t longest);

/// Edit distance: the number of letters to change, insert, delete or swap with a neighbour. Above `most` the result is
/// only a lower bound.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t most);

}  // namespace kinegraph
