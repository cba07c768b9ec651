// In twice the digits of a double, so that only the last rounding counts. Where <cmath> gives a first value, a step of
// Newton's in twice the digits makes it unimportant which.
#include "engine/number/functions.hpp"

#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "engine/number/wide.hpp"

namespace kinegraph::nearest {
namespace {

using namespace wide;

constexpr Wide ln_2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr Wide ln_10{0x1.26bb1bbb55516p+1, -0x1.f48ad494ea3e9p-53};
constexpr Wide half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/// x = turns·π/2 + rest, |rest| ≤ π/4 and a little.
struct Quarter {
    int turns;  ///< modulo 4
    Wide rest;
};
/// Of any finite x, by as many digits of π as that takes.
Quarter of_a_large(double x) {
    constexpr mpfr_prec_t bits = 1280;
    mpfr_t quarter, rest;
    mpfr_inits2(bits, quarter, rest, nullptr);
    mpfr_const_pi(quarter, MPFR_RNDN);
    mpfr_div_2ui(quarter, quarter, 1, MPFR_RNDN);
    mpfr_set_d(rest, x, MPFR_RNDN);
    long turns = 0;  // its lowest bits
    mpfr_remquo(rest, &turns, rest, quarter, MPFR_RNDN);
    const double high = mpfr_get_d(rest, MPFR_RNDN);
    mpfr_sub_d(rest, rest, high, MPFR_RNDN);
    const double low = mpfr_get_d(rest, MPFR_RNDN);
    mpfr_clears(quarter, rest, nullptr);
    mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE);  // the digits of π, which the thread would leave behind
    return {static_cast<int>(turns & 3), {high, low}};
}
Quarter quarter_of(double x) {
    constexpr double most = 1e5;  // up to which turns·(the upper digits of π/2) are exact
    if (std::abs(x) <= 0.75) return {0, {x}};
    if (std::abs(x) < most) {
        // π/2 in two pieces of 33 bits and two doubles.
        constexpr double first = 0x1.921fb544p+0, second = 0x1.0b4611a6p-34, third = 0x1.3198a2e037073p-69;
        const double turns = std::nearbyint(x * 0x1.45f306dc9c883p-1);
        Wide rest = sum_of(x, -turns * first) + -turns * second;
        rest = rest - product_of(turns, third);
        return {static_cast<int>(static_cast<std::int64_t>(turns) & 3), rest};
    }
    return of_a_large(x);
}

struct SineCosine {
    Wide sine, cosine;
};
/// By their series, |x| ≤ π/4 and a little; what is left out is below 2^-110.
SineCosine sine_cosine(Wide x) {
    constexpr int last = 28;
    const Wide minus_square = -(x * x);
    SineCosine sums{x, {1}};
    Wide even{1}, odd = x;
    for (int i = 2; i <= last && std::abs(even.high) > 0x1p-112; i += 2) {
        even = even * minus_square / static_cast<double>(i * (i - 1));
        odd = odd * minus_square / static_cast<double>(i * (i + 1));
        sums.cosine = sums.cosine + even;
        sums.sine = sums.sine + odd;
    }
    return sums;
}
/// The sine and cosine of turns·π/2 more.
SineCosine turned(const SineCosine& of, int turns) {
    switch (turns & 3) {
        case 0: return of;
        case 1: return {of.cosine, -of.sine};
        case 2: return {-of.sine, -of.cosine};
        default: return {-of.cosine, of.sine};
    }
}
SineCosine sine_cosine(double x) {
    const Quarter quarter = quarter_of(x);
    return turned(sine_cosine(quarter.rest), quarter.turns);
}

/// The nearest double of high + low, |low| far below |high|, if `off` bounds the error of low and both ends of what it
/// leaves have the same; else NaN.
double certain(double high, double low, double off) {
    const double up = high + (low + off), down = high + (low - off);
    return up == down ? up : std::numeric_limits<double>::quiet_NaN();
}
/// 1/5!, 1/7! … and 1/4!, 1/6! …
constexpr std::array odd_factorials{1 / 120.0,        1 / 5040.0,          1 / 362880.0,         1 / 39916800.0,
                                    1 / 6227020800.0, 1 / 1307674368000.0, 1 / 355687428096000.0};
constexpr std::array even_factorials{1 / 24.0,        1 / 720.0,         1 / 40320.0,          1 / 3628800.0,
                                     1 / 479001600.0, 1 / 87178291200.0, 1 / 20922789888000.0, 1 / 6402373705728000.0};
/// The first of the coefficients, less the next times z, and so on.
template <std::size_t count>
double series(double z, const std::array<double, count>& coefficients) {
    double sum = 0;
    for (std::size_t i = count; i-- > 0;) sum = coefficients[i] - z * sum;
    return sum;
}
/// sin and cos of a rest, in a few operations; NaN where they leave the rounding open.
double quick_sine(Wide x) {
    const double z = x.high * x.high;
    const Wide sixth = product_of(x.high, z);  // z to half a unit: 2^-56 of x³/6
    const double z_low = product_of(x.high, x.high).low;
    const Wide third = sum_of_ordered(sixth.high, sixth.low + x.high * z_low) / -6.0;
    const double higher = x.high * z * z * series(z, odd_factorials);
    const Wide sum = sum_of_ordered(x.high, third.high);
    const double low = sum.low + (third.low + higher + x.low * (1 - z / 2 + z * z / 24));
    return certain(sum.high, low, std::abs(x.high) * 0x1p-58);
}
double quick_cosine(Wide x) {
    const Wide z = product_of(x.high, x.high);
    const double higher = z.high * z.high * series(z.high, even_factorials);
    const Wide sum = sum_of_ordered(1, -z.high / 2);
    const double low = sum.low + (higher - z.low / 2 - x.low * x.high * (1 - z.high / 6));
    return certain(sum.high, low, 0x1p-57);
}
/// One of the two, as in sine_cosine().
Wide by_series(Wide x, bool is_cosine) {
    const Wide minus_square = -(x * x);
    Wide sum = is_cosine ? Wide{1} : x, term = sum;
    const double least = std::abs(sum.high) * 0x1p-112;
    for (int i = is_cosine ? 2 : 3; std::abs(term.high) > least; i += 2) {
        term = term * minus_square / static_cast<double>(i * (i - 1));
        sum = sum + term;
    }
    return sum;
}
double sine_of(const Quarter& quarter) {
    const bool is_cosine = (quarter.turns & 1) != 0, is_negative = (quarter.turns & 2) != 0;
    double value = is_cosine ? quick_cosine(quarter.rest) : quick_sine(quarter.rest);
    if (std::isnan(value)) value = by_series(quarter.rest, is_cosine).rounded();
    return is_negative ? -value : value;
}

/// The angle of (x, y), not both 0, from −π to π: the near one, turned by what is left.
Wide angle_of(Wide y, Wide x) {
    const double near = std::atan2(y.high, x.high);
    const SineCosine at = sine_cosine(near);
    const Wide across = y * at.cosine - x * at.sine, along = x * at.cosine + y * at.sine;
    return Wide{near} + across / along;  // its cube is below 2^-150
}
/// (x, y) at a scale at which products neither overflow nor underflow.
std::pair<double, double> at_a_middle_scale(double x, double y) {
    const int exponent = std::ilogb(std::max(std::abs(x), std::abs(y)));
    return {std::ldexp(x, -exponent), std::ldexp(y, -exponent)};
}

/// e^x as a number near 1 and a power of 2; |x| < 2000.
struct Power {
    Wide near;
    int twos;

    double rounded() const { return std::ldexp(near.rounded(), twos); }
};
Power power_of_e(Wide x) {
    constexpr int halvings = 8, last = 12;
    const double twos = std::nearbyint(x.high / ln_2.high);
    Wide rest = x - ln_2 * twos;
    rest = {std::ldexp(rest.high, -halvings), std::ldexp(rest.low, -halvings)};
    // e^x − 1 by its series, then doubled in x: (1 + a)² − 1 = 2a + a².
    Wide term = rest, sum = rest;
    for (int i = 2; i <= last; ++i) {
        term = term * rest / static_cast<double>(i);
        sum = sum + term;
    }
    for (int i = 0; i < halvings; ++i) sum = sum * 2.0 + sum * sum;
    return {sum + 1.0, static_cast<int>(twos)};
}
/// ln x, x > 0 and finite: the near one, and what e^ says is left.
Wide logarithm(double x) {
    int twos = std::ilogb(x);
    double near_1 = std::ldexp(x, -twos);
    if (near_1 > 1.5) {
        near_1 /= 2;
        ++twos;
    }
    const double near = std::log(near_1);
    const Power inverse = power_of_e({-near});
    const Wide left = inverse.near * std::ldexp(near_1, inverse.twos) + -1.0;
    return ln_2 * static_cast<double>(twos) + (Wide{near} + (left - halved(left * left)));
}

bool is_usual(double x) { return std::isfinite(x) && x != 0; }
constexpr double largest_power = 709, tiny = 0x1p-30;

}  // namespace

double sin(double x) {
    if (!is_usual(x) || std::abs(x) < 0x1p-27) return std::isinf(x) ? std::numeric_limits<double>::quiet_NaN() : x;
    return sine_of(quarter_of(x));
}
double cos(double x) {
    if (!std::isfinite(x)) return std::numeric_limits<double>::quiet_NaN();
    Quarter quarter = quarter_of(x);
    ++quarter.turns;
    return sine_of(quarter);
}
double tan(double x) {
    if (!is_usual(x) || std::abs(x) < 0x1p-27) return std::isinf(x) ? std::numeric_limits<double>::quiet_NaN() : x;
    const SineCosine both = sine_cosine(x);
    return (both.sine / both.cosine).rounded();
}
double atan2(double y, double x) {
    if (!is_usual(y) || !is_usual(x)) return std::atan2(y, x);
    const auto [across, up] = at_a_middle_scale(x, y);
    constexpr double far = 0x1p-500;
    if (std::abs(across) < far || std::abs(up) < far) return std::atan2(y, x);
    return angle_of({up}, {across}).rounded();
}
double atan(double x) { return is_usual(x) ? atan2(x, 1) : std::atan(x); }
double asin(double x) {
    if (!(std::abs(x) < 1) || std::abs(x) < 0x1p-27) return std::abs(x) < 1 ? x : std::asin(x);
    return angle_of({x}, root(sum_of(1, -x) * sum_of(1, x))).rounded();
}
double acos(double x) {
    if (!(std::abs(x) < 1)) return std::acos(x);
    return angle_of(root(sum_of(1, -x) * sum_of(1, x)), {x}).rounded();
}
double exp(double x) {
    if (!is_usual(x) || std::abs(x) > largest_power) return std::exp(x);
    return power_of_e({x}).rounded();
}
double log(double x) { return is_usual(x) && x > 0 ? logarithm(x).rounded() : std::log(x); }
double log10(double x) { return is_usual(x) && x > 0 ? (logarithm(x) / ln_10).rounded() : std::log10(x); }
double pow(double base, double exponent) {
    if (!is_usual(base) || !is_usual(exponent)) return std::pow(base, exponent);
    const bool is_whole = std::nearbyint(exponent) == exponent;
    if (base < 0 && !is_whole) return std::pow(base, exponent);
    const Wide power = logarithm(std::abs(base)) * exponent;
    if (!(std::abs(power.high) <= largest_power)) return std::pow(base, exponent);
    const double value = power_of_e(power).rounded();
    return base < 0 && std::fmod(exponent, 2) != 0 ? -value : value;
}
double sinh(double x) {
    if (!is_usual(x) || std::abs(x) > largest_power) return std::sinh(x);
    if (std::abs(x) < tiny) return x + x * x * x / 6;
    const Power up = power_of_e({x}), down = power_of_e({-x});
    const auto scaled = [](const Power& of) {
        return Wide{std::ldexp(of.near.high, of.twos), std::ldexp(of.near.low, of.twos)};
    };
    return halved(scaled(up) - scaled(down)).rounded();
}
double cosh(double x) {
    if (!is_usual(x) || std::abs(x) > largest_power) return std::cosh(x);
    const Power up = power_of_e({x}), down = power_of_e({-x});
    const auto scaled = [](const Power& of) {
        return Wide{std::ldexp(of.near.high, of.twos), std::ldexp(of.near.low, of.twos)};
    };
    return halved(scaled(up) + scaled(down)).rounded();
}
double tanh(double x) {
    constexpr double flat = 20;
    if (!is_usual(x) || std::abs(x) > flat) return std::tanh(x);
    if (std::abs(x) < tiny) return x - x * x * x / 3;
    const Power up = power_of_e({2 * x});
    const Wide square{std::ldexp(up.near.high, up.twos), std::ldexp(up.near.low, up.twos)};
    return ((square + -1.0) / (square + 1.0)).rounded();
}
double cbrt(double x) {
    if (!is_usual(x)) return x;
    const int thirds = std::ilogb(x) / 3;
    const double middle = std::ldexp(x, -3 * thirds), near = std::cbrt(middle);
    const Wide left = Wide{middle} - product_of(near, near) * near;
    return std::ldexp(sum_of_ordered(near, left.high / (3 * near * near)).rounded(), thirds);
}
double hypot(double x, double y) {
    if (!is_usual(x) || !is_usual(y)) return std::hypot(x, y);
    const int exponent = std::ilogb(std::max(std::abs(x), std::abs(y)));
    const auto [a, b] = at_a_middle_scale(x, y);
    return std::ldexp(root(product_of(a, a) + product_of(b, b)).rounded(), exponent);
}

}  // namespace kinegraph::nearest
