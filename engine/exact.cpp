#include "engine/exact.hpp"

#include <mpfr.h>

#include <array>
#include <cmath>
#include <cstdlib>

#include "engine/assert.hpp"

namespace kinegraph {
namespace {

/// A number of MPFR that frees itself.
class Real {
public:
    explicit Real(int bits) { mpfr_init2(value_, bits); }
    Real(const Real&) = delete;
    Real& operator=(const Real&) = delete;
    ~Real() { mpfr_clear(value_); }
    mpfr_ptr operator()() { return value_; }

private:
    mpfr_t value_;
};

mpz_class power_of_ten(unsigned long exponent) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
    return power;
}

}  // namespace

Exact Exact::ratio(std::int64_t numerator, std::int64_t denominator) {
    KG_ASSERT(denominator != 0, "a ratio has a non-zero denominator");
    return Exact(mpq_class(mpz_class(static_cast<long>(numerator)), mpz_class(static_cast<long>(denominator))));
}

Exact Exact::power_of_two(int exponent) {
    mpq_class value(1);
    if (exponent >= 0) {
        mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    } else {
        mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    }
    return Exact(value);
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

Exact& Exact::operator/=(const Exact& other) {
    KG_ASSERT(!other.is_zero(), "division by zero");
    value_ /= other.value_;
    return *this;
}

Exact Exact::operator-() const {
    Exact result;
    mpq_neg(result.value_.get_mpq_t(), value_.get_mpq_t());
    return result;
}

double Exact::to_double() const {
    constexpr int bits_of_double = 53;
    Real nearest(bits_of_double);
    mpfr_set_q(nearest(), value_.get_mpq_t(), MPFR_RNDN);
    return mpfr_get_d(nearest(), MPFR_RNDN);
}

std::size_t Exact::bits() const { return mpz_sizeinbase(value_.get_num_mpz_t(), 2) + mpz_sizeinbase(value_.get_den_mpz_t(), 2); }

Exact abs(const Exact& value) { return value.sign() < 0 ? -value : value; }

Exact rounded(const Exact& value, int bits) {
    // floor(value·2^bits + 1/2) / 2^bits
    mpq_class scaled = (value * Exact::power_of_two(bits)).rational() + mpq_class(1, 2);
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
    return Exact(mpq_class(whole)) * Exact::power_of_two(-bits);
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
    // 61 decimals, the last rounded: off by less than 10^-61 < 2^-200.
    static const Exact value = *Exact::from_decimal("3.1415926535897932384626433832795028841971693993751058209749446");
    return value;
}

Exact tangent_in_first_octant(const Exact& half_turns, int bits) {
    KG_ASSERT(half_turns.sign() >= 0 && half_turns <= Exact::ratio(1, 4), "the first octant is 0° to 45°");
    if (half_turns.is_zero()) return 0;
    if (half_turns == Exact::ratio(1, 4)) return 1;
    // MPFR rounds correctly, so that every machine gets the same tangent; 64 guard bits cover the product with π.
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
    // Of the ratio alone, in the first octant: the rest is folding, which is exact.
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

double length(const Vector& a) {
    // With so many bits that nothing is lost to overflow or underflow and only the last rounding counts; the exact square would
    // be reduced at great cost.
    constexpr int bits = 160;
    Real x(bits), root(bits);
    mpfr_set_q(x(), a.x.rational().get_mpq_t(), MPFR_RNDN);
    mpfr_set_q(root(), a.y.rational().get_mpq_t(), MPFR_RNDN);
    mpfr_hypot(root(), x(), root(), MPFR_RNDN);
    return mpfr_get_d(root(), MPFR_RNDN);
}

}  // namespace kinegraph
