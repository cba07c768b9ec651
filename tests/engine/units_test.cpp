// Units and decimals: every unit of the format is read exactly, and what is no quantity is refused in words.
#include "engine/file/units.hpp"

#include <gtest/gtest.h>

#include <string>

using kinegraph::Exact;
using kinegraph::QuantityKind;

namespace units_test {
namespace {

using kinegraph::Language;

Exact exact(std::string_view decimal) { return *Exact::from_decimal(decimal); }

/// In SI; the text must be a quantity.
Exact si(std::string_view text) {
    const auto quantity = kinegraph::read_quantity(text, QuantityKind::length);
    EXPECT_TRUE(quantity) << text << ": " << quantity.error().in(Language::en);
    return quantity ? quantity->in_si() : Exact();
}

std::string refusal(std::string_view text, QuantityKind wanted = QuantityKind::length) {
    const auto quantity = kinegraph::read_quantity(text, wanted);
    EXPECT_FALSE(quantity) << text;
    return quantity ? "" : quantity.error().in(Language::en);
}

TEST(Units, LengthsAreExact) {
    EXPECT_EQ(si("31.8 cm"), exact("0.318"));
    EXPECT_EQ(si("0.1mm"), Exact::ratio(1, 10000));
    EXPECT_EQ(si("1 in"), exact("0.0254"));
    EXPECT_EQ(si("-2.5e1 ft"), exact("-7.62"));
    EXPECT_EQ(si("+2 m"), Exact(2));
}

TEST(Units, TurnsHaveOnePi) {
    EXPECT_EQ(si("120 rpm"), Exact(4) * kinegraph::pi());
    EXPECT_EQ(si("30 rpm"), si("180 deg/s"));
    EXPECT_EQ(si("180°"), kinegraph::pi());
    EXPECT_EQ(si("180 deg"), si("180°"));
    EXPECT_EQ(si("2 rad/s²"), Exact(2));
    EXPECT_EQ(si("60 rpm/s"), si("360 deg/s^2"));
    EXPECT_EQ(si("0.5 rev"), kinegraph::pi());
    EXPECT_EQ(si("2 rev/s"), si("120 rpm"));
}

TEST(Units, MassesForcesMoments) {
    EXPECT_EQ(si("2 kN"), Exact(2000));
    EXPECT_EQ(si("16.28 MN"), Exact(16280000));
    EXPECT_EQ(si("1 lbf"), exact("4.4482216152605"));
    EXPECT_EQ(si("1 slug") * exact("0.3048"), si("1 lbf"));
    EXPECT_EQ(si("3 t"), Exact(3000));
    EXPECT_EQ(si("16 oz"), si("1 lb"));
    EXPECT_EQ(si("36 km/h"), Exact(10));
    EXPECT_EQ(si("250 N cm"), exact("2.5"));
    EXPECT_EQ(si("1 lbf ft"), si("12 lbf in"));
    EXPECT_EQ(si("1 kN m"), si("1000000 N mm"));
    EXPECT_EQ(si("1 kg m²"), si("10000 kg cm²"));
    EXPECT_EQ(si("1 kg m²"), si("1000000 kg mm^2"));
}

TEST(Units, SpellingsAreAlike) {
    for (const char* moment : {"3 N m", "3 N·m", "3 N*m", "3N m", "3 N * m", "3 N · m"})
        EXPECT_EQ(si(moment), Exact(3)) << moment;
    for (const char* inertia : {"3 kg m²", "3 kg·m^2", "3 kg*m²", "3 kg m^2"})
        EXPECT_EQ(si(inertia), Exact(3)) << inertia;
    EXPECT_EQ(si("3 m/s²"), si("3 m/s^2"));
}

TEST(Units, EveryUnitReadsItsOwnSymbol) {
    ASSERT_FALSE(kinegraph::known_units().empty());
    for (const auto& unit : kinegraph::known_units()) {
        EXPECT_EQ(kinegraph::unit_spelt(unit.symbol), &unit) << unit.symbol;
        EXPECT_GT(unit.si, Exact(0)) << unit.symbol;
    }
}

TEST(Units, FirstUnitOfEachKindIsItsDefault) {
    EXPECT_EQ(kinegraph::default_unit(QuantityKind::angle).symbol, "deg");
    EXPECT_EQ(kinegraph::default_unit(QuantityKind::inertia).symbol, "kg m²");
    EXPECT_EQ(kinegraph::units_of(QuantityKind::length), "m, cm, mm, in, ft");
}

TEST(Units, RefusalsNameTheRemedy) {
    EXPECT_EQ(
        refusal("3 Nm", QuantityKind::moment),
        "unknown unit \"Nm\" (did you mean \"N m\"?); the units of moment are N m, N cm, N mm, kN m, lbf in, lbf ft");
    EXPECT_EQ(refusal("3 parsec"), "unknown unit \"parsec\"; the units of length are m, cm, mm, in, ft");
    EXPECT_EQ(refusal("5"), "\"5\" has no unit; add one, as \"2 m\", or write the number without quotes");
    EXPECT_EQ(refusal("mm"), "\"mm\" is no quantity; write a number and its unit, as \"2 m\"");
    EXPECT_EQ(refusal("−3 mm"), "\"−3 mm\" is no quantity; a minus is written \"-\"");
    EXPECT_EQ(refusal(""), "\"\" is no quantity; write a number and its unit, as \"2 m\"");
    EXPECT_EQ(refusal("1. m"), "\"1.\" is no decimal number");
    for (const char* formula : {"1/3", "2*(3 + 4)", "-1 + 2", "2^3"})
        EXPECT_EQ(refusal(formula),
                  '"' + std::string(formula) + "\" is no number; a formula begins with \"=\": \"= " + formula + '"');
    EXPECT_EQ(refusal("5 + x"), "unknown unit \"+ x\"; the units of length are m, cm, mm, in, ft");
    EXPECT_EQ(refusal("1,5 m"), "unknown unit \",5 m\"; the units of length are m, cm, mm, in, ft");
}

TEST(Units, AnExponentNeedsItsDigits) {
    EXPECT_EQ(refusal("2 e", QuantityKind::mass),
              "unknown unit \"e\"; the units of mass are kg, g, t, lb, oz, slug, lb s²/in");
}

TEST(Decimals, AreExactAsWritten) {
    EXPECT_EQ(*kinegraph::read_decimal("0.1"), Exact::ratio(1, 10));
    EXPECT_EQ(*kinegraph::read_decimal("-1.25e-3"), Exact::ratio(-1, 800));
    EXPECT_EQ(*kinegraph::read_decimal("0e99999999999999999999"), Exact());
    EXPECT_EQ(*kinegraph::read_decimal("-0.0"), Exact());
    EXPECT_EQ(*kinegraph::read_decimal("100e-2"), Exact(1));
}

TEST(Decimals, OfAThousandDigitsAreRead) {
    const std::string ones(999, '1');
    const auto long_fraction = kinegraph::read_decimal("0." + ones);
    ASSERT_TRUE(long_fraction);
    // Nine times 0.111…1 is 1 − 10^-999.
    EXPECT_EQ(*long_fraction * Exact(9),
              Exact(1) - Exact(mpq_class(mpz_class(1), mpz_class("1" + std::string(999, '0')))));
    // The digits may be shifted by any exponent, as long as the value is within range.
    EXPECT_EQ(*kinegraph::read_decimal("1" + std::string(999, '0') + "e-999"), Exact(1));
    EXPECT_EQ(*kinegraph::read_decimal("0." + std::string(900, '0') + "1e901"), Exact(1));
    EXPECT_FALSE(kinegraph::read_decimal("0." + ones + "1"));
}

TEST(Decimals, ThatNoUnitSavesAreRefusedAtOnce) {
    for (const char* text : {"1e400", "1e-400000000", "1e99999999999999999999999", "-1e71", "1e-72"})
        EXPECT_FALSE(kinegraph::read_decimal(text)) << text;
    EXPECT_TRUE(kinegraph::is_within_range(exact("1e60")));
    EXPECT_TRUE(kinegraph::is_within_range(exact("-1e-60")));
    EXPECT_TRUE(kinegraph::is_within_range(Exact()));
    EXPECT_FALSE(kinegraph::is_within_range(exact("1.0001e60")));
    EXPECT_FALSE(kinegraph::is_within_range(exact("-0.9999e-60")));
}

TEST(Decimals, OtherNotationsAreRefused) {
    for (const char* text : {"", "-", ".5", "5.", "1e", "1e+", "0x10", "nan", "inf", "1_000", " 1", "--1", "1.2.3"}) {
        EXPECT_FALSE(kinegraph::read_decimal(text)) << text;
    }
}

TEST(Words, OfAUserAreShownSafely) {
    EXPECT_EQ(kinegraph::quoted("a\nb\x1b\x7f"), "\"a\\u000ab\\u001b\\u007f\"");
    EXPECT_EQ(kinegraph::quoted("\xC2\x85"), "\"\\u0085\"");
    EXPECT_EQ(kinegraph::quoted("\xFFx\xC3"), "\"\\xffx\\xc3\"");
    EXPECT_EQ(kinegraph::shown("ωωωω", 5), "ωω…");
}

TEST(Words, DistanceCountsSwapsAsOne) {
    EXPECT_EQ(kinegraph::edit_distance("spede", "speed", 2), 1U);
    EXPECT_EQ(kinegraph::edit_distance("", "ab", 2), 2U);
    EXPECT_EQ(kinegraph::edit_distance("kitten", "sitting", 3), 3U);
    EXPECT_GT(kinegraph::edit_distance("kitten", "sitting", 2), 2U);
    EXPECT_EQ(kinegraph::edit_distance("same", "same", 0), 0U);
}

}  // namespace
}  // namespace units_test
