// The doubles nearest to exact numbers and lengths, held against MPFR: numbers of all lengths, and such as lie on, or
// beside, the middle between two doubles, where a conversion by leading digits must not guess.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/number/exact.hpp"
#include "tests/support/random_mechanism.hpp"

namespace kinegraph::nearest_double_test {
namespace {

/// Of 53 bits, exactly once rounded.
double by_mpfr(const Exact& value) {
    mpfr_t nearest;
    mpfr_init2(nearest, 53);
    mpfr_set_q(nearest, value.rational().get_mpq_t(), MPFR_RNDN);
    const double found = mpfr_get_d(nearest, MPFR_RNDN);
    mpfr_clear(nearest);
    return found;
}

/// √(x² + y²) from 500 bits.
double length_by_mpfr(const Vector& vector) {
    mpfr_t root;
    mpfr_init2(root, 500);
    mpfr_set_q(root, squared_length(vector).rational().get_mpq_t(), MPFR_RNDN);
    mpfr_sqrt(root, root, MPFR_RNDN);
    const double found = mpfr_get_d(root, MPFR_RNDN);
    mpfr_clear(root);
    return found;
}

class Numbers {
public:
    int upto(int most) { return static_cast<int>(random_() % static_cast<unsigned>(most + 1)); }
    /// A whole number > 0 of so many bits at most.
    Exact whole(int bits) {
        mpz_class number;
        for (int i = 0; i < bits; i += 32) number = (number << 32) + static_cast<unsigned>(random_());
        const auto beyond = static_cast<mp_bitcnt_t>((32 - bits % 32) % 32);
        return Exact(mpq_class(mpz_class(number >> beyond) + 1));
    }
    Exact fraction() {
        const Exact size = whole(1 + upto(400)) / whole(1 + upto(400));
        return upto(1) == 0 ? size : -size;
    }
    /// The middle between two doubles, or beside it by 2^-2 to 2^-92.
    Exact near_a_middle() {
        const Exact odd = 2 * whole(52) + 1 + Exact::power_of_two(53);
        const Exact off = upto(2) == 0 ? Exact(0) : whole(70) * Exact::power_of_two(-72 - upto(20));
        return (upto(1) == 0 ? odd + off : odd - off) * Exact::power_of_two(upto(200) - 100);
    }

private:
    std::mt19937 random_{53};  // NOLINT(cert-msc51-cpp): the same numbers in every run
};

TEST(NearestDouble, OfAFractionIsWhatMpfrFinds) {
    Numbers numbers;
    for (int i = 0; i < unless_sanitized(500'000, 5'000); ++i) {
        const Exact number = numbers.fraction(), middle = numbers.near_a_middle();
        ASSERT_EQ(number.to_double(), by_mpfr(number)) << number.to_fraction();
        ASSERT_EQ(middle.to_double(), by_mpfr(middle)) << middle.to_fraction();
    }
}

TEST(NearestDouble, OfALengthIsWhatMpfrFinds) {
    Numbers numbers;
    for (int i = 0; i < unless_sanitized(30'000, 2'000); ++i) {
        const Exact unit = numbers.fraction();
        const Vector vector{numbers.whole(200) * unit, numbers.whole(200 + numbers.upto(40)) * -unit};
        ASSERT_EQ(length(vector), length_by_mpfr(vector)) << vector.x.to_fraction() << ' ' << vector.y.to_fraction();
        // 3, 4, 5: the length is on, or beside, the middle.
        const Exact fifth = numbers.near_a_middle() / 5;
        const Vector triangle{3 * fifth, 4 * fifth};
        ASSERT_EQ(length(triangle), by_mpfr(5 * fifth)) << fifth.to_fraction();
    }
}

TEST(NearestDouble, OfADifferenceIsThatOfTheExactOne) {
    Numbers numbers;
    for (int i = 0; i < unless_sanitized(30'000, 2'000); ++i) {
        const Exact unit = numbers.fraction(), a = numbers.whole(100) * unit, middle = numbers.near_a_middle();
        const Exact b = numbers.whole(40 + numbers.upto(120)) * (numbers.upto(1) == 0 ? unit : -unit);
        ASSERT_EQ(difference_to_double(a, b), (a - b).to_double()) << a.to_fraction() << " - " << b.to_fraction();
        ASSERT_EQ(difference_to_double(b, a), (b - a).to_double()) << b.to_fraction() << " - " << a.to_fraction();
        // Their difference is on, or beside, the middle.
        ASSERT_EQ(difference_to_double(middle + a, a), by_mpfr(middle))
            << middle.to_fraction() << " + " << a.to_fraction();
        ASSERT_EQ(distance(Vector{a, b}, Vector{b, a}), length({b - a, a - b}));
    }
    EXPECT_EQ(difference_to_double(2, 2), 0);
    EXPECT_EQ(difference_to_double(0, 2), -2);
    EXPECT_EQ(difference_to_double(2, 0), 2);
}

TEST(NearestDouble, GoesToZeroAndInfinityAsDoublesDo) {
    EXPECT_EQ(Exact::power_of_two(-1074).to_double(), std::ldexp(1.0, -1074));
    EXPECT_EQ(Exact::power_of_two(-1100).to_double(), 0);
    EXPECT_EQ((Exact::power_of_two(1024) - Exact::power_of_two(970)).to_double(), HUGE_VAL);
    EXPECT_EQ((Exact::power_of_two(971) - Exact::power_of_two(1024)).to_double(), -std::numeric_limits<double>::max());
    EXPECT_EQ((Exact::power_of_two(-1022) + Exact::power_of_two(-1073)).to_double(),
              std::ldexp(1.0, -1022) + std::ldexp(1.0, -1073));
    EXPECT_EQ(length({0, Exact::ratio(-1, 3)}), 1.0 / 3);
    EXPECT_EQ(length({Exact::power_of_two(-1074), Exact::power_of_two(1000)}), std::ldexp(1.0, 1000));
}

}  // namespace
}  // namespace kinegraph::nearest_double_test
