// Rounded data: every example turned and written in decimals, as a program would write it: of 16 digits, of 5 with the
// precision stated, and of 5 without.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "constructions/solving/solve.hpp"
#include "engine/mechanism/rounding.hpp"
#include "lang/keys/sentences.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"
#include "tests/support/turned.hpp"

namespace kinegraph::rounded_test {
namespace {

using tests::example;
using tests::example_names;

TEST(Rounded, EveryExampleIsTheSameInSixteenDigits) {
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution& as_given = example(name);
        const auto now = solve(tests::turned(as_given.mechanism, as_given.pose, 16));
        ASSERT_TRUE(now) << now.error().front().message.in(Language::en);
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
        ASSERT_TRUE(now) << now.error().front().message.in(Language::en);
        tests::expect_same_but_turned(as_given, *now, digits == 5 ? 1e-3 : 1e-9, digits == 5);
    }
    const auto bare = solve(tests::turned(as_given.mechanism, as_given.pose, 5));
    if (bare && tests::excess_over_drivers(*bare) > 1e6) {
        EXPECT_FALSE(bare->remarks.empty());
    }
    if (testing::Test::HasFailure()) std::cerr << text;
}

void hold_quarter(int quarter) {
    const auto hold_seed = [](std::uint64_t seed) {
        const RandomMechanism random = random_mechanism(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + random.recipe);
        hold(random.text);
        return true;
    };
    EXPECT_TRUE(kinegraph::hold_quarter(quarter, unless_sanitized(200, 16), hold_seed, testing::Test::HasFailure));
}

TEST(RoundedRandomMechanisms1, AreTheSame) { hold_quarter(0); }
TEST(RoundedRandomMechanisms2, AreTheSame) { hold_quarter(1); }
TEST(RoundedRandomMechanisms3, AreTheSame) { hold_quarter(2); }
TEST(RoundedRandomMechanisms4, AreTheSame) { hold_quarter(3); }

/// Places on a grid of whole millimetres, so that what is degenerate is so exactly.
class DegenerateDraw {
public:
    explicit DegenerateDraw(std::uint64_t seed) : random_(seed) {}

    /// A coupler on three equal parallel cranks: one constraint too many, and yet it moves.
    std::string three_cranks() {
        const Place arm = away(), second = turned_from(arm), third = turned_from(arm, second);
        return file(
            {{"P", {0, 0}}, {"A", arm}, {"Q", second}, {"B", sum(second, arm)}, {"R", third}, {"C", sum(third, arm)}},
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
        const std::string load = R"(, "loads": [{"force": "W", "body": 2, "at": "A", "value": [)" +
                                 std::to_string(arm.x) + ", " + std::to_string(arm.y) +
                                 R"(]}], "effort": {"couple": "M", "body": 2})";
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
            places += (places.empty() ? "\"" : ", \"") + name + "\": [" + std::to_string(at.x) + ", " +
                      std::to_string(at.y) + "]";
        return R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "points": {)" + places + R"(}, "bodies": )" +
               bodies + R"(, "joints": )" + joints + R"(, "drivers": [{"body": 2, "omega": 3, "alpha": 2}])" + more +
               "}";
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
        for (std::uint64_t seed = 0;
             seed < static_cast<std::uint64_t>(unless_sanitized(50, 4)) && !testing::Test::HasFailure(); ++seed) {
            SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
            hold((DegenerateDraw(seed).*draw)());
        }
}

TEST(Rounded, EveryExampleIsTheSameInFiveDigitsWithTheirPrecision) {
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution& as_given = example(name);
        Mechanism mechanism = tests::turned(as_given.mechanism, as_given.pose, 5);
        mechanism.precision = tests::precision_of(mechanism, 5);
        const auto now = solve(std::move(mechanism));
        ASSERT_TRUE(now) << now.error().front().message.in(Language::en);
        tests::expect_same_but_turned(as_given, *now, 1e-3);
    }
}

/// Without the key five digits are what they say: what then explodes is remarked upon.
TEST(Rounded, FiveDigitsWithoutPrecisionAreRemarkedUponWhereTheyDecide) {
    int solved = 0;
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution& as_given = example(name);
        const auto now = solve(tests::turned(as_given.mechanism, as_given.pose, 5));
        if (!now) continue;  // a contact off its profile is refused, with the misfit
        ++solved;
        EXPECT_FALSE(now->pose.is_rounded());
        if (tests::excess_over_drivers(*now) > 1e6) {
            EXPECT_FALSE(now->remarks.empty());
        }
    }
    EXPECT_GT(solved, 0);
}

// --- one by one
// --------------------------------------------------------------------------------------------------------------

std::string four_bar(const std::string& a, const std::string& b, const std::string& ground,
                     const std::string& more = "") {
    return R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "points": {"P": [0, 0], "A": )" + a +
           R"(, "B": )" + b + R"(, "Q": )" + ground +
           R"(}, "bodies": {"2": ["P", "A"], "3": ["A", "B"], "4": ["Q", "B"]},
        "joints": [{"revolute": "P", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
        {"revolute": "B", "bodies": [3, 4]}, {"revolute": "Q", "bodies": [1, 4]}], "drivers": [{"body": 2,
        "omega": 3}])" +
           more + "}";
}
/// A, B and Q on a line, turned and rounded.
std::string dead_point(const std::string& more = "") {
    return four_bar("[16.8392864073146, 47.07906576486442]", "[90.94287734426234, 51.16046384021996]",
                    "[140.3452713022275, 53.88139589045699]", more);
}

bool says(const std::vector<Message>& remarks, Key sentence) {
    return std::any_of(remarks.begin(), remarks.end(), [&](const Message& each) { return each.sentence == sentence; });
}

TEST(Rounded, ADeadPointInSixteenDigitsIsOne) {
    const Solution solution = tests::solved(dead_point());
    EXPECT_FALSE(solution.unsolved.empty());
    EXPECT_TRUE(solution.mobility.decided_by_precision);
    EXPECT_TRUE(says(solution.remarks, lang::sentences::taken_as_rounded));
}

TEST(Rounded, TakenAtItsWordItExplodesAndSaysWhy) {
    const Solution solution = tests::solved(dead_point(R"(, "precision": 0)"));
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_GT(tests::excess_over_drivers(solution), 1e12);
    EXPECT_TRUE(says(solution.remarks, lang::sentences::nearly_on_line));
}

TEST(Rounded, ANearMissIsMeasured) {
    const Solution solution = tests::solved(four_bar("[30, 40]", "[110, 40.02]", "[190, 40]"));
    ASSERT_TRUE(says(solution.remarks, lang::sentences::nearly_on_line));
    for (const Message& remark : solution.remarks) {
        if (remark.sentence != lang::sentences::nearly_on_line) continue;
        EXPECT_NEAR(std::get<Amount>(remark.arguments.at(2)).value, 0.02, 1e-9);
        EXPECT_EQ(std::get<PointName>(remark.arguments.at(0)).name, "B");
    }
    EXPECT_TRUE(says(solution.remarks, lang::sentences::is_ill_conditioned));
    const Solution far = tests::solved(four_bar("[30, 40]", "[110, 60]", "[190, 40]"));
    EXPECT_TRUE(far.remarks.empty()) << english(far.remarks.front());
}

/// ω₄ is B's speed over QB, and B's speed in proportion to 1 : sin(ABQ): a move of B across the line changes it by its
/// share.
TEST(Rounded, WhatTheLastDigitDoesIsTold) {
    const auto omega_of = [](const char* b) {
        return *tests::solved(four_bar("[30, 40]", b, "[190, 40]")).bodies.at(3).omega;
    };
    const Solution solution = tests::solved(four_bar("[30, 40]", "[110, 40.05]", "[190, 40]"));
    ASSERT_TRUE(says(solution.remarks, lang::sentences::is_ill_conditioned));
    const double now = solution.bodies.at(3).omega->to_double(), moved = omega_of("[110, 40.0501]").to_double();
    for (const Message& remark : solution.remarks) {
        if (remark.sentence != lang::sentences::is_ill_conditioned) continue;
        const double percent = std::get<Amount>(remark.arguments.at(1)).value,
                     by = std::get<Amount>(remark.arguments.at(3)).value;
        EXPECT_NEAR(percent / by, 100 * std::abs(moved / now - 1) / 0.0001, 0.05 * percent / by);
    }
}

/// With data of more digits the change is below every digit that is printed: the remark would say "changes by 1e-16 %".
TEST(Rounded, WhatNoDigitShowsIsNotTold) {
    const auto is_told = [](const char* b) {
        return says(tests::solved(four_bar("[30, 40]", b, "[190, 40]")).remarks, lang::sentences::is_ill_conditioned);
    };
    EXPECT_TRUE(is_told("[110, 40.05]"));
    for (const char* b : {"[110, 40.0500000001]", "[110, 40.050000000001]", "[110, 40.0500000000000000001]"})
        EXPECT_FALSE(is_told(b)) << b;
}

TEST(Rounded, ShiftsAreWithinThePrecisionAndLeaveWhatIsExact) {
    const auto mechanism = read_mechanism(four_bar("[30, 40.25]", "[110.5, 60]", "[190, 40]"), "test");
    ASSERT_TRUE(mechanism);
    const Exact precision = Exact::ratio(1, 100000);
    const auto at = [](const Mechanism& of, std::size_t i) { return std::get<Coordinates>(of.points[i].placement).at; };
    for (int sample = 0; sample < shifted_drawings; ++sample) {
        const Mechanism once = shifted(*mechanism, precision, Exact::ratio(1, 10000), sample),
                        again = shifted(*mechanism, precision, Exact::ratio(1, 10000), sample);
        EXPECT_EQ(at(once, 0), at(*mechanism, 0));
        EXPECT_EQ(at(once, 3), at(*mechanism, 3));
        EXPECT_EQ(at(once, 1).x, at(*mechanism, 1).x);
        const Exact move = abs(at(once, 1).y - at(*mechanism, 1).y);
        EXPECT_TRUE(2 * move >= precision && move <= precision);
        EXPECT_EQ(at(once, 1), at(again, 1));
    }
}

TEST(Rounded, APrecisionIsALengthAndFine) {
    const auto refused = [](const std::string& value) {
        auto mechanism =
            read_mechanism(four_bar("[30, 40]", "[110, 60]", "[190, 40]", R"(, "precision": )" + value), "test");
        if (!mechanism) return mechanism.error().front().where;
        auto pose = draw_pose(*mechanism);
        return pose ? std::string() : pose.error().front().where;
    };
    EXPECT_EQ(refused("0"), "");
    EXPECT_EQ(refused("\"0.001 in\""), "");
    EXPECT_EQ(refused("-1"), "/precision");
    EXPECT_EQ(refused("\"1 s\""), "/precision");
    EXPECT_EQ(refused("5"), "/precision") << "a fortieth of the drawing";
}

}  // namespace
}  // namespace kinegraph::rounded_test
