// Formulas: value and dimension of each node of the tree, from left to right.
#include "engine/file/formula.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/file/error.hpp"
#include "engine/file/formula_syntax.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/expressions.hpp"

namespace kinegraph {
namespace {

using Evaluated = tl::expected<Measured, Words>;

/// Precision of results.
constexpr int kept_bits = 200;
/// Internal precision. It is three times as large, so that a difference of two equal roots shrinks to the internal
/// error, while any other difference stays far above it.
constexpr int working_bits = 600;
/// A longer number is rounded to twice the working precision; otherwise a power of a power would grow without benefit.
constexpr std::size_t bits_before_rounding = 4096;
constexpr int guard_bits = 60;

const Exact& degree() {
    static const Exact size = pi() / 180;
    return size;
}

Exact exact_power(const Exact& base, int exponent) {
    Exact result = 1;
    for (int i = 0; i < std::abs(exponent); ++i) result *= base;
    return exponent < 0 ? 1 / result : result;
}

/// ⌊log₂ |value|⌋ or one more; value ≠ 0.
int order_of(const Exact& value) {
    const auto bits = [](const mpz_class& whole) { return static_cast<int>(mpz_sizeinbase(whole.get_mpz_t(), 2)); };
    return bits(value.rational().get_num()) - bits(value.rational().get_den());
}

/// Rounded to this number of bits relative to its size.
Exact rounded_to_size(const Exact& value, int bits) {
    return value.is_zero() ? value : rounded(value, bits - order_of(value));
}

// ----- dimensions

struct DimensionOfKind {
    QuantityKind kind;
    Dimension dimension;
    bool is_named = true;  ///< messages name the kind, not its unit
};
constexpr auto dimensions_of_kinds = std::to_array<DimensionOfKind>({
    {QuantityKind::dimensionless, {}},
    {QuantityKind::length, {.length = 1}},
    {QuantityKind::angle, {.angle = 1}},
    {QuantityKind::angular_velocity, {.time = -1, .angle = 1}},
    {QuantityKind::angular_acceleration, {.time = -2, .angle = 1}},
    {QuantityKind::velocity, {.length = 1, .time = -1}},
    {QuantityKind::acceleration, {.length = 1, .time = -2}},
    {QuantityKind::mass, {.mass = 1}},
    {QuantityKind::force, {.length = 1, .mass = 1, .time = -2}},
    {QuantityKind::moment, {.length = 2, .mass = 1, .time = -2}},
    {QuantityKind::inertia, {.length = 2, .mass = 1}},
    {QuantityKind::pressure, {.length = -1, .mass = 1, .time = -2}, false},
    {QuantityKind::time, {.time = 1}, false},
    {QuantityKind::area, {.length = 2}, false},
    {QuantityKind::force_per_length, {.mass = 1, .time = -2}, false},
    {QuantityKind::torsional_stiffness, {.length = 2, .mass = 1, .time = -2, .angle = -1}, false},
    {QuantityKind::power, {.length = 2, .mass = 1, .time = -3}},
    {QuantityKind::wear, {.length = 1, .mass = -1, .time = 2}, false},
});
bool same_but_for_angle(const Dimension& a, const Dimension& b) {
    return a.length == b.length && a.mass == b.mass && a.time == b.time;
}

void scale(Measured& of, const Exact& factor) {
    of.value *= factor;
    of.error *= abs(factor);
}

/// The value of a result.
Exact handed_on(const Measured& of) { return of.is_approximate ? rounded_to_size(of.value, kept_bits) : of.value; }

// ----- functions

/// A value with an error bound.
struct Bounded {
    Exact value, error;
    bool is_zero() const { return abs(value) <= error; }
};

/// Error bound of a quotient: |A/B − a/b| ≤ (δa + |a/b| δb)/(|b| − δb).
Bounded quotient(const Bounded& a, const Bounded& b) {
    Exact value = a.value / b.value;
    if (a.error.is_zero() && b.error.is_zero()) return {std::move(value), {}};
    Exact error = (a.error + abs(value) * b.error) / (abs(b.value) - b.error);
    return {std::move(value), std::move(error)};
}

/// The root of order `order` of a value ≥ 0, to `working_bits` of its size at least.
Bounded root_of(const Exact& value, unsigned order) {
    if (value.is_zero()) return {};
    mpz_class top, bottom;
    const bool exact = mpz_root(top.get_mpz_t(), value.rational().get_num_mpz_t(), order) != 0 &&
                       mpz_root(bottom.get_mpz_t(), value.rational().get_den_mpz_t(), order) != 0;
    if (exact) return {Exact(mpq_class(top, bottom)), {}};
    // ⌊(value · 2^(order · shift))^(1/order)⌋ / 2^shift
    const int shift = working_bits + guard_bits + std::abs(order_of(value));
    mpz_class scaled = value.rational().get_num();
    mpz_mul_2exp(scaled.get_mpz_t(), scaled.get_mpz_t(), static_cast<mp_bitcnt_t>(shift) * order);
    scaled /= value.rational().get_den();
    mpz_root(scaled.get_mpz_t(), scaled.get_mpz_t(), order);
    return {Exact(mpq_class(scaled)) * Exact::power_of_two(-shift), Exact::power_of_two(-shift)};
}

/// Sine and cosine of an angle in degrees; rounded to a grid of 2^-600 that contains 0, ±1/2 and ±1, so that these are
/// exact.
std::pair<Exact, Exact> sine_and_cosine(const Exact& degrees) {
    const Exact turns = degrees / 360;
    const Exact whole(mpq_class(mpz_class(turns.rational().get_num() / turns.rational().get_den())));
    Exact rest = turns - whole;  // in (-1, 1)
    if (rest.sign() < 0) rest += 1;
    const Exact quarters = 4 * rest;
    const int quarter =
        static_cast<int>(mpz_class(quarters.rational().get_num() / quarters.rational().get_den()).get_si());
    const Exact within = quarters - quarter;  // of a right angle, in [0, 1)
    const Exact t = tangent_in_first_octant(within / 4, working_bits + guard_bits);
    const Exact down = 1 + square(t);
    const Exact sine = rounded(2 * t / down, working_bits);
    const Exact cosine = rounded((1 - square(t)) / down, working_bits);
    switch (quarter) {
        case 0: return {sine, cosine};
        case 1: return {cosine, -sine};
        case 2: return {-sine, -cosine};
        default: return {-cosine, sine};
    }
}

// ----- the grammar

constexpr std::array<std::string_view, 9> words_of_formulas{"sqrt", "sin", "cos", "tan", "atan2",
                                                            "abs",  "min", "max", "pi"};

bool is_function(std::string_view name) {
    return name != "pi" &&
           std::find(words_of_formulas.begin(), words_of_formulas.end(), name) != words_of_formulas.end();
}

class Evaluation {
public:
    Evaluation(std::string_view text, const LookUp& look_up) : text_(text), look_up_(look_up) {}

    Evaluated whole() const {
        // "12 cm^2" is the square of 12 cm, for compatibility; "12 cm²" is an area. "10 N/m" is a force divided by the
        // parameter m, if there is one.
        const auto is_unit = [&](std::string_view spelt) {
            const QuantityKind kind = unit_spelt(spelt)->kind;
            if (kind == QuantityKind::area) return spelt.find('^') == std::string_view::npos;
            return kind != QuantityKind::force_per_length || !look_up_(spelt.substr(spelt.find('/') + 1));
        };
        return of(read_syntax(text_, {.text = SyntaxOf::formula, .is_unit = is_unit}));
    }

private:
    Evaluated of(const Syntax& node) const {
        switch (node.kind) {
            case Syntax::Kind::number: return measured(node);
            case Syntax::Kind::name: return name(node.text);
            case Syntax::Kind::function: return function(node);
            case Syntax::Kind::fault: break;
            case Syntax::Kind::sum:
            case Syntax::Kind::product:
            case Syntax::Kind::power:
            case Syntax::Kind::negative: return operation(node);
        }
        for (const Syntax& part : node.parts)
            if (Evaluated value = of(part); !value) return value;
        return refused(why(node));
    }
    Evaluated operation(const Syntax& node) const {
        Evaluated result = of(node.parts[0]);
        if (result && node.kind == Syntax::Kind::negative) result->value = -result->value;
        for (std::size_t i = 1; i < node.parts.size() && result; ++i) {
            Evaluated other = of(node.parts[i]);
            if (!other) return other;
            const bool is_inverse = node.parts[i].is_inverse;
            result = node.kind == Syntax::Kind::sum     ? added(*std::move(result), *other, !is_inverse)
                     : node.kind == Syntax::Kind::power ? raised(*result, *other)
                     : is_inverse                       ? divided(*std::move(result), *other)
                                                        : multiplied(*std::move(result), *other);
        }
        return result;
    }
    Evaluated name(std::string_view name) const {
        if (is_function(name)) return refused({lang::expressions::is_a_function_write, name});
        if (name != "pi") return look_up_(name);
        Measured result = bare(pi());
        result.is_in_radians = true;
        return result;
    }

    // ----- faults of syntax

    Words why(const Syntax& fault) const {
        if (fault.fault == Syntax::Fault::behind_number) {
            const std::string_view word = fault.text.substr(0, word_length(fault.text));
            if (means_something(word)) return product_wanted(fault.parts[0].text, word);
            return unknown_unit_message(word, QuantityKind::dimensionless);
        }
        return fault.fault == Syntax::Fault::behind_value ? factor_without_sign(fault.text)
                                                          : words_of(fault, SyntaxOf::formula);
    }
    /// The message for a unit, a name or a bracket directly after a value: how to write the product.
    Words factor_without_sign(std::string_view rest) const {
        const std::string_view unit = rest.substr(0, unit_length(rest, {}));
        if (!unit.empty() && !means_something(unit))
            return {lang::expressions::a_unit_stands_behind_a_number, std::string(unit)};
        const std::string_view word = rest.substr(0, word_length(rest));
        if (means_something(word)) return product_wanted("…", word);
        if (rest.starts_with('(')) return product_wanted("…", "(");
        return {lang::expressions::is_not_understood_here_brackets_numbers, quoted(rest)};
    }
    /// Whether a word is valid as a factor in a formula.
    bool means_something(std::string_view word) const {
        return !word.empty() && (word == "pi" || is_function(word) || look_up_(word).has_value());
    }
    static Words product_wanted(std::string_view first, std::string_view second) {
        return {lang::expressions::a_product_is_written_with_not, std::string(first), std::string(second)};
    }

    Evaluated function(const Syntax& node) const {
        const std::string_view name = node.text;
        if (!is_function(name)) {
            if (Evaluated value = this->name(name); !value) return value;
            return refused(product_wanted("…", "("));
        }
        std::vector<Measured> arguments;
        for (const Syntax& part : node.parts) {
            Evaluated argument = of(part);
            if (!argument) return argument;
            arguments.push_back(*std::move(argument));
        }
        const bool any_number = name == "min" || name == "max";
        const std::size_t wanted = name == "atan2" ? 2 : 1;
        if (!any_number && arguments.size() != wanted)
            return refused({lang::expressions::is_written_with_between_the_brackets, name,
                            std::string(name == "atan2" ? "atan2(y, x)" : std::string(name) + "(x)"),
                            wanted == 1 ? Words(lang::expressions::one_value) : Words(lang::expressions::two_values)});
        if (any_number) return extreme(name == "min", std::move(arguments));
        if (name == "atan2") return arc(arguments[0], arguments[1]);
        if (name == "abs") {
            arguments[0].value = abs(arguments[0].value);
            return arguments[0];
        }
        if (name == "sqrt") return root(arguments[0], 2);
        return circular(name, arguments[0]);
    }

    // ----- operations

    Evaluated settled(Measured result) const {
        if (result.error.sign() > 0) heed_error(result);
        if (!result.value.is_zero() && std::abs(order_of(result.value)) > 1000)
            return refused({lang::expressions::a_value_of_the_formula_lies});
        if (result.value.bits() > bits_before_rounding) {
            const int places = 2 * working_bits - order_of(result.value);
            result.value = rounded(result.value, places);
            result.error = result.error + Exact::power_of_two(-places);
            result.is_approximate = true;
        }
        return result;
    }
    /// A value within its error of zero becomes zero; digits far below the error are removed.
    static void heed_error(Measured& of) {
        if (abs(of.value) <= of.error) {
            of.value = of.error = {};
            return;
        }
        constexpr int digits_of_error = 30;
        const int places = digits_of_error - order_of(of.error);
        const Exact step = Exact::power_of_two(-places);
        of.value = rounded(of.value, places);
        of.error = rounded(of.error, places) + 2 * step;
    }
    static void join(Measured& result, const Measured& other) {
        result.is_in_radians = (result.is_in_radians || other.is_in_radians) && result.is_bare && other.is_bare;
        result.is_bare = result.is_bare && other.is_bare;
        result.is_approximate = result.is_approximate || other.is_approximate;
    }
    /// Converts both to one dimension if they are of the same kind.
    static std::optional<Words> match(Measured& a, Measured& b) {
        const auto turn = [](Measured& number, const Measured& angle) {
            if (!number.is_in_radians || angle.dimension != Dimension{.angle = 1}) return;
            scale(number, 1 / degree());
            number.dimension.angle = 1;
        };
        turn(a, b);
        turn(b, a);
        if (a.dimension == b.dimension) return std::nullopt;
        if (same_but_for_angle(a.dimension, b.dimension) && !same_but_for_angle(a.dimension, Dimension{})) {
            a = in_radians(std::move(a));
            b = in_radians(std::move(b));
            return std::nullopt;
        }
        return Words(lang::common::do_not_go_together, described(a), described(b));
    }
    Evaluated added(Measured a, Measured b, bool plus) const {
        if (auto why = match(a, b)) {
            Words message(plus ? lang::expressions::in_a_sum : lang::expressions::in_a_difference, *why);
            const bool lacks_unit = a.is_bare != b.is_bare;
            if (lacks_unit) message += Words(lang::expressions::the_bare_number_wants_a_unit);
            return refused(std::move(message));
        }
        a.value = plus ? a.value + b.value : a.value - b.value;
        a.error += b.error;
        join(a, b);
        return settled(std::move(a));
    }
    Evaluated multiplied(Measured a, const Measured& b) const {
        if (a.is_approximate || b.is_approximate) a.error = abs(a.value) * b.error + (abs(b.value) + b.error) * a.error;
        a.value *= b.value;
        a.dimension = a.dimension * b.dimension;
        join(a, b);
        return within_reason(std::move(a));
    }
    Evaluated divided(Measured a, const Measured& b) const {
        if (b.value.is_zero()) return refused({lang::expressions::the_formula_divides_by_zero});
        auto [value, error] = quotient({a.value, a.error}, {b.value, b.error});
        a.value = std::move(value);
        a.error = std::move(error);
        a.dimension = a.dimension / b.dimension;
        join(a, b);
        return within_reason(std::move(a));
    }
    Evaluated within_reason(Measured result) const {
        constexpr int highest = 1000;
        const Dimension& d = result.dimension;
        for (const int exponent : {d.length, d.mass, d.time, d.angle})
            if (std::abs(exponent) > highest)
                return refused({lang::expressions::a_power_of_a_unit_beyond, std::to_string(highest)});
        return settled(std::move(result));
    }
    Evaluated raised(const Measured& base, const Measured& exponent) const {
        constexpr int highest = 1000, finest = 60;
        if (!exponent.dimension.is_a_number())
            return refused({lang::expressions::an_exponent_must_be_a_bare_number, described(exponent)});
        const Exact number = handed_on(exponent);
        const mpq_class& power = number.rational();
        if (abs(number) > Exact(highest) || power.get_den() > finest)
            return refused({lang::expressions::an_exponent_must_be_a_fraction_up, std::to_string(highest),
                            std::to_string(finest)});
        const long whole = power.get_num().get_si();
        Evaluated result = root(base, static_cast<unsigned>(power.get_den().get_ui()));
        if (!result) return result;
        if (whole < 0 && result->value.is_zero()) return refused({lang::expressions::the_formula_divides_by_zero});
        const Measured one = *result;
        Measured product = bare(Exact(1));
        product.is_bare = one.is_bare;
        Evaluated grown = product;
        for (long i = 0; i < std::abs(whole) && grown; ++i)
            grown = whole > 0 ? multiplied(*grown, one) : divided(*grown, one);
        if (grown) join(*grown, exponent.is_bare ? bare(Exact(1)) : one);
        return grown;
    }
    Evaluated root(Measured of, unsigned order) const {
        if (order == 1) return of;
        if (of.value.sign() < 0) return refused({lang::expressions::the_root_of_a_negative_value});
        const int n = static_cast<int>(order);
        if (of.dimension.angle % n != 0) of = in_radians(std::move(of));
        const auto dimension = power_of(of.dimension, 1, n);
        if (!dimension) return refused({lang::expressions::no_quantity_is_the_root, described(of)});
        of.dimension = *dimension;
        // The relative error of a root is at most that of its radicand.
        auto [value, error] = root_of(of.value, order);
        of.is_approximate = of.is_approximate || !error.is_zero();
        if (!of.error.is_zero()) error += value * of.error / of.value;
        of.value = std::move(value);
        of.error = std::move(error);
        return settled(std::move(of));
    }
    Evaluated circular(std::string_view name, Measured angle) const {
        if (angle.dimension.is_a_number()) {
            scale(angle, 1 / degree());  // a bare number is in radians, as usual in mathematics
        } else if (angle.dimension != Dimension{.angle = 1}) {
            return refused({lang::expressions::is_taken_of_an_angle_not, name, described(angle)});
        }
        const auto [sine, cosine] = sine_and_cosine(angle.value);
        // The derivative per degree is less than 1/32; 0, ±1/2 and ±1 are exact where the angle is.
        const auto bounded = [&](const Exact& value) -> Bounded {
            const bool on_grid = value.is_zero() || abs(value) == Exact(1) || abs(value) == Exact::ratio(1, 2);
            if (angle.error.is_zero() && on_grid) return {value, {}};
            return {value, angle.error * Exact::ratio(1, 32) + Exact::power_of_two(-working_bits)};
        };
        Measured result = bare({});
        result.is_bare = angle.is_bare;
        Bounded found = bounded(name == "cos" ? cosine : sine);
        if (name == "tan") {
            const Bounded below = bounded(cosine);
            if (below.is_zero()) return refused({lang::expressions::tan_of_a_right_angle});
            // Where |sine| = |cosine| the tangent is ±1, exactly if the angle is exact.
            const bool is_diagonal = angle.error.is_zero() && abs(sine) == abs(cosine);
            found = is_diagonal ? Bounded{sine / cosine, {}} : quotient(found, below);
        }
        result.is_approximate = angle.is_approximate || !found.error.is_zero();
        result.value = std::move(found.value);
        result.error = std::move(found.error);
        return settled(std::move(result));
    }
    Evaluated arc(Measured y, Measured x) const {
        if (const auto why = match(y, x)) return refused({lang::expressions::in_atan2_y_x, *why});
        if (x.value.is_zero() && y.value.is_zero()) return refused({lang::expressions::atan2_0_0_has_no_value});
        join(y, x);
        const bool exact = x.value.is_zero() || y.value.is_zero() || abs(x.value) == abs(y.value);
        // An error δ of a vector's tip changes its direction by at most π/2 · δ/|vector|.
        Exact error = 90 * (y.error + x.error) / std::max(abs(x.value), abs(y.value));
        if (!exact) error += Exact::power_of_two(-working_bits);
        return settled({.value = degrees_of(y.value, x.value, working_bits),
                        .error = std::move(error),
                        .dimension = {.angle = 1},
                        .is_approximate = y.is_approximate || !exact});
    }
    Evaluated extreme(bool least, std::vector<Measured> of) const {
        Measured best = std::move(of.front());
        for (std::size_t i = 1; i < of.size(); ++i) {
            if (auto why = match(best, of[i]))
                return refused({lang::expressions::kind_in_unit, *why, std::string(least ? "min" : "max")});
            const bool better = least ? of[i].value < best.value : of[i].value > best.value;
            join(best, of[i]);
            if (!better) continue;
            best.value = of[i].value;
            best.error = of[i].error;
        }
        return best;
    }

    std::string_view text_;
    const LookUp& look_up_;
};

}  // namespace

std::optional<Dimension> power_of(const Dimension& dimension, long top, long below) {
    Dimension power;
    for (int Dimension::*const each : {&Dimension::length, &Dimension::mass, &Dimension::time, &Dimension::angle}) {
        const long exponent = dimension.*each * top;
        if (exponent % below != 0) return std::nullopt;
        power.*each = static_cast<int>(exponent / below);
    }
    return power;
}

Dimension dimension_of(QuantityKind kind) {
    const auto* const row = std::find_if(dimensions_of_kinds.begin(), dimensions_of_kinds.end(),
                                         [&](const DimensionOfKind& each) { return each.kind == kind; });
    KG_ASSERT(row != dimensions_of_kinds.end(), "every kind has a dimension");
    return row->dimension;
}

std::optional<QuantityKind> kind_of(const Dimension& dimension) {
    const auto with = [](const Dimension& wanted) {
        return std::find_if(dimensions_of_kinds.begin(), dimensions_of_kinds.end(),
                            [&](const DimensionOfKind& each) { return each.dimension == wanted; });
    };
    const auto* row = with(dimension);
    Dimension without_angle = dimension;
    without_angle.angle = 0;
    if (row == dimensions_of_kinds.end() && !without_angle.is_a_number()) row = with(without_angle);
    if (row == dimensions_of_kinds.end()) return std::nullopt;
    return row->kind;
}

std::string base_units(const Dimension& dimension) {
    std::string above, below;
    const auto put = [&](std::string_view symbol, int exponent) {
        if (exponent == 0) return;
        std::string& side = exponent > 0 ? above : below;
        if (!side.empty()) side += ' ';
        side += symbol;
        if (std::abs(exponent) > 1) side += '^' + std::to_string(std::abs(exponent));
    };
    put("kg", dimension.mass);
    put("m", dimension.length);
    put("rad", dimension.angle);
    put("s", dimension.time);
    if (above.empty()) above = "1";
    return below.empty() ? above : above + '/' + below;
}

Words described(const Dimension& dimension) {
    for (const DimensionOfKind& each : dimensions_of_kinds)
        if (each.is_named && each.dimension == dimension) return with_article(each.kind);
    return {lang::expressions::a_quantity, base_units(dimension)};
}

bool is_formula(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first != std::string_view::npos && text[first] == '=';
}

tl::expected<Measured, Words> evaluate(std::string_view formula, const LookUp& look_up) {
    KG_ASSERT(is_formula(formula), "a formula begins with =");
    return Evaluation(formula.substr(formula.find('=') + 1), look_up).whole();
}

tl::expected<Measured, Words> read_measured(std::string_view text, const LookUp& look_up) {
    if (is_formula(text)) return evaluate(text, look_up);
    if (auto number = read_decimal(text)) return bare(std::move(*number));
    auto written = read_quantity(text, QuantityKind::dimensionless);
    if (!written) return refused(std::move(written.error()));
    return measured(*written);
}

tl::expected<Measured, Words> measured(const Syntax& number) {
    auto value = read_decimal(number.text);
    if (!value) return refused(std::move(value.error()));
    if (number.unit == nullptr) return bare(*std::move(value));
    return measured(WrittenQuantity{*std::move(value), number.unit});
}
Measured measured(const WrittenQuantity& written) {
    const Dimension dimension = dimension_of(written.unit->kind);
    Exact value = written.value * (written.unit->si / exact_power(degree(), dimension.angle));
    return {.value = std::move(value), .dimension = dimension};
}

Measured in_radians(Measured of) {
    scale(of, exact_power(degree(), of.dimension.angle));
    of.dimension.angle = 0;
    return of;
}

Exact in_si(const Measured& value) { return in_radians(value).value; }
Measured bare(Exact value) { return {.value = std::move(value), .dimension = {}, .is_bare = true}; }

tl::expected<WrittenQuantity, Words> as_quantity(const Measured& value, QuantityKind kind, const KnownUnit& bare_unit) {
    static const KnownUnit* const degrees = unit_spelt("deg");
    static const KnownUnit* const radians = unit_spelt("rad");
    const Dimension wanted = dimension_of(kind);
    if (value.is_bare && kind == QuantityKind::angle && value.is_in_radians)
        return WrittenQuantity{handed_on(value), radians};
    if (value.is_bare) return WrittenQuantity{handed_on(value), &bare_unit};
    if (kind == QuantityKind::angle) {
        if (value.dimension == wanted) return WrittenQuantity{handed_on(value), degrees};
        if (value.dimension.is_a_number()) return WrittenQuantity{handed_on(value), radians};
    } else if (same_but_for_angle(value.dimension, wanted)) {
        return WrittenQuantity{handed_on(in_radians(value)) / bare_unit.si, &bare_unit};
    }
    return refused({lang::expressions::the_formula_gives_is_wanted_here, described(value), with_article(kind)});
}

tl::expected<Exact, Words> as_number(const Measured& value) {
    if (value.dimension.is_a_number()) return handed_on(value);
    return refused({lang::expressions::the_formula_gives_a_bare_number, described(value)});
}

Words described(const Measured& value) { return described(value.dimension); }

bool is_parameter_name(std::string_view name) {
    return !name.empty() && word_length(name) == name.size() && name != "pi" && !is_function(name);
}

std::span<const std::string_view> formula_words() { return words_of_formulas; }

}  // namespace kinegraph
