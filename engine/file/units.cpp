#include "engine/file/units.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "engine/number/assert.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/units.hpp"

namespace kinegraph {
namespace {

constexpr std::size_t most_digits = 1000;
constexpr int largest_order = 60;
/// Conversion factors of all units and their inverses are far below 1e10: beyond this margin no unit brings a number
/// back into range.
constexpr std::int64_t order_margin = largest_order + 10;

Exact decimal(std::string_view text) {
    const std::optional<Exact> value = Exact::from_decimal(text);
    KG_ASSERT(value.has_value(), "a number of the unit table is a decimal");
    return *value;
}

/// The factors that units are composed of, in SI.
struct UnitFactors {
    Exact inch = decimal("0.0254");
    Exact foot = decimal("0.3048");
    Exact pound = decimal("0.45359237");
    Exact kilopond = decimal("9.80665");
    Exact pound_force = pound * kilopond;
    Exact degree = pi() / 180;
    Exact turn = pi() * 2;
    Exact turn_a_minute = pi() / 30;
};

std::vector<KnownUnit> units_of_motion(const UnitFactors& in) {
    using enum QuantityKind;
    return {
        {length, "m", 1},
        {length, "cm", Exact::ratio(1, 100)},
        {length, "mm", Exact::ratio(1, 1000)},
        {length, "in", in.inch},
        {length, "ft", in.foot},
        {angle, "deg", in.degree},
        {angle, "rad", 1},
        {angle, "rev", in.turn},
        {angular_velocity, "rad/s", 1},
        {angular_velocity, "rpm", in.turn_a_minute},
        {angular_velocity, "deg/s", in.degree},
        {angular_velocity, "rev/s", in.turn},
        {angular_acceleration, "rad/s²", 1},
        {angular_acceleration, "deg/s²", in.degree},
        {angular_acceleration, "rpm/s", in.turn_a_minute},
        {velocity, "m/s", 1},
        {velocity, "cm/s", Exact::ratio(1, 100)},
        {velocity, "mm/s", Exact::ratio(1, 1000)},
        {velocity, "in/s", in.inch},
        {velocity, "ft/s", in.foot},
        {velocity, "km/h", Exact::ratio(5, 18)},
        {acceleration, "m/s²", 1},
        {acceleration, "cm/s²", Exact::ratio(1, 100)},
        {acceleration, "mm/s²", Exact::ratio(1, 1000)},
        {acceleration, "in/s²", in.inch},
        {acceleration, "ft/s²", in.foot},
    };
}
std::vector<KnownUnit> units_of_forces(const UnitFactors& in) {
    using enum QuantityKind;
    return {
        {mass, "kg", 1},
        {mass, "g", Exact::ratio(1, 1000)},
        {mass, "t", 1000},
        {mass, "lb", in.pound},
        {mass, "oz", in.pound / 16},
        {mass, "slug", in.pound_force / in.foot},
        {mass, "lb s²/in", in.pound_force / in.inch},
        {force, "N", 1},
        {force, "kN", 1000},
        {force, "MN", 1000000},
        {force, "lbf", in.pound_force},
        {force, "kgf", in.kilopond},
        {moment, "N m", 1},
        {moment, "N cm", Exact::ratio(1, 100)},
        {moment, "N mm", Exact::ratio(1, 1000)},
        {moment, "kN m", 1000},
        {moment, "lbf in", in.pound_force * in.inch},
        {moment, "lbf ft", in.pound_force * in.foot},
        {inertia, "kg m²", 1},
        {inertia, "kg cm²", Exact::ratio(1, 10000)},
        {inertia, "kg mm²", Exact::ratio(1, 1000000)},
        {inertia, "lb in s²", in.pound_force * in.inch},
        {inertia, "lb in²", in.pound * in.inch * in.inch},
        {inertia, "lb ft²", in.pound * in.foot * in.foot},
        {inertia, "slug ft²", in.pound_force * in.foot},
    };
}
std::vector<KnownUnit> units_of_contact(const UnitFactors& in) {
    using enum QuantityKind;
    return {
        {pressure, "Pa", 1},
        {pressure, "kPa", 1000},
        {pressure, "MPa", 1000000},
        {pressure, "GPa", 1000000000},
        {pressure, "bar", 100000},
        {pressure, "psi", in.pound_force / (in.inch * in.inch)},
        {area, "m²", 1},
        {area, "cm²", Exact::ratio(1, 10000)},
        {area, "mm²", Exact::ratio(1, 1000000)},
        {area, "in²", in.inch * in.inch},
        {force_per_length, "N/m", 1},
        {force_per_length, "N/cm", 100},
        {force_per_length, "N/mm", 1000},
        {force_per_length, "kN/m", 1000},
        {force_per_length, "lbf/in", in.pound_force / in.inch},
        {force_per_length, "lbf/ft", in.pound_force / in.foot},
        {force_per_length, "kgf/m", in.kilopond},
        {torsional_stiffness, "N m/rad", 1},
        {torsional_stiffness, "N mm/rad", Exact::ratio(1, 1000)},
        {torsional_stiffness, "N m/deg", Exact(1) / in.degree},
        {torsional_stiffness, "N mm/deg", Exact::ratio(1, 1000) / in.degree},
        {torsional_stiffness, "lbf in/rad", in.pound_force * in.inch},
        {torsional_stiffness, "lbf ft/rad", in.pound_force * in.foot},
        {time, "s", 1},
        {time, "ms", Exact::ratio(1, 1000)},
        {time, "min", 60},
        {time, "h", 3600},
        {power, "W", 1},
        {power, "kW", 1000},
        {wear, "m²/N", 1},
        {wear, "mm²/N", Exact::ratio(1, 1000000)},
        {wear, "mm³/(N m)", Exact::ratio(1, 1000000000)},
    };
}

std::vector<KnownUnit> make_units() {
    const UnitFactors in;
    std::vector<KnownUnit> all;
    for (const auto units : {units_of_motion, units_of_forces, units_of_contact})
        for (KnownUnit& unit : units(in)) all.push_back(std::move(unit));
    return all;
}

/// The normal form of equivalent spellings: products by one space, squares as ^2, degrees as deg.
std::string normal_spelling(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> alike{
        {{"·", " "}, {"⋅", " "}, {"*", " "}, {"²", "^2"}, {"°", "deg"}}};
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        const auto* found = std::find_if(alike.begin(), alike.end(),
                                         [&](const auto& a) { return text.substr(at).starts_with(a.first); });
        const std::string_view put = found == alike.end() ? text.substr(at, 1) : found->second;
        at += found == alike.end() ? 1 : found->first.size();
        if (put == " " && (plain.empty() || plain.back() == ' ')) continue;
        plain += put;
    }
    if (plain.ends_with(' ')) plain.pop_back();
    return plain;
}

/// For "did you mean": ignores signs that are often omitted, and case.
std::string careless_spelling(std::string_view text) {
    std::string word;
    for (const char c : normal_spelling(text)) {
        if (c != ' ' && c != '^') word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return word;
}

const KnownUnit* unit_meant(std::string_view text, QuantityKind wanted) {
    constexpr std::size_t longest_unit = 16;
    if (text.size() > longest_unit) return nullptr;
    const std::string word = careless_spelling(text);
    const KnownUnit* nearest = nullptr;
    for (const KnownUnit& unit : known_units()) {
        const std::string other = careless_spelling(unit.symbol);
        const bool near = other == word || (other.size() > 2 && edit_distance(other, word, 1) <= 1);
        if (near && (nearest == nullptr || (unit.kind == wanted && nearest->kind != wanted))) nearest = &unit;
    }
    return nearest;
}

/// A decimal number as written: value = ± 0.d₁d₂d₃… · 10^order.
struct WrittenDecimal {
    bool negative = false;
    std::string digits;      ///< without leading zeros; at most 1001 of them
    std::size_t places = 0;  ///< number of digits, including leading zeros
    std::int64_t order = 0;
};

class DecimalScanner {
public:
    explicit DecimalScanner(std::string_view text) : text_(text) {}

    /// Empty where the text is no decimal number.
    std::optional<WrittenDecimal> scanned() {
        found_.negative = comes("-");
        if (found_.negative || comes("+")) ++at_;
        if (!scan_integer()) return std::nullopt;
        if (comes(".") && !scan_fraction()) return std::nullopt;
        if (comes("eE") && !scan_exponent()) return std::nullopt;
        if (at_ != text_.size()) return std::nullopt;
        return std::move(found_);
    }

private:
    bool comes(std::string_view one_of) const {
        return at_ < text_.size() && one_of.find(text_[at_]) != std::string_view::npos;
    }
    bool comes_digit() const { return at_ < text_.size() && is_digit(text_[at_]); }
    void keep_digit() {
        if (found_.digits.size() <= most_digits) found_.digits += text_[at_];
    }

    bool scan_integer() {
        const std::size_t first = at_;
        for (; comes_digit(); ++at_, ++found_.places) {
            if (text_[at_] == '0' && found_.digits.empty()) continue;
            keep_digit();
            ++found_.order;
        }
        return at_ != first;
    }
    bool scan_fraction() {
        const std::size_t first = ++at_;
        for (; comes_digit(); ++at_, ++found_.places) {
            if (text_[at_] == '0' && found_.digits.empty())
                --found_.order;
            else
                keep_digit();
        }
        return at_ != first;
    }
    bool scan_exponent() {
        ++at_;
        const bool down = comes("-");
        if (comes("-+")) ++at_;
        const std::size_t first = at_;
        constexpr std::int64_t enough = 1'000'000'000'000;  // no text is long enough to compensate for it
        std::int64_t exponent = 0;
        for (; comes_digit(); ++at_) exponent = std::min(enough, exponent * 10 + (text_[at_] - '0'));
        found_.order += down ? -exponent : exponent;
        return at_ != first;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    WrittenDecimal found_;
};

}  // namespace

Words name_of(QuantityKind kind) {
    switch (kind) {
        case QuantityKind::dimensionless: return {lang::units::bare_number};
        case QuantityKind::length: return {lang::units::length};
        case QuantityKind::angle: return {lang::units::angle};
        case QuantityKind::angular_velocity: return {lang::units::angular_velocity};
        case QuantityKind::angular_acceleration: return {lang::units::angular_acceleration};
        case QuantityKind::velocity: return {lang::units::velocity};
        case QuantityKind::acceleration: return {lang::units::acceleration};
        case QuantityKind::mass: return {lang::units::mass};
        case QuantityKind::force: return {lang::units::force};
        case QuantityKind::moment: return {lang::units::moment};
        case QuantityKind::inertia: return {lang::units::moment_of_inertia};
        case QuantityKind::pressure: return {lang::units::pressure};
        case QuantityKind::time: return {lang::units::time};
        case QuantityKind::area: return {lang::units::area};
        case QuantityKind::force_per_length: return {lang::units::force_per_length};
        case QuantityKind::torsional_stiffness: return {lang::units::torsional_stiffness};
        case QuantityKind::power: return {lang::units::power};
        case QuantityKind::wear: return {lang::units::coefficient_of_wear};
    }
    KG_ASSERT(false, "every kind has a name");
}

Words with_article(QuantityKind kind) {
    switch (kind) {
        case QuantityKind::dimensionless: return lang::common::a_bare_number;
        case QuantityKind::length: return lang::common::a_length;
        case QuantityKind::angle: return lang::units::an_angle;
        case QuantityKind::angular_velocity: return lang::units::an_angular_velocity;
        case QuantityKind::angular_acceleration: return lang::units::an_angular_acceleration;
        case QuantityKind::velocity: return lang::units::a_velocity;
        case QuantityKind::acceleration: return lang::units::an_acceleration;
        case QuantityKind::mass: return lang::common::a_mass;
        case QuantityKind::force: return lang::common::a_force;
        case QuantityKind::moment: return lang::units::a_moment;
        case QuantityKind::inertia: return lang::common::a_moment_of_inertia;
        case QuantityKind::pressure: return lang::units::a_pressure;
        case QuantityKind::time: return lang::units::a_time;
        case QuantityKind::area: return lang::common::an_area;
        case QuantityKind::force_per_length: return lang::units::a_force_per_length;
        case QuantityKind::torsional_stiffness: return lang::units::a_torsional_stiffness;
        case QuantityKind::power: return lang::units::a_power;
        case QuantityKind::wear: return lang::units::a_coefficient_of_wear;
    }
    KG_ASSERT(false, "every kind has a name");
}

std::span<const KnownUnit> known_units() {
    static const std::vector<KnownUnit> units = make_units();
    return units;
}

const KnownUnit* unit_spelt(std::string_view text) {
    static const std::unordered_map<std::string, const KnownUnit*> by_spelling = [] {
        std::unordered_map<std::string, const KnownUnit*> spellings;
        for (const KnownUnit& unit : known_units()) spellings.emplace(normal_spelling(unit.symbol), &unit);
        return spellings;
    }();
    constexpr std::size_t longest_spelling = 64;
    if (text.size() > longest_spelling) return nullptr;
    const auto found = by_spelling.find(normal_spelling(text));
    return found == by_spelling.end() ? nullptr : found->second;
}

const KnownUnit& default_unit(QuantityKind kind) {
    static const KnownUnit bare{QuantityKind::dimensionless, "", 1};
    if (kind == QuantityKind::dimensionless) return bare;
    const auto units = known_units();
    const auto found =
        std::find_if(units.begin(), units.end(), [&](const KnownUnit& unit) { return unit.kind == kind; });
    KG_ASSERT(found != units.end(), "every kind that has units has a first one");
    return *found;
}

std::string units_of(QuantityKind kind) {
    std::string list;
    for (const KnownUnit& unit : known_units()) {
        if (unit.kind != kind) continue;
        if (!list.empty()) list += ", ";
        list += unit.symbol;
    }
    return list;
}

Words unknown_unit_message(std::string_view text, QuantityKind wanted) {
    Words message(lang::units::unknown_unit, quoted(text));
    if (const KnownUnit* meant = unit_meant(text, wanted)) message += Words(lang::units::did_you_mean, meant->symbol);
    if (wanted != QuantityKind::dimensionless)
        message += Words(lang::units::the_units, name_of(wanted), units_of(wanted));
    return message;
}

std::size_t number_length(std::string_view text) {
    std::size_t at = 0;
    const auto digits = [&](std::size_t i) {
        while (i < text.size() && is_digit(text[i])) ++i;
        return i;
    };
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
    at = digits(at);
    if (at < text.size() && text[at] == '.') at = digits(at + 1);
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        std::size_t exponent = at + 1;
        if (exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+')) ++exponent;
        const std::size_t end = digits(exponent);
        if (end > exponent) at = end;
    }
    return at;
}

tl::expected<Exact, Words> read_decimal(std::string_view text) {
    const std::optional<WrittenDecimal> written = DecimalScanner(text).scanned();
    if (!written) return tl::make_unexpected(Words(lang::units::is_no_decimal_number, quoted(text)));
    if (written->places > most_digits)
        return tl::make_unexpected(Words(lang::units::a_number_of_digits_1000, std::to_string(written->places)));
    if (written->digits.empty()) return Exact();
    if (written->order > order_margin || written->order < -order_margin)
        return tl::make_unexpected(Words(lang::common::is_out_of_range, shown(text, 40)));
    // Normalised with the point behind the first digit, so that the exponent is small.
    std::string normal = written->negative ? "-" : "";
    normal += written->digits[0];
    normal += '.' + written->digits.substr(1) + 'e' + std::to_string(written->order - 1);
    const std::optional<Exact> value = Exact::from_decimal(normal);
    KG_ASSERT(value.has_value(), "a number that was checked is a decimal");
    return *value;
}

bool is_within_range(const Exact& in_si) {
    static const Exact largest = decimal("1e60");
    static const Exact smallest = decimal("1e-60");
    if (in_si.is_zero()) return true;
    // Most numbers are far from the limits; counting bits suffices for these.
    constexpr std::size_t surely_within = 190;
    if (in_si.bits() < surely_within) return true;
    const Exact magnitude = abs(in_si);
    return smallest <= magnitude && magnitude <= largest;
}

namespace {

/// Numbers joined by signs of arithmetic, as "1/3" or "2*(3 + 4)": a formula whose "=" was forgotten.
bool is_arithmetic(std::string_view text) {
    const auto first = std::find_if(text.begin() + 1, text.end(),
                                    [](char c) { return std::string_view("+-*/^").find(c) != std::string_view::npos; });
    return text.find_first_not_of("0123456789.+-*/^() ") == std::string_view::npos && first != text.end() &&
           std::any_of(first, text.end(), is_digit);
}

}  // namespace

tl::expected<WrittenQuantity, Words> read_quantity(std::string_view text, QuantityKind wanted) {
    const std::size_t length = number_length(text);
    const std::string_view number = text.substr(0, length);
    const Words example =
        wanted == QuantityKind::dimensionless ? Words() : Words(lang::units::such_as_2, default_unit(wanted).symbol);
    if (number.find_first_of("0123456789") == std::string_view::npos) {
        const bool typographic_minus = text.starts_with("−") || text.starts_with("–");
        return tl::make_unexpected(Words(lang::units::is_no_quantity, quoted(text),
                                         typographic_minus ? Words(lang::units::a_minus_is_written)
                                                           : Words(lang::units::write_a_number_and_its_unit, example)));
    }
    auto value = read_decimal(number);
    if (!value) return tl::make_unexpected(value.error());
    std::string_view unit = text.substr(length);
    while (unit.starts_with(' ')) unit.remove_prefix(1);
    while (unit.ends_with(' ')) unit.remove_suffix(1);
    if (unit.empty()) return tl::make_unexpected(Words(lang::units::has_no_unit_add, quoted(text), example));
    const KnownUnit* known = unit_spelt(unit);
    if (known == nullptr && is_arithmetic(text))
        return tl::make_unexpected(Words(lang::units::is_no_number_a_formula_begins, quoted(text), shown(text, 60)));
    if (known == nullptr) return tl::make_unexpected(unknown_unit_message(unit, wanted));
    return WrittenQuantity{std::move(*value), known};
}

std::string shown(std::string_view text, std::size_t longest) {
    constexpr std::string_view hex = "0123456789abcdef";
    std::string out;
    const auto spell_out = [&](unsigned code) {
        out += "\\u00";
        out += hex[(code >> 4U) & 0xFU];
        out += hex[code & 0xFU];
    };
    for (std::size_t at = 0; at < text.size();) {
        const auto byte = static_cast<std::uint8_t>(text[at]);
        const std::size_t size = byte < 0x80 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
        const auto continues = [](char c) { return (static_cast<std::uint8_t>(c) & 0xC0U) == 0x80U; };
        const std::string_view rest = text.substr(at + 1, size - 1);
        const bool whole = size == 1 || (byte >= 0xC2 && byte <= 0xF4 && rest.size() == size - 1 &&
                                         std::all_of(rest.begin(), rest.end(), continues));
        if (out.size() + (whole ? size : 1) > longest) return out + "…";
        if (!whole) {
            out += "\\x";
            out += hex[byte >> 4U];
            out += hex[byte & 0xFU];
            ++at;
            continue;
        }
        const unsigned c1 = size == 2 && byte == 0xC2 ? static_cast<std::uint8_t>(text[at + 1]) : 0;
        if (byte < 0x20 || byte == 0x7F) {
            spell_out(byte);
        } else if (c1 >= 0x80 && c1 < 0xA0) {
            spell_out(c1);
        } else {
            out += text.substr(at, size);
        }
        at += size;
    }
    return out;
}

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 60;
    return '"' + shown(text, longest) + '"';
}

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t most) {
    if (a.size() > b.size()) std::swap(a, b);
    if (b.size() - a.size() > most) return most + 1;
    std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        std::size_t least = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
            least = std::min(least, row[j]);
        }
        if (least > most) return most + 1;
        std::swap(before, above);
        std::swap(above, row);
    }
    return above[b.size()];
}

}  // namespace kinegraph
