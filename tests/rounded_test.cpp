// Rounded data: every example turned and written in decimals, as a program would write it: of 16 digits, of 5 with the precision
// stated, and of 5 without.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "constructions/solve.hpp"
#include "tests/random_mechanism.hpp"
#include "tests/solved.hpp"
#include "tests/told.hpp"
#include "tests/turned.hpp"

namespace kinegraph {
namespace {

using tests::example;
using tests::example_names;

TEST(Rounded, EveryExampleIsTheSameInSixteenDigits) {
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution as_given = example(name);
        const auto now = solve(tests::turned(as_given.mechanism, as_given.pose, 16));
        ASSERT_TRUE(now) << now.error().front().message;
        EXPECT_TRUE(now->pose.is_rounded());
        tests::expect_same_but_turned(as_given, *now, 1e-9);
    }
}

/// A mechanism in 16 digits, in 5 with their precision, and in 5 without.
void hold(const std::string& text) {
    const Solution as_given = tests::solved(text);
    for (const int digits : {16, 5}) {
        SCOPED_TRACE(std::to_string(digits) + " digits");
        Mechanism mechanism = tests::turned(as_given.mechanism, as_given.pose, digits);
        if (digits == 5) mechanism.precision = tests::precision_of(mechanism, digits);
        const auto now = solve(std::move(mechanism));
        ASSERT_TRUE(now) << now.error().front().message;
        tests::expect_same_but_turned(as_given, *now, digits == 5 ? 1e-3 : 1e-9, digits == 5);
    }
    const auto bare = solve(tests::turned(as_given.mechanism, as_given.pose, 5));
    if (bare && tests::excess_over_drivers(*bare) > 1e6) {
        EXPECT_FALSE(bare->remarks.empty());
    }
    if (testing::Test::HasFailure()) std::cerr << text;
}

TEST(RoundedRandomMechanisms, AreTheSame) {
    for (std::uint64_t seed = 0; seed < unless_sanitized(250, 20); ++seed) {
        const RandomMechanism random = random_mechanism(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + random.recipe);
        hold(random.text);
    }
}

/// Places on a grid of whole millimetres, so that what is degenerate is so exactly.
class DegenerateDraw {
public:
    explicit DegenerateDraw(std::uint64_t seed) : random_(seed) {}

    /// A coupler on three equal parallel cranks: one constraint too many, and yet it moves.
    std::string three_cranks() {
        const Place arm = away(), second = turned_from(arm), third = turned_from(arm, second);
        return file({{"P", {0, 0}}, {"A", arm}, {"Q", second}, {"B", sum(second, arm)}, {"R", third}, {"C", sum(third, arm)}},
                    R"({"2": ["P", "A"], "3": ["A", "B", "C"], "4": ["Q", "B"], "5": ["R", "C"]})",
                    hinges({{"P", "1, 2"}, {"Q", "1, 4"}, {"R", "1, 5"}, {"A", "2, 3"}, {"B", "3, 4"}, {"C", "3, 5"}}));
    }
    /// The same with two cranks.
    std::string parallelogram() {
        const Place arm = away(), second = turned_from(arm);
        return four_bar(arm, second, sum(second, arm));
    }
    /// Coupler and rocker on one line: the crank cannot be driven on.
    std::string dead_point() {
        const Place arm = away(), link = turned_from(arm);
        return four_bar(arm, sum(arm, times(random_.whole(3, 5), link)), sum(arm, times(2, link)));
    }
    /// Crank and coupler on one line: the rocker stands still for an instant.
    std::string limit() {
        const Place arm = away(), more = turned_from(arm);
        return four_bar(arm, sum(times(3, arm), more), times(3, arm));
    }
    /// A rod on two hinges, loaded along its line through a pin; the other links carry nothing.
    std::string load_through_pin() {
        const Place arm = away(), second = times(3, turned_from(arm));
        const std::string load = R"(, "loads": [{"force": "W", "body": 2, "at": "A", "value": [)" + std::to_string(arm.x) + ", " +
                                 std::to_string(arm.y) + R"(]}], "effort": {"couple": "M", "body": 2})";
        return four_bar(arm, second, sum(second, turned_from(second)), load);
    }

private:
    struct Place {
        int x, y;
    };
    static Place sum(Place a, Place b) { return {a.x + b.x, a.y + b.y}; }
    static Place times(int n, Place a) { return {n * a.x, n * a.y}; }
    static int across(Place a, Place b) { return a.x * b.y - a.y * b.x; }
    /// Of some length, so that nothing is short by chance.
    Place away() {
        constexpr int least = 20, most = 90;
        return {random_.whole(least, most) * (random_.chance(50) ? 1 : -1), random_.whole(least, most)};
    }
    /// Far from parallel, and from a change point.
    Place turned_from(Place a) { return turned_from(a, a); }
    Place turned_from(Place a, Place b) {
        for (;;) {
            const Place c = away();
            if (std::min(std::abs(across(a, c)), std::abs(across(b, c))) > 1500) return c;
        }
    }
    std::string four_bar(Place arm, Place ground, Place pin, const std::string& more = "") {
        return file({{"P", {0, 0}}, {"A", arm}, {"Q", ground}, {"B", pin}},
                    R"({"2": ["P", "A"], "3": ["A", "B"], "4": ["Q", "B"]})",
                    hinges({{"P", "1, 2"}, {"A", "2, 3"}, {"B", "3, 4"}, {"Q", "1, 4"}}), more);
    }
    static std::string hinges(const std::vector<std::pair<std::string, std::string>>& pins) {
        std::string all;
        for (const auto& [point, bodies] : pins)
            all += (all.empty() ? "" : ", ") + (R"({"revolute": ")" + point + R"(", "bodies": [)" + bodies + "]}");
        return "[" + all + "]";
    }
    static std::string file(const std::vector<std::pair<std::string, Place>>& points, const std::string& bodies,
                            const std::string& joints, const std::string& more = "") {
        std::string places;
        for (const auto& [name, at] : points)
            places +=
                (places.empty() ? "\"" : ", \"") + name + "\": [" + std::to_string(at.x) + ", " + std::to_string(at.y) + "]";
        return R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "points": {)" + places + R"(}, "bodies": )" + bodies +
               R"(, "joints": )" + joints + R"(, "drivers": [{"body": 2, "omega": 3, "alpha": 2}])" + more + "}";
    }

    Random random_;
};

TEST(RoundedDegenerateMechanisms, AreTheSame) {
    using Draw = std::string (DegenerateDraw::*)();
    const std::vector<std::pair<const char*, Draw>> draws{{"three cranks", &DegenerateDraw::three_cranks},
                                                          {"parallelogram", &DegenerateDraw::parallelogram},
                                                          {"dead point", &DegenerateDraw::dead_point},
                                                          {"limit", &DegenerateDraw::limit},
                                                          {"load through a pin", &DegenerateDraw::load_through_pin}};
    for (const auto& [name, draw] : draws)
        for (std::uint64_t seed = 0; seed < unless_sanitized(50, 5) && !testing::Test::HasFailure(); ++seed) {
            SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
            hold((DegenerateDraw(seed).*draw)());
        }
}

TEST(Rounded, EveryExampleIsTheSameInFiveDigitsWithTheirPrecision) {
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution as_given = example(name);
        Mechanism mechanism = tests::turned(as_given.mechanism, as_given.pose, 5);
        mechanism.precision = tests::precision_of(mechanism, 5);
        const auto now = solve(std::move(mechanism));
        ASSERT_TRUE(now) << now.error().front().message;
        tests::expect_same_but_turned(as_given, *now, 1e-3);
    }
}

/// Without the key five digits are what they say: what then explodes is remarked upon.
TEST(Rounded, FiveDigitsWithoutPrecisionAreRemarkedUponWhereTheyDecide) {
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution as_given = example(name);
        const auto now = solve(tests::turned(as_given.mechanism, as_given.pose, 5));
        if (!now) continue;  // a contact off its profile is refused, with the misfit
        EXPECT_FALSE(now->pose.is_rounded());
        if (tests::excess_over_drivers(*now) > 1e6) {
            EXPECT_FALSE(now->remarks.empty());
        }
    }
}

}  // namespace
}  // namespace kinegraph
