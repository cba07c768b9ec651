// Hertz's contact: published numbers and limits, agreement with the quadrature, invariance, sheets in two languages.
#include "engine/file/units.hpp"  // before signal.h, which makes a macro of si_value

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/hertz/hertz.hpp"
#include "tests/support/problem_tests.hpp"

namespace kinegraph::hertz_test {
namespace {

using std::numbers::pi;
using tests::Against;
using tests::example;

const HertzSolution& hertz_of(const Solution& solution) { return tests::found_in<HertzSolution>(solution); }

/// A contact of two bodies of E = 206 GPa, ν = 0.3 pressed by 100 N; lengths in mm.
Solution pressed(const std::string& first, const std::string& second, const std::string& more = "") {
    const std::string steel = R"(, "young": "206 GPa", "poisson": 0.3})";
    return tests::stated(
        "hertz", R"("force": 100, "bodies": {"a": {)" + first + steel + R"(, "b": {)" + second + steel + "}" + more);
}

/// The approach along a line is a closed form for (b/r)² small, and that far off.
void expect_near_check(const Solution& solution) {
    ProblemSolution others = *solution.problem;
    if (hertz_of(solution).a == 0)
        std::erase_if(others.values, [](const ProblemValue& each) {
            if (each.symbol != "δ") return false;
            EXPECT_NEAR(each.value, *each.numeric, 1e-4 * each.value);
            return true;
        });
    tests::expect_near_check(others, 1e-6, Against::itself);
}

TEST(Hertz, BallOnPlaneHasThePublishedNumbers) {
    const Solution& solution = example("contact/ball_on_plane");
    const HertzSolution& found = hertz_of(solution);
    EXPECT_NEAR(found.a, 0.188e-3, 0.0005e-3);
    EXPECT_NEAR(found.greatest, 1.353e9, 0.0005e9);
    EXPECT_NEAR(found.approach, 3.53e-6, 0.005e-6);
    // Johnson 3.45, ν = 0.3: 0.31 p₀ at 0.48 a.
    EXPECT_NEAR(found.shear / found.greatest, 0.310, 0.0005);
    EXPECT_NEAR(found.depth / found.a, 0.481, 0.0005);
}

TEST(Hertz, LineHasItsGreatestShearAtTheGoldenSection) {
    const HertzSolution found =
        hertz_of(pressed(R"("radius": 10)", R"("flat": true)", R"(, "contact": "line", "length": 20)"));
    EXPECT_NEAR(found.b, std::sqrt(4 * 100 * 0.01 / (pi * 0.02 * 206e9 / 1.82)), 1e-15);
    EXPECT_NEAR(found.shear / found.greatest, 0.30028, 1e-5);
    EXPECT_NEAR(found.depth / found.b, 0.78615, 1e-5);
    EXPECT_NEAR(found.mean / found.greatest, pi / 4, 1e-15);
}

TEST(Hertz, EllipseTendsToBothLimits) {
    const HertzSolution round = hertz_of(pressed(R"("radius": 10)", R"("flat": true)"));
    const HertzSolution nearly = hertz_of(pressed(R"("radii": [10, 10.000001])", R"("flat": true)"));
    EXPECT_NEAR(nearly.a, round.a, 1e-7 * round.a);
    EXPECT_NEAR(nearly.approach, round.approach, 1e-7 * round.approach);
    EXPECT_NEAR(nearly.shear, round.shear, 1e-6 * round.shear);
    // Long and slender, each slice is a line of contact under the load that it carries: 2Q′/πb = p₀ with b² = 4Q′R/πE*.
    const HertzSolution slender = hertz_of(pressed(R"("radii": [10, 10000000])", R"("flat": true)"));
    EXPECT_LT(slender.b / slender.a, 1e-3);
    EXPECT_NEAR(slender.greatest, slender.modulus * slender.b / (2 * 0.01), 1e-4 * slender.greatest);
    EXPECT_NEAR(slender.shear / slender.greatest, 0.3003, 1e-4);
    EXPECT_NEAR(slender.depth / slender.b, 0.786, 1e-3);
}

TEST(Hertz, CrossedEqualCylindersAreABallOnAPlane) {
    const HertzSolution crossed =
        hertz_of(pressed(R"("radii": [10, "flat"])", R"("radii": [10, "flat"])", R"(, "turned": 90)"));
    const HertzSolution ball = hertz_of(pressed(R"("radius": 10)", R"("flat": true)"));
    EXPECT_NEAR(crossed.a, ball.a, 1e-9 * ball.a);
    EXPECT_NEAR(crossed.b, ball.a, 1e-9 * ball.a);
    EXPECT_NEAR(crossed.approach, ball.approach, 1e-9 * ball.approach);
}

TEST(Hertz, NoOneCaresWhichBodyIsTheFirst) {
    const HertzSolution one =
        hertz_of(pressed(R"("radii": [10, 25])", R"("radii": [40, 30], "inside": [false, true])", R"(, "turned": 30)"));
    const HertzSolution other = hertz_of(
        pressed(R"("radii": [40, 30], "inside": [false, true])", R"("radii": [10, 25])", R"(, "turned": -30)"));
    EXPECT_NEAR(one.a, other.a, 1e-12 * one.a);
    EXPECT_NEAR(one.b, other.b, 1e-12 * one.b);
    EXPECT_NEAR(one.shear, other.shear, 1e-12 * one.shear);
}

TEST(Hertz, AgreesWithTheQuadratureOnEveryExample) {
    for (const char* name : {"ball_on_plane", "wheel_on_rail", "ball_in_race", "cylinders", "roller_in_ring"}) {
        SCOPED_TRACE(name);
        const Solution& solution = example(std::string("contact/") + name);
        expect_near_check(solution);
        EXPECT_TRUE(solution.unsolved.empty());
    }
}

TEST(Hertz, RemarksWhereTheContactIsNotSmall) {
    EXPECT_TRUE(example("contact/ball_on_plane").problem->remarks.empty());
    EXPECT_EQ(example("contact/ball_in_race").problem->remarks.size(), 1u);
}

}  // namespace
}  // namespace kinegraph::hertz_test
