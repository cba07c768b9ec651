// Exact: decimals as written, roots, angles' tangents, rounding.
#include "engine/number/exact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "engine/number/assert.hpp"

namespace kinegraph::exact_test {
namespace {

TEST(Exact, ReadsDecimalsAsWritten) {
    EXPECT_EQ(Exact::from_decimal("0.1"), Exact::ratio(1, 10));
    EXPECT_EQ(Exact::from_decimal("-1.25e-3"), Exact::ratio(-1, 800));
    EXPECT_EQ(Exact::from_decimal("3e2"), Exact(300));
    EXPECT_EQ(Exact::from_decimal("1E+2"), Exact(100));
    EXPECT_EQ(Exact::from_decimal("-0"), Exact(0));
    EXPECT_EQ(Exact::from_decimal("1e400")->bits(), Exact::from_decimal("1e400")->bits());
}

TEST(Exact, RefusesWhatIsNoDecimal) {
    for (const char* text : {"", "-", ".", "1e", "1e+", "0x1", "1 ", " 1", "1..2", "inf", "1e401", "1,5"}) {
        EXPECT_FALSE(Exact::from_decimal(text)) << text;
    }
    EXPECT_FALSE(Exact::from_decimal(std::string(1001, '1')));
    EXPECT_TRUE(Exact::from_decimal(std::string(1000, '1')));
}

TEST(Exact, OneTenthThreeTimesIsThreeTenths) {
    EXPECT_EQ(*Exact::from_decimal("0.1") * 3, *Exact::from_decimal("0.3"));
}

TEST(Exact, GoesToTheNearestDouble) {
    EXPECT_EQ(Exact::from_decimal("0.1")->to_double(), 0.1);
    EXPECT_EQ(Exact::from_decimal("1e60")->to_double(), 1e60);
    EXPECT_EQ(Exact::from_decimal("-2.2250738585072014e-308")->to_double(), -2.2250738585072014e-308);
    EXPECT_EQ((Exact::power_of_two(53) + 1).to_double(), 9007199254740992.0);  // a tie goes to even
    EXPECT_EQ(Exact::from_double(0.1).to_double(), 0.1);
}

TEST(Exact, DividingByZeroIsOurFault) { EXPECT_THROW(Exact(1) / Exact(0), Fault); }

TEST(Exact, OrdersAndPrints) {
    EXPECT_LT(Exact::ratio(1, 3), Exact::ratio(34, 100));
    EXPECT_EQ(Exact::ratio(126, -40).to_fraction(), "-63/20");
    EXPECT_EQ(Exact(-4).to_fraction(), "-4");
}

TEST(Root, IsExactWhereItIsRational) {
    const Root root = square_root(Exact::ratio(49, 64), 100);
    EXPECT_EQ(root.value, Exact::ratio(7, 8));
    EXPECT_TRUE(root.leftover.is_zero());
    EXPECT_TRUE(square_root(0, 10).value.is_zero());
}

TEST(Root, IsWithinItsBoundElsewhere) {
    for (const int bits : {1, 20, 100, 400}) {
        for (const Exact& radicand :
             {Exact(2), Exact::ratio(1, 3), *Exact::from_decimal("123456.789"), *Exact::from_decimal("1e-20")}) {
            const Root root = square_root(radicand, bits);
            EXPECT_LE(root.leftover, Exact::power_of_two(-bits));
            EXPECT_LE(square(root.value), radicand);
            EXPECT_GE(square(root.value + root.leftover), radicand);
        }
    }
}

TEST(Rounded, GoesToTheNearestMultiple) {
    EXPECT_EQ(rounded(Exact::ratio(1, 3), 2), Exact::ratio(1, 4));
    EXPECT_EQ(rounded(Exact::ratio(-1, 3), 2), Exact::ratio(-1, 4));
    EXPECT_EQ(rounded(100, -3), Exact(104));
    EXPECT_LE(abs(rounded(Exact::ratio(22, 7), 50) - Exact::ratio(22, 7)), Exact::power_of_two(-51));
}

TEST(Pi, IsWithin200Bits) {
    // Machin: π/4 = 4·arctan(1/5) − arctan(1/239), summed exactly.
    const auto arctan_of_inverse = [](int n) {
        Exact sum;
        Exact power = Exact::ratio(1, n);
        for (int k = 0; k < 60; ++k) {
            sum += (k % 2 == 0 ? power : -power) / (2 * k + 1);
            power /= n * n;
        }
        return sum;
    };
    EXPECT_LT(abs(4 * (4 * arctan_of_inverse(5) - arctan_of_inverse(239)) - pi()), Exact::power_of_two(-200));
}

TEST(Tangent, OfTheFirstOctant) {
    EXPECT_EQ(tangent_in_first_octant(0, 100), Exact(0));
    EXPECT_EQ(tangent_in_first_octant(Exact::ratio(1, 4), 100), Exact(1));
    const Exact t = tangent_in_first_octant(Exact::ratio(1, 8), 100);  // tan 22.5° = √2 − 1
    EXPECT_LT(abs(square(t + 1) - 2), Exact::power_of_two(-98));
    EXPECT_THROW(tangent_in_first_octant(Exact::ratio(1, 3), 100), Fault);
}

TEST(Exact, AddsAndSubtractsWhateverDenominatorsShare) {
    std::mt19937 random(7);  // NOLINT(cert-msc51-cpp): the same numbers in every run
    const auto number = [&] {
        mpz_class above = static_cast<long>(random() % 2001) - 1000, below = 1;
        for (const int factor : {2, 2, 3, 5, 7, 1000003})
            if (random() % 3 == 0) below *= factor;
        for (int i = 0; i < 5; ++i)
            if (random() % 4 == 0) below *= mpz_class("340282366920938463463374607431768211507"), above *= 1000000007;
        return Exact(mpq_class(above + 1, below));
    };
    for (int i = 0; i < 20'000; ++i) {
        const Exact a = number(), b = i % 5 == 0 ? a : number();
        ASSERT_EQ((a + b).rational(), mpq_class(a.rational() + b.rational()))
            << a.to_fraction() << " + " << b.to_fraction();
        ASSERT_EQ((a - b).rational(), mpq_class(a.rational() - b.rational()))
            << a.to_fraction() << " - " << b.to_fraction();
    }
}

TEST(Length, KeepsTinyAndHuge) {
    EXPECT_EQ(length({3, 4}), 5.0);
    EXPECT_EQ(length({*Exact::from_decimal("3e-200"), *Exact::from_decimal("4e-200")}), 5e-200);
    EXPECT_EQ(length({0, 0}), 0.0);
}

}  // namespace
}  // namespace kinegraph::exact_test
