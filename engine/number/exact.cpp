#include "engine/number/exact.hpp"

#include <mpfr.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {

/// MPFR caches π and freed numbers for each thread. This releases them when the thread ends, so that a user of the
/// library need not.
struct MpfrCaches {
    ~MpfrCaches() { mpfr_free_cache(); }
};

/// Owns an MPFR number.
class Real {
public:
    explicit Real(int bits) {
        thread_local const MpfrCaches caches_of_this_thread;
        mpfr_init2(value_, bits);
    }
    Real(const Real&) = delete;
    Real& operator=(const Real&) = delete;
    ~Real() { mpfr_clear(value_); }
    mpfr_ptr operator()() { return value_; }

private:
    mpfr_t value_;
};

/// (A long may have 32 bits only.)
mpz_class integer(std::int64_t value) {
    mpz_class whole = static_cast<long>(value >> 32);
    whole <<= 32;
    return whole + static_cast<unsigned long>(value & 0xffffffff);
}

mpz_class power_of_ten(unsigned long exponent) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
    return power;
}

}  // namespace

Exact Exact::ratio(std::int64_t numerator, std::int64_t denominator) {
    KG_ASSERT(denominator != 0, "a ratio has a non-zero denominator");
    return Exact(mpq_class(integer(numerator), integer(denominator)));
}

Exact Exact::power_of_two(int exponent) {
    mpq_class value(1);
    if (exponent >= 0) {
        mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    } else {
        mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    }
    return in_lowest_terms(std::move(value));
}

std::optional<Exact> Exact::from_decimal(std::string_view text) {
    constexpr int most_digits = 1000;
    constexpr long largest_exponent = 400;
    std::size_t at = 0;
    const auto digit = [&] { return at < text.size() && text[at] >= '0' && text[at] <= '9'; };
    const bool negative = at < text.size() && text[at] == '-';
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
    std::string digits;
    long exponent = 0;
    while (digit()) digits += text[at++];
    if (at < text.size() && text[at] == '.') {
        ++at;
        for (; digit(); --exponent) digits += text[at++];
    }
    if (digits.empty() || digits.size() > most_digits) return std::nullopt;
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        ++at;
        const bool down = at < text.size() && text[at] == '-';
        if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
        if (!digit()) return std::nullopt;
        long written = 0;
        while (digit()) {
            written = written * 10 + (text[at++] - '0');
            if (written > largest_exponent) return std::nullopt;
        }
        exponent += down ? -written : written;
    }
    if (at != text.size()) return std::nullopt;
    mpq_class value{mpz_class(digits, 10)};
    if (exponent > 0) value *= power_of_ten(static_cast<unsigned long>(exponent));
    if (exponent < 0) value /= power_of_ten(static_cast<unsigned long>(-exponent));
    if (negative) value = -value;
    return Exact(std::move(value));
}

Exact Exact::from_double(double value) {
    KG_ASSERT(std::isfinite(value), "only a finite double is a number");
    return Exact(mpq_class(value));
}

Exact operator+(const Exact& a, const Exact& b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    Exact sum;
    mpq_add(sum.value_.get_mpq_t(), a.value_.get_mpq_t(), b.value_.get_mpq_t());
    return sum;
}

Exact operator-(const Exact& a, const Exact& b) {
    if (a.is_zero()) return -b;
    if (b.is_zero()) return a;
    Exact difference;
    mpq_sub(difference.value_.get_mpq_t(), a.value_.get_mpq_t(), b.value_.get_mpq_t());
    return difference;
}

Exact operator*(const Exact& a, const Exact& b) {
    Exact product;
    if (a.is_zero() || b.is_zero()) return product;
    mpq_mul(product.value_.get_mpq_t(), a.value_.get_mpq_t(), b.value_.get_mpq_t());
    return product;
}

Exact operator/(const Exact& a, const Exact& b) {
    KG_ASSERT(!b.is_zero(), "division by zero");
    Exact quotient;
    if (a.is_zero()) return quotient;
    mpq_div(quotient.value_.get_mpq_t(), a.value_.get_mpq_t(), b.value_.get_mpq_t());
    return quotient;
}

Exact Exact::operator-() const {
    Exact result(*this);
    mpq_neg(result.value_.get_mpq_t(), result.value_.get_mpq_t());
    return result;
}

namespace {

/// The first 128 binary digits of a number > 0, from the highest one.
struct Leading {
    std::array<mp_limb_t, 2> limbs;  ///< the lower one first; the highest bit is set
    std::size_t bits;                ///< of the whole number
};
Leading leading(mpz_srcptr number) {
    const std::size_t count = mpz_size(number);
    const mp_limb_t* const limbs = mpz_limbs_read(number);
    const auto limb = [&](std::size_t from_top) { return from_top < count ? limbs[count - 1 - from_top] : 0; };
    const int unused = std::countl_zero(limb(0));
    if (unused == 0) return {{limb(1), limb(0)}, count * GMP_NUMB_BITS};
    const int rest = GMP_NUMB_BITS - unused;
    return {{limb(1) << unused | limb(2) >> rest, limb(0) << unused | limb(1) >> rest},
            count * GMP_NUMB_BITS - static_cast<std::size_t>(unused)};
}

/// An approximation of a number > 0: between (digits − 2)·2^exponent and (digits + 1)·2^exponent, the highest bit of
/// digits set.
struct Nearly {
    mp_limb_t digits;
    long exponent;
};
static_assert(GMP_NUMB_BITS == 64, "what follows reckons in words of 64 bits");

/// The absolute value of a fraction ≠ 0, from the leading digits alone.
///
/// Numerator n = N·2^i and denominator d = D·2^j with 1/2 ≤ N, D < 1. Let N' be N·2^128 without its fraction (N·2^127
/// where N' would not be below 2^64·D'), D' be D·2^64 without its, and Q = ⌊N'/D'⌋, so 2^63 ≤ Q < 2^64. For q =
/// N/D·2^64 (2^63):
///   q < (N' + 1)/D' ≤ Q + 1, for N' + 1 ≤ D'·(Q + 1);
///   q > N'/(D' + 1) ≥ Q·D'/(D' + 1) = Q − Q/(D' + 1) > Q − 2, for Q < 2^64 ≤ 2·D'.
Nearly nearly(const mpq_class& value) {
    const Leading above = leading(value.get_num_mpz_t()), below = leading(value.get_den_mpz_t());
    const mp_limb_t divisor = below.limbs[1];
    std::array<mp_limb_t, 2> quotient = above.limbs;
    const bool is_halved = quotient[1] >= divisor;
    if (is_halved) mpn_rshift(quotient.data(), quotient.data(), 2, 1);
    mpn_divrem_1(quotient.data(), 0, quotient.data(), 2, divisor);
    return {quotient[0],
            static_cast<long>(above.bits) - static_cast<long>(below.bits) - GMP_NUMB_BITS + (is_halved ? 1 : 0)};
}

/// The nearest double of what lies between digits − below and digits + above (both excluded and small); nothing where
/// that is not one double, or none of the normal ones.
///
/// A double keeps 53 of the 64 bits, so what is nearest changes in the middle between two multiples of 2^11, where the
/// last 11 bits are 2^10; below 2^63, where doubles are twice as dense, the first middle is 2^63 − 2^9. Where none lies
/// between the bounds, all that does is rounded as `digits` is.
std::optional<double> nearest_double(const Nearly& value, mp_limb_t below, mp_limb_t above) {
    static_assert(std::numeric_limits<double>::digits == 53);
    constexpr int dropped = 11;
    constexpr mp_limb_t middle = mp_limb_t{1} << (dropped - 1);
    const mp_limb_t rest = value.digits & (2 * middle - 1);
    if (rest < middle + below && rest + above > middle) return std::nullopt;
    const mp_limb_t kept = (value.digits >> dropped) + (rest > middle ? 1 : 0);
    const long exponent = value.exponent + dropped;
    // 2^52 ≤ kept ≤ 2^53.
    constexpr long least = std::numeric_limits<double>::min_exponent - 53,
                   most = std::numeric_limits<double>::max_exponent - 54;
    if (exponent < least || exponent > most) return std::nullopt;
    return std::ldexp(static_cast<double>(kept), static_cast<int>(exponent));
}

/// ⌊digits²/2^(2·places)⌋.
std::array<mp_limb_t, 2> square_of(mp_limb_t digits, long places) {
    std::array<mp_limb_t, 2> square{};
    if (places >= GMP_NUMB_BITS) return square;
    mpn_sqr(square.data(), &digits, 1);
    if (2 * places >= GMP_NUMB_BITS) square = {square[1], 0};
    const auto rest = static_cast<unsigned>(2 * places % GMP_NUMB_BITS);
    if (rest > 0) mpn_rshift(square.data(), square.data(), 2, rest);
    return square;
}

/// √(x² + y²) to the nearest double, both ≠ 0; nothing as above.
///
/// With X, Y the digits, at the scale of the larger one, and S = X² + ⌊Y²/2^2k⌋ the sum of squares T lies between S −
/// 4X − 4Y > S − 2^67 and S + 2X + 2Y + 3 < S + 2^66 + 3, as X, Y < 2^64. Let R = ⌊√S⌋ (of ⌊S/4⌋ and a place higher
/// where S ≥ 2^128: the bounds are then closer), so R ≥ 2^63 and
///   √T > √S − 2^67/(√S + √T) > R − 9,    √T < √S + (2^66 + 3)/(√S + √T) < R + 1 + 5.
std::optional<double> nearest_length(Nearly x, Nearly y) {
    if (x.exponent < y.exponent) std::swap(x, y);
    std::array<mp_limb_t, 2> sum = square_of(x.digits, 0);
    const std::array<mp_limb_t, 2> smaller = square_of(y.digits, x.exponent - y.exponent);
    if (const mp_limb_t carry = mpn_add_n(sum.data(), sum.data(), smaller.data(), 2); carry != 0) {
        mpn_rshift(sum.data(), sum.data(), 2, 2);
        sum[1] |= carry << (GMP_NUMB_BITS - 2);
        ++x.exponent;
    }
    mp_limb_t root = 0;
    mpn_sqrtrem(&root, nullptr, sum.data(), 2);
    return nearest_double({root, x.exponent}, 9, 6);
}

/// a − b to the nearest double, both ≠ 0; nothing as above, nor where they cancel.
///
/// At the scale of the one with more places, X the digits of it and Y those of the other without their fraction, |x|
/// lies between X − 2 and X + 1 and |y| between Y − 2 and Y + 2. So their sum lies between X + Y − 4 and X + Y + 3 (and
/// half of it between ⌊(X + Y)/2⌋ − 2 and + 2), their difference between X − Y − 4 and X − Y + 3, or the other way
/// round.
std::optional<double> nearest_difference(const mpq_class& a, const mpq_class& b) {
    Nearly x = nearly(a), y = nearly(b);
    bool x_is_negative = sgn(a) < 0;
    bool y_is_negative = sgn(b) > 0;  // of a + (−b)
    if (x.exponent < y.exponent) {
        std::swap(x, y);
        std::swap(x_is_negative, y_is_negative);
    }
    const long places = x.exponent - y.exponent;
    mp_limb_t smaller = places < GMP_NUMB_BITS ? y.digits >> places : 0;
    constexpr mp_limb_t off = 4;
    int cancelled = 0;
    if (x_is_negative == y_is_negative) {
        x.digits += smaller;
        if (x.digits < smaller) {
            x.digits = x.digits >> 1 | mp_limb_t{1} << (GMP_NUMB_BITS - 1);
            ++x.exponent;
        }
    } else {
        if (x.digits < smaller) {
            std::swap(x.digits, smaller);
            x_is_negative = !x_is_negative;
        }
        x.digits -= smaller;
        cancelled = std::countl_zero(x.digits);
        constexpr int most = 5;
        if (cancelled > most) return std::nullopt;
        x.digits <<= cancelled;
        x.exponent -= cancelled;
    }
    const auto nearest = nearest_double(x, off << cancelled, off << cancelled);
    if (!nearest) return std::nullopt;
    return x_is_negative ? -*nearest : *nearest;
}

/// The nearest double of a fraction with denominator > 0, which need not be in lowest terms.
double to_nearest_double(const mpq_class& value) {
    if (sgn(value) == 0) return 0;
    if (const auto nearest = nearest_double(nearly(value), 2, 1)) return sgn(value) < 0 ? -*nearest : *nearest;
    constexpr int bits_of_double = 53;
    Real nearest(bits_of_double);
    mpfr_set_q(nearest(), value.get_mpq_t(), MPFR_RNDN);
    return mpfr_get_d(nearest(), MPFR_RNDN);
}

/// √(x² + y²), of fractions as above.
double to_nearest_length(const mpq_class& x, const mpq_class& y) {
    if (sgn(x) == 0 || sgn(y) == 0) return std::abs(to_nearest_double(sgn(x) == 0 ? y : x));
    if (const auto nearest = nearest_length(nearly(x), nearly(y))) return *nearest;
    // Enough bits that overflow and underflow lose nothing and only the last rounding counts; reducing the exact square
    // would be expensive.
    constexpr int bits = 160;
    Real other(bits), root(bits);
    mpfr_set_q(other(), x.get_mpq_t(), MPFR_RNDN);
    mpfr_set_q(root(), y.get_mpq_t(), MPFR_RNDN);
    mpfr_hypot(root(), other(), root(), MPFR_RNDN);
    return mpfr_get_d(root(), MPFR_RNDN);
}

/// a − b, not in lowest terms.
mpq_class unreduced_difference(const mpq_class& a, const mpq_class& b) {
    mpq_class difference;
    if (a.get_den() == b.get_den()) {
        difference.get_num() = a.get_num() - b.get_num();
        difference.get_den() = a.get_den();
        return difference;
    }
    mpz_mul(difference.get_num_mpz_t(), a.get_num_mpz_t(), b.get_den_mpz_t());
    mpz_submul(difference.get_num_mpz_t(), b.get_num_mpz_t(), a.get_den_mpz_t());
    mpz_mul(difference.get_den_mpz_t(), a.get_den_mpz_t(), b.get_den_mpz_t());
    return difference;
}

}  // namespace

double Exact::to_double() const { return to_nearest_double(value_); }

double difference_to_double(const Exact& a, const Exact& b) {
    if (b.is_zero()) return a.to_double();
    if (!a.is_zero())
        if (const auto nearest = nearest_difference(a.rational(), b.rational())) return *nearest;
    return to_nearest_double(unreduced_difference(a.rational(), b.rational()));
}

bool is_same_ratio(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
    if (a.sign() * b.sign() != c.sign() * d.sign()) return false;
    const mpq_class &p = a.rational(), &q = b.rational(), &r = c.rational(), &s = d.rational();
    const mpz_class left_above = p.get_num() * s.get_num(), left_below = p.get_den() * s.get_den();
    const mpz_class right_above = r.get_num() * q.get_num(), right_below = r.get_den() * q.get_den();
    return mpz_class(left_above * right_below) == mpz_class(right_above * left_below);
}

std::size_t Exact::bits() const {
    return mpz_sizeinbase(value_.get_num_mpz_t(), 2) + mpz_sizeinbase(value_.get_den_mpz_t(), 2);
}

Exact abs(const Exact& value) { return value.sign() < 0 ? -value : value; }

Exact rounded(const Exact& value, int bits) {
    // floor(value·2^bits + 1/2) / 2^bits
    mpq_class scaled;
    const auto places = static_cast<mp_bitcnt_t>(std::abs(bits));
    (bits < 0 ? mpq_div_2exp : mpq_mul_2exp)(scaled.get_mpq_t(), value.rational().get_mpq_t(), places);
    // ⌊n/d + 1/2⌋ = ⌊(2n + d)/2d⌋
    mpz_class& above = scaled.get_num();
    mpz_class& below = scaled.get_den();
    above <<= 1;
    above += below;
    below <<= 1;
    mpz_fdiv_q(above.get_mpz_t(), above.get_mpz_t(), below.get_mpz_t());
    below = 1;
    (bits < 0 ? mpq_mul_2exp : mpq_div_2exp)(scaled.get_mpq_t(), scaled.get_mpq_t(), places);
    return Exact::in_lowest_terms(std::move(scaled));
}

Root square_root(const Exact& radicand, int bits) {
    KG_ASSERT(radicand.sign() >= 0, "a root is taken of a number ≥ 0");
    const mpz_class& above = radicand.rational().get_num();
    const mpz_class& below = radicand.rational().get_den();
    if (mpz_perfect_square_p(above.get_mpz_t()) != 0 && mpz_perfect_square_p(below.get_mpz_t()) != 0) {
        return {Exact(mpq_class(sqrt(above), sqrt(below))), Exact()};
    }
    // √(p/q) on the grid 2^-k: the integer root of p·4^k/q, whose floor is at most one step too low.
    const int grid = bits + 1;
    const mpq_class scaled = (radicand * Exact::power_of_two(2 * grid)).rational();
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
    return {Exact(mpq_class(mpz_class(sqrt(whole)))) * Exact::power_of_two(-grid), Exact::power_of_two(-grid)};
}

const Exact& pi() {
    // 61 decimals, the last rounded: error below 10^-61 < 2^-200.
    static const Exact value = *Exact::from_decimal("3.1415926535897932384626433832795028841971693993751058209749446");
    return value;
}

Exact tangent_in_first_octant(const Exact& half_turns, int bits) {
    KG_ASSERT(half_turns.sign() >= 0 && half_turns <= Exact::ratio(1, 4), "the first octant is 0° to 45°");
    if (half_turns.is_zero()) return 0;
    if (half_turns == Exact::ratio(1, 4)) return 1;
    // MPFR rounds correctly, so every machine gets the same tangent; 64 guard bits cover the product with π.
    Real angle(bits + 64);
    mpfr_const_pi(angle(), MPFR_RNDN);
    mpfr_mul_q(angle(), angle(), half_turns.rational().get_mpq_t(), MPFR_RNDN);
    mpfr_tan(angle(), angle(), MPFR_RNDN);
    mpq_class value;
    mpfr_get_q(value.get_mpq_t(), angle());
    return rounded(Exact(value), bits);
}

Exact degrees_of(const Exact& y, const Exact& x, int bits) {
    KG_ASSERT(!x.is_zero() || !y.is_zero(), "a zero vector has no angle");
    // From the ratio in the first octant; the reflections to the other octants are exact.
    const bool steep = abs(y) > abs(x);
    const Exact ratio = steep ? abs(x) / abs(y) : abs(y) / abs(x);
    Real tangent(bits + 64), half_turn(bits + 64);
    mpfr_set_q(tangent(), ratio.rational().get_mpq_t(), MPFR_RNDN);
    mpfr_atan(tangent(), tangent(), MPFR_RNDN);
    mpfr_const_pi(half_turn(), MPFR_RNDN);
    mpfr_mul_ui(tangent(), tangent(), 180, MPFR_RNDN);
    mpfr_div(tangent(), tangent(), half_turn(), MPFR_RNDN);
    mpq_class value;
    mpfr_get_q(value.get_mpq_t(), tangent());
    Exact degrees = rounded(Exact(value), bits);
    if (steep) degrees = 90 - degrees;
    if (x.sign() < 0) degrees = 180 - degrees;
    return y.sign() < 0 ? -degrees : degrees;
}

double length(const Vector& a) { return to_nearest_length(a.x.rational(), a.y.rational()); }

double distance(const Exact& x0, const Exact& y0, const Exact& x, const Exact& y) {
    return to_nearest_length(unreduced_difference(x.rational(), x0.rational()),
                             unreduced_difference(y.rational(), y0.rational()));
}

}  // namespace kinegraph
