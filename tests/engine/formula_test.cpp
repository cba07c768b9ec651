// Formulas: exact laws, dimensions, what is refused, random expressions against the same sums done in doubles; and what
// they make of a mechanism.
#include "engine/file/formula.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph::formula_test {
namespace {

Exact exact(std::string_view decimal) { return *Exact::from_decimal(decimal); }

tl::expected<Measured, Words> look_up(std::string_view name) {
    if (name == "r") return read_measured("40 mm", look_up);
    if (name == "phi") return read_measured("60°", look_up);
    if (name == "omega") return read_measured("120 rpm", look_up);
    if (name == "k") return bare(Exact(3));
    return tl::make_unexpected(Words(std::string("unknown")));
}

/// As a quantity in SI; the formula must be one.
Exact si(const std::string& formula, QuantityKind kind) {
    const auto value = evaluate(formula, look_up);
    EXPECT_TRUE(value) << formula << ": " << value.error().in(Language::en);
    if (!value) return {};
    const auto quantity = as_quantity(*value, kind, default_unit(kind));
    EXPECT_TRUE(quantity) << formula << ": " << quantity.error().in(Language::en);
    return quantity ? quantity->in_si() : Exact();
}

Exact number(const std::string& formula) {
    const auto value = evaluate(formula, look_up);
    EXPECT_TRUE(value) << formula << ": " << value.error().in(Language::en);
    return value ? value->value : Exact();
}

std::string refusal(const std::string& formula, QuantityKind kind = QuantityKind::length) {
    const auto value = evaluate(formula, look_up);
    if (!value) return value.error().in(Language::en);
    const auto quantity = as_quantity(*value, kind, default_unit(kind));
    EXPECT_FALSE(quantity) << formula;
    return quantity ? "" : quantity.error().in(Language::en);
}

TEST(Formula, IsExactWhereItIsRational) {
    EXPECT_EQ(number("= 0.1 + 0.2"), exact("0.3"));
    EXPECT_EQ(number("= 1/3*3"), Exact(1));
    EXPECT_EQ(number("= -2^2"), Exact(-4));
    EXPECT_EQ(number("= 2^-2 * 2^3^2"), Exact(128));
    EXPECT_EQ(number("= 2 - -3 - 4"), Exact(1));
    EXPECT_EQ(number("= sqrt(9/4)"), Exact::ratio(3, 2));
    EXPECT_EQ(number("= 8^(2/3)"), Exact(4));
    EXPECT_EQ(number("= sin(30°) + cos(60°) + tan(45°) + sin(270°)"), Exact(1));
    EXPECT_EQ(number("= sin(pi/6)"), Exact::ratio(1, 2));
    EXPECT_EQ(number("= cos(-720°) - sin(150°)"), Exact::ratio(1, 2));
    EXPECT_EQ(number("= max(1, k, 2) - min(k, 5) + abs(-7)"), Exact(7));
    EXPECT_EQ(si("= 2*r + 10 mm", QuantityKind::length), exact("0.09"));
    EXPECT_EQ(si("= atan2(-r, r)", QuantityKind::angle), -pi() / 4);
    EXPECT_EQ(si("= omega", QuantityKind::angular_velocity), 4 * pi());
}

TEST(Formula, IsWithinTheCompassElsewhere) {
    const Exact off = abs(square(number("= sqrt(2)")) - 2);
    EXPECT_LT(off, Exact::power_of_two(-198));
    const Exact circle = square(number("= sin(17°)")) + square(number("= cos(17°)")) - 1;
    EXPECT_LT(abs(circle), Exact::power_of_two(-198));
    const Exact back = si("= atan2(r*sin(17°), r*cos(17°))", QuantityKind::angle) - si("= 17°", QuantityKind::angle);
    EXPECT_LT(abs(back), Exact::power_of_two(-198));
    EXPECT_TRUE(evaluate("= sqrt(2)", look_up)->is_approximate);
    EXPECT_FALSE(evaluate("= sqrt(4)*sin(30°)", look_up)->is_approximate);
}

TEST(Formula, CarriesDimensions) {
    EXPECT_EQ(si("= omega*r", QuantityKind::velocity), 4 * pi() * exact("0.04"));
    EXPECT_EQ(si("= omega^2*r + 1 m/s^2", QuantityKind::acceleration), square(4 * pi()) * exact("0.04") + 1);
    EXPECT_EQ(si("= 2 kg * 3 m/s² * r", QuantityKind::moment), exact("0.24"));
    EXPECT_EQ(si("= (1 m/s)/r", QuantityKind::angular_velocity), Exact(25));
    EXPECT_EQ(si("= r*phi", QuantityKind::length), exact("0.04") * pi() / 3) << "an arc: its angle in radians";
    EXPECT_EQ(si("= phi + pi/2", QuantityKind::angle), 5 * pi() / 6);
    EXPECT_EQ(si("= pi/2", QuantityKind::angle), pi() / 2);
    EXPECT_EQ(si("= 30", QuantityKind::angle), pi() / 6) << "a bare number is in the file's unit";
    EXPECT_EQ(si("= 2 N m", QuantityKind::moment), Exact(2));
    EXPECT_EQ(si("= sqrt(r^2 + (3*r)^2 - r^2)", QuantityKind::length), exact("0.12"));
}

TEST(Formula, SaysWhatIsWrong) {
    EXPECT_EQ(refusal("= r + phi"), "a length and an angle do not go together in a sum");
    EXPECT_EQ(refusal("= r - 3"),
              "a length and a bare number do not go together in a difference; the bare number wants a unit");
    EXPECT_EQ(refusal("= r*r"), "the formula gives a quantity in m^2; a length is wanted here");
    EXPECT_EQ(refusal("= r*omega^2"), "the formula gives a quantity in m rad^2/s^2; a length is wanted here");
    EXPECT_EQ(refusal("= r/(k - 3)"), "the formula divides by zero");
    EXPECT_EQ(refusal("= (k-3)^-1*r"), "the formula divides by zero");
    EXPECT_EQ(refusal("= sqrt(-1)*r"), "the root of a negative value is not real");
    EXPECT_EQ(refusal("= sin(r)*r"), "sin is taken of an angle, not of a length");
    EXPECT_EQ(refusal("= 2^r"), "an exponent must be a bare number, not a length");
    EXPECT_EQ(refusal("= 10^303*r"), "a value of the formula lies outside 1e-300 … 1e300");
    EXPECT_EQ(refusal("= 2 x"), "unknown unit \"x\"");
    EXPECT_EQ(refusal("= 2 r + 60 mm"), "a product is written with *: 2*r, not 2 r");
    EXPECT_EQ(refusal("= 2.5 pi * r"), "a product is written with *: 2.5*pi, not 2.5 pi");
    EXPECT_EQ(refusal("= k r"), "a product is written with *: …*r, not … r");
    EXPECT_EQ(refusal("= (k + 1) sin(phi) * r"), "a product is written with *: …*sin, not … sin");
    EXPECT_EQ(refusal("= 4*pi rad/s"), "a unit stands behind a number: write … * 1 rad/s");
    EXPECT_EQ(refusal("= (k + 1) mm"), "a unit stands behind a number: write … * 1 mm");
    EXPECT_EQ(si("= 4*pi * 1 rad/s", QuantityKind::angular_velocity), 4 * pi());
    EXPECT_EQ(refusal("= (r"), "a bracket is not closed");
    EXPECT_EQ(refusal("= r − 1 mm"), "a minus is written \"-\" in a formula");
    EXPECT_EQ(refusal("= atan2(r)"), "atan2 is written atan2(y, x), with two values between the brackets");
    for (const char* text :
         {"=", "= +", "= )", "= r,", "= r k", "= .5*r", "= 2**3", "= sin", "= min()", "= \xC3", "= \xCE"})
        EXPECT_FALSE(evaluate(text, look_up)) << text;
    EXPECT_FALSE(evaluate("= " + std::string(100000, '(') + "1", look_up));
    EXPECT_FALSE(evaluate("= " + std::string(100000, '-'), look_up));
}

/// A random expression: its text, and its value as doubles have it.
class Expressions {
public:
    explicit Expressions(unsigned seed) : random_(seed) {}
    std::pair<std::string, double> next(int depth) {
        if (depth == 0 || choice(5) == 0) {
            const int tenths = 1 + choice(99);
            return {std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10), tenths / 10.0};
        }
        const auto [a, x] = next(depth - 1);
        const auto [b, y] = next(depth - 1);
        switch (choice(9)) {
            case 0: return {'(' + a + " + " + b + ')', x + y};
            case 1: return {'(' + a + " - " + b + ')', x - y};
            case 2: return {a + '*' + b, x * y};
            case 3: return {'(' + a + ")/(1 + abs(" + b + "))", x / (1 + std::abs(y))};
            case 4: return {"sqrt(abs(" + a + "))", std::sqrt(std::abs(x))};
            case 5: return {"sin(" + a + ')', std::sin(x)};
            case 6: return {"tan(atan2(" + a + ", 1 + abs(" + b + ")))", x / (1 + std::abs(y))};
            case 7: return {"max(" + a + ", " + b + ')', std::max(x, y)};
            default: return {"-(" + a + ")^2", -x * x};
        }
    }

private:
    int choice(int of) { return static_cast<int>(random_() % static_cast<unsigned>(of)); }
    std::mt19937 random_;
};

TEST(Formula, AgreesWithAnIndependentEvaluation) {
    constexpr int expressions = 1000;
    Expressions some(20261122);
    for (int i = 0; i < expressions; ++i) {
        const auto [text, value] = some.next(4);
        const auto found = evaluate("= " + text, look_up);
        ASSERT_TRUE(found) << text << ": " << found.error().in(Language::en);
        // What doubles lose in five levels, the sines of large arguments among them.
        EXPECT_NEAR(found->value.to_double(), value, 1e-9 * (1 + std::abs(value))) << text;
    }
}

TEST(Formula, IsZeroWhereRootsAndSinesCancel) {
    for (const char* const text :
         {"= cos(45°) - sqrt(2)/2", "= r*cos(30°) - r*sqrt(3)/2", "= r*(sin(phi)^2 + cos(phi)^2 - 1)",
          "= sqrt(1 - sin(17°)^2 - cos(17°)^2)", "= sqrt(cos(45°) - sqrt(2)/2)", "= (sqrt(2)/2 - cos(45°))^(1/3)",
          "= sqrt(3 + 2*sqrt(2)) - 1 - sqrt(2)", "= 1e12*(sqrt(5)^2 - 5)", "= sin(8*atan2(1, 2) + 8*atan2(1, 3))",
          "= atan2(sqrt(2) - 2*cos(45°), r/(1 mm)) * 1 mm", "= 1e-40*(sqrt(2) - 2*cos(45°))"})
        EXPECT_EQ(number(text), Exact()) << text;
    EXPECT_EQ(si("= atan2(sqrt(2) - 2*cos(45°), -1)", QuantityKind::angle), pi()) << "not −π for the digits of a root";
    EXPECT_LT(abs(number("= 3^(4*cos(60.5°)^2 + 4*sin(60.5°)^2)") - 81), exact("1e-99")) << "an exponent that is 4";
    EXPECT_EQ(refusal("= r/(cos(45°) - sqrt(2)/2)"), "the formula divides by zero");
    EXPECT_EQ(refusal("= r*(sqrt(2) - 2*cos(45°))^-1"), "the formula divides by zero");
    EXPECT_EQ(refusal("= r*tan(2*atan2(1, 2) + 2*atan2(1, 3))"), "tan of a right angle has no value");
    EXPECT_EQ(refusal("= r*atan2(sqrt(2) - 2*cos(45°), 0)"), "atan2(0, 0) has no value");
}

TEST(Formula, IsNotZeroWhereItIsSmall) {
    EXPECT_LT(abs(number("= sqrt(2) - 2*cos(45°) + 1e-40") - exact("1e-40")), exact("1e-99"));
    EXPECT_LT(abs(number("= sqrt(1 + 1e-50) - 1") - exact("5e-51")), exact("1e-99"));
    EXPECT_LT(abs(number("= 1e-60/(sqrt(2) - 2*cos(45°) + 1e-60)") - 1), exact("1e-59"));
    EXPECT_LT(abs(number("= sin(1e-40)") - exact("1e-40")), exact("1e-99"));
    EXPECT_EQ(refusal("= sqrt(2*cos(45°) - sqrt(2) - 1e-40)*r"), "the root of a negative value is not real");
}

/// Identities of random numbers: what is zero is so to the last bit, and what is beside it is not.
TEST(Formula, HasNoDigitsWhereAnIdentityHolds) {
    constexpr int identities = 200;
    Expressions some(20261125);
    for (int i = 0; i < identities; ++i) {
        const std::string a = "(" + some.next(2).first + ")", b = "(" + some.next(2).first + ")";
        for (const std::string& zero :
             {"sin(" + a + ")^2 + cos(" + a + ")^2 - 1", "tan(" + a + ")*cos(" + a + ") - sin(" + a + ")",
              "sqrt(" + a + "^2) - abs(" + a + ")", "sqrt(1 + " + a + "^2)^2 - 1 - " + a + "^2",
              "sin(" + a + " + " + b + ") - sin(" + a + ")*cos(" + b + ") - cos(" + a + ")*sin(" + b + ")",
              "tan(atan2(" + a + ", 1 + abs(" + b + "))) - " + a + "/(1 + abs(" + b + "))"}) {
            EXPECT_EQ(number("= " + zero), Exact()) << zero;
            EXPECT_LT(abs(number("= 1e-40 + " + zero) - exact("1e-40")), exact("1e-99")) << zero;
        }
    }
}

constexpr const char* crank = R"json({
  "kinegraph": 1, "units": {"length": "mm"},
  "parameters": {"r": "40 mm", "phi": "= turn*5", "turn": "12°", "k": 3, "l": "= k*r + 30 mm"},
  "points": {"O": [0, 0], "A": ["= r*cos(phi)", "= r*sin(phi)"], "C": ["= l", 0],
             "B": {"meet": [{"circle": "A", "radius": "= l"}, {"circle": "C", "radius": "= 2*r"}], "side": "left"}},
  "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["C", "B"]},
  "joints": [{"revolute": "O", "bodies": [0, 2]}, {"revolute": "A", "bodies": [2, 3]},
             {"revolute": "B", "bodies": [3, 4]}, {"revolute": "C", "bodies": [0, 4]}],
  "drivers": [{"body": 2, "omega": "= -k*4*pi/3 * 1 rad/s"}]})json";

TEST(Parameters, StandInPlaceOfNumbers) {
    const auto mechanism = read_mechanism(crank, "crank.json");
    ASSERT_TRUE(mechanism) << mechanism.error().front().message.in(Language::en);
    const auto pose = draw_pose(*mechanism);
    ASSERT_TRUE(pose);
    EXPECT_TRUE(pose->remarks.empty()) << "digits of a root are no rounded data";
    const Vector a = pose->at(*mechanism->point_named("A"));
    EXPECT_NEAR(a.x.to_double(), 0.02, 1e-15);
    EXPECT_NEAR(a.y.to_double(), 0.04 * std::sqrt(3.0) / 2, 1e-15);
    EXPECT_EQ(pose->at(*mechanism->point_named("C")).x, exact("0.15"));
}

TEST(Parameters, AreSetFromOutside) {
    const std::vector<Setting> set{{"r", "45mm"}, {"k", "2"}, {"turn", "=3*2°"}};
    const auto mechanism = read_mechanism(crank, "crank.json", set);
    ASSERT_TRUE(mechanism) << mechanism.error().front().message.in(Language::en);
    const auto pose = draw_pose(*mechanism);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->at(*mechanism->point_named("C")).x, exact("0.12"));
    EXPECT_NEAR(pose->at(*mechanism->point_named("A")).x.to_double(), 0.045 * std::sqrt(3.0) / 2, 1e-15);
    const auto wrong = read_mechanism(crank, "crank.json", std::vector<Setting>{{"rr", "1"}});
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().front().message.in(Language::en),
              "--set \"rr\": the file has no parameter named \"rr\" (did you mean \"r\"?)");
}

/// A coordinate that a root makes zero is zero in the pose, and a mechanism with it is read.
TEST(Parameters, MayCancelToZero) {
    constexpr const char* file = R"json({
      "kinegraph": 1, "units": {"length": "mm"}, "parameters": {"r": "40 mm", "phi": "30°", "d": "= r*sqrt(3)/2"},
      "points": {"O": [0, 0], "A": ["= r*cos(phi)", "= r*sin(phi)"], "C": ["= r*cos(phi) - d",
      "= r*(sin(phi)^2 + cos(phi)^2 - 1)"]},
      "bodies": {"2": ["O", "A", "C"]}, "joints": [{"revolute": "O", "bodies": [0, 2]}], "drivers": [{"body": 2,
      "omega": 1}]})json";
    const auto mechanism = read_mechanism(file, "zero.json");
    ASSERT_TRUE(mechanism) << mechanism.error().front().message.in(Language::en);
    const auto pose = draw_pose(*mechanism);
    ASSERT_TRUE(pose);
    EXPECT_TRUE(pose->at(*mechanism->point_named("C")).is_zero());
}

}  // namespace
}  // namespace kinegraph::formula_test
