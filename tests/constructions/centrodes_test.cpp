// Centrodes: closed forms, and that the moving one rolls on the fixed one.
#include "constructions/positions/centrodes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "constructions/positions/cycle.hpp"
#include "tests/support/files.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::centrodes_test {
namespace {

using Spot = Centrodes::Spot;

double distance(const Spot& a, const Spot& b) { return std::hypot(a.x - b.x, a.y - b.y); }

Centrodes traced(const std::string& text, const char* first, const char* second) {
    const auto mechanism = read_mechanism(text, "test.json");
    const auto pose = draw_pose(*mechanism);
    const auto cycle = Cycle::of(*mechanism, *pose, 0);
    const bool turns = std::holds_alternative<SpinDriver>(mechanism->drivers[0]);
    const Travel travel = *travel_of(cycle->positions(), turns, {}, {});
    return *trace_centrodes(*mechanism, *pose, 0, travel, *mechanism->body_named(first),
                            *mechanism->body_named(second));
}
Centrodes traced_example(const std::string& name, const char* first, const char* second) {
    return traced(tests::contents(tests::example_file(name)), first, second);
}

/// Both arcs between any two poles are as long, and where the pole is as drawn the two touch.
void expect_rolling(const Centrodes& centrodes, double size) {
    ASSERT_FALSE(centrodes.branches.empty());
    for (const Centrodes::Branch& branch : centrodes.branches) {
        double fixed = 0, moving = 0;
        for (std::size_t i = 1; i < branch.fixed.size(); ++i) {
            fixed += distance(branch.fixed[i - 1], branch.fixed[i]);
            moving += distance(branch.moving[i - 1], branch.moving[i]);
            ASSERT_GT(branch.coordinates[i], branch.coordinates[i - 1]);
            // Of two chords of arcs as long: chords differ by their curvatures alone.
            ASSERT_NEAR(fixed, moving, 2e-3 * (size + fixed)) << "at " << branch.coordinates[i];
            if (std::abs(branch.coordinates[i]) < 1e-12) {
                EXPECT_LT(distance(branch.fixed[i], branch.moving[i]), 1e-9 * size);
            }
        }
    }
}

TEST(Centrodes, OfATrammelAreCardansCircles) {
    const Centrodes centrodes = traced_example("elliptic_trammel", "1", "3");
    const double l = 0.15;
    // As drawn the moving circle is about the rod's middle, which has the guides' meet on it too.
    const Spot middle{0.06, 0.045};
    ASSERT_FALSE(centrodes.branches.empty());
    for (const Centrodes::Branch& branch : centrodes.branches)
        for (std::size_t i = 0; i < branch.fixed.size(); ++i) {
            EXPECT_NEAR(std::hypot(branch.fixed[i].x, branch.fixed[i].y), l, 1e-9 * l);
            EXPECT_NEAR(distance(branch.moving[i], middle), l / 2, 1e-9 * l);
        }
    EXPECT_TRUE(centrodes.infinities.empty());
    expect_rolling(centrodes, l);
}

TEST(Centrodes, OfAnAntiparallelogramOnItsShortLinkAreEllipses) {
    const Centrodes centrodes = traced_example("antiparallelogram", "1", "3");
    const auto& solution = tests::example("antiparallelogram");
    const auto at = [&](const char* name) {
        const Vector& place = solution.pose.at(*solution.mechanism.point_named(name));
        return Spot{place.x.to_double(), place.y.to_double()};
    };
    const double axis = 0.1;
    ASSERT_FALSE(centrodes.branches.empty());
    for (const Centrodes::Branch& branch : centrodes.branches)
        for (std::size_t i = 0; i < branch.fixed.size(); ++i) {
            // Foci at the pivots, the axis as long as a crank; the moving one is its mirror image, with foci at the
            // pins.
            EXPECT_NEAR(distance(branch.fixed[i], at("O2")) + distance(branch.fixed[i], at("O4")), axis, 1e-9);
            EXPECT_NEAR(distance(branch.moving[i], at("A")) + distance(branch.moving[i], at("B")), axis, 1e-9);
        }
    expect_rolling(centrodes, axis);
}

TEST(Centrodes, OnItsLongLinkAreHyperbolasCutAtInfinity) {
    const Centrodes centrodes = traced(R"({"kinegraph": 1, "frame": 1, "points": {"O2": [0, 0], "O4": [0.1, 0],
        "A": {"from": "O2", "distance": 0.06, "angle": 70},
        "B": {"meet": [{"circle": "A", "radius": 0.1}, {"circle": "O4", "radius": 0.06}], "side": "right"}},
        "bodies": {"2": ["O2", "A"], "3": ["A", "B"], "4": ["O4", "B"]}, "joints": [{"revolute": "O2", "bodies": [1,
        2]},
        {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B", "bodies": [3, 4]}, {"revolute": "O4", "bodies": [1, 4]}],
        "drivers": [{"body": 2, "omega": 1}]})",
                                       "1", "3");
    ASSERT_EQ(centrodes.infinities.size(), 2U);
    // The coupler's ω vanishes where crank and rocker are parallel: cos θ = a/d.
    const double drawn = 70 * std::numbers::pi / 180, parallel = std::acos(0.06 / 0.1);
    for (const double each : centrodes.infinities)
        EXPECT_NEAR(std::abs(std::cos(each + drawn)), std::cos(parallel), 1e-9);
    bool cut = false;
    for (const Centrodes::Branch& branch : centrodes.branches) {
        cut = cut || branch.goes_to_infinity || branch.comes_from_infinity;
        for (const Spot& pole : branch.fixed)
            EXPECT_NEAR(std::abs(distance(pole, {0, 0}) - distance(pole, {0.1, 0})), 0.06, 1e-7);
    }
    EXPECT_TRUE(cut);
    expect_rolling(centrodes, 0.1);
}

TEST(Centrodes, OfTwoMovingBodiesRollToo) {
    const Centrodes centrodes = traced_example("four_bar", "2", "4");
    expect_rolling(centrodes, 0.15);
}

TEST(Centrodes, StayWhereAllOfTheMotionStops) {
    // At both ends of the lever's stroke coupler and ram stand still; at infinity the pole is where the coupler alone
    // does not turn.
    const Centrodes centrodes = traced_example("quick_return", "1", "5");
    EXPECT_LE(centrodes.infinities.size(), 2U);
    for (const double each : centrodes.infinities)
        for (const double stop : {3.0295107240589, 5.3480696855137}) EXPECT_GT(std::abs(each - stop), 0.01);
}

TEST(Centrodes, OfAHingeAreAPointAndOfASlideNone) {
    const Centrodes hinge = traced_example("four_bar", "1", "2");
    for (const Centrodes::Branch& branch : hinge.branches)
        for (const Spot& pole : branch.fixed) EXPECT_LT(std::hypot(pole.x, pole.y), 1e-12);
    EXPECT_TRUE(traced_example("slider_crank", "1", "4").branches.empty());
    EXPECT_TRUE(traced_example("parallel_crank", "1", "3").branches.empty()) << "it translates";
}

}  // namespace
}  // namespace kinegraph::centrodes_test
