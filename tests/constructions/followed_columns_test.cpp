// Columns as functions over a whole travel: poles, zeros, extremes and means against closed forms, on random linkages
// with a load and on functions given by formulas.
#include "constructions/positions/followed_columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "constructions/positions/cycle.hpp"
#include "engine/mechanism/drivers.hpp"
#include "tests/support/files.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::followed_columns_test {
namespace {

constexpr double turn_ = 2 * std::numbers::pi;
constexpr double degree_ = std::numbers::pi / 180;

// --- functions given by formulas

using Formula = std::function<double(double)>;

FollowedColumn followed(const Formula& f, double from, double to, bool starts_at_limit = false,
                        bool ends_at_limit = false) {
    std::vector<FollowedCurve> curves;
    curves.emplace_back(FollowedCurve::Stretch{from, to, starts_at_limit, ends_at_limit},
                        [&](double x) -> std::optional<FollowedCurve::Values> {
                            const double value = f(x);
                            if (!std::isfinite(value)) return std::nullopt;
                            return FollowedCurve::Values{{std::abs(value) < 1e-13 ? 0 : value}};
                        });
    curves.back().sample(128);
    return FollowedColumns(std::move(curves)).column(0, true);
}

void expect_places(const std::vector<double>& found, const std::vector<double>& right, const std::string& what) {
    ASSERT_EQ(found.size(), right.size()) << what;
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], right[i], 1e-9) << what;
}

TEST(FollowedColumns, AZeroBesideAPoleIsFound) {
    // Both lie between two samples of the first pass.
    const double zero = 1.234567, pole = 1.2349;
    const FollowedColumn found = followed([&](double x) { return (x - zero) / (x - pole); }, 0, turn_);
    expect_places(found.zeros, {zero}, "zeros");
    expect_places(found.poles, {pole}, "poles");
    EXPECT_FALSE(found.least || found.greatest || found.mean);
}

TEST(FollowedColumns, APoleOfEvenOrderIsUnboundedOnOneSide) {
    const FollowedColumn found = followed([](double x) { return 1 / std::pow(std::sin(x - 1), 2) - 5; }, 0, 3);
    expect_places(found.poles, {1}, "poles");
    expect_places(found.zeros, {1 - std::asin(1 / std::sqrt(5)), 1 + std::asin(1 / std::sqrt(5))}, "zeros");
    ASSERT_TRUE(found.least.has_value());
    EXPECT_NEAR(found.least->at, 1 + std::numbers::pi / 2, 1e-9);
    EXPECT_NEAR(found.least->value, -4, 1e-12);
    EXPECT_FALSE(found.greatest || found.mean);
}

TEST(FollowedColumns, AZeroWithoutAChangeOfSignIsOne) {
    const FollowedColumn found = followed([](double x) { return 1 + std::sin(3 * x - 0.7); }, 0, turn_);
    std::vector<double> right;
    for (const double turns : {0.75, 1.75, 2.75}) right.push_back((0.7 + turns * turn_) / 3);
    expect_places(found.zeros, right, "zeros");
    EXPECT_NEAR(found.mean.value(), 1, 1e-8);
}

TEST(FollowedColumns, AStretchOfZerosAndAJumpAreNone) {
    const FollowedColumn dwell = followed([](double x) { return x < 1 ? 1 - x : x > 2 ? x - 2 : 0; }, 0, 3);
    EXPECT_TRUE(dwell.zeros.empty());
    const FollowedColumn jump = followed([](double x) { return x < 1.7 ? -1.0 : 2.0; }, 0, 3);
    EXPECT_TRUE(jump.zeros.empty());
    EXPECT_TRUE(jump.poles.empty());
    ASSERT_TRUE(jump.least && jump.greatest);
    EXPECT_EQ(jump.least->value, -1);
    EXPECT_EQ(jump.greatest->value, 2);
}

TEST(FollowedColumns, WhatGrowsAtALimitIsAPoleThereAndItsMeanAtAFreeEndIsFound) {
    const FollowedColumn found =
        followed([](double x) { return (x - 0.3) / std::sqrt((1 - x) * (1 + x)); }, -1, 1, true, true);
    expect_places(found.poles, {-1, 1}, "poles");
    expect_places(found.zeros, {0.3}, "zeros");
    EXPECT_FALSE(found.least || found.greatest);
    const FollowedColumn arc = followed([](double x) { return std::sqrt((1 - x) * (1 + x)); }, -1, 1, true, true);
    EXPECT_TRUE(arc.poles.empty());
    EXPECT_NEAR(arc.mean.value(), std::numbers::pi / 4, 1e-7);
    EXPECT_NEAR(arc.greatest.value().at, 0, 1e-9);
}

TEST(FollowedColumns, WhatIsNegativeIsFoundFromWhereToWhere) {
    std::vector<FollowedCurve> curves;
    for (const auto& [from, to] : {std::pair(0.0, 3.0), std::pair(3.0, 6.0)}) {
        curves.emplace_back(FollowedCurve::Stretch{from, to},
                            [](double x) { return std::optional(FollowedCurve::Values{{std::cos(x) + 0.5}}); });
        curves.back().sample(64);
    }
    const auto found = FollowedColumns(std::move(curves)).negative(0);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].first, turn_ / 3, 1e-12);
    EXPECT_NEAR(found[0].second, 2 * turn_ / 3, 1e-12);
}

// --- linkages

struct Swept {
    std::unique_ptr<Mechanism> mechanism;
    std::unique_ptr<Pose> pose;
    std::optional<Cycle> cycle;
    Travel travel;

    std::size_t column(const std::string& name) const {
        const auto& all = cycle->columns();
        const auto found = std::find_if(all.begin(), all.end(), [&](const Column& each) { return each.name == name; });
        EXPECT_NE(found, all.end()) << name;
        return static_cast<std::size_t>(found - all.begin());
    }
    FollowedColumn followed(const std::string& name) {
        const std::size_t i = column(name);
        return cycle->follow(travel, {i}).columns[i];
    }
};
Swept swept_file(const std::string& text, std::optional<double> from = {}, std::optional<double> to = {}) {
    Swept made;
    made.mechanism = std::make_unique<Mechanism>(read_mechanism(text, "test.json").value());
    made.pose = std::make_unique<Pose>(*draw_pose(*made.mechanism));
    auto cycle = Cycle::of(*made.mechanism, *made.pose, 0);
    if (!cycle) throw std::runtime_error(cycle.error().front().message.in(Language::en));
    made.cycle.emplace(*std::move(cycle));
    made.travel = *travel_of(made.cycle->positions(), turns(made.mechanism->drivers[0]), from, to);
    made.cycle->begin(made.travel);
    return made;
}

/// A length or an angle as in people's files: a short decimal, which a file means exactly.
double short_number(Random& random, double least, double most) {
    return random.whole(static_cast<int>(least * 1000), static_cast<int>(most * 1000)) / 1000.0;
}
std::string number_text(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.15g", value);
    return text.data();
}
/// The angles that are equal to one of `angles` (rad) but for whole turns, from 0 to a turn, in order.
std::vector<double> within_a_turn(std::vector<double> angles) {
    for (double& each : angles) each -= turn_ * std::floor(each / turn_);
    std::sort(angles.begin(), angles.end());
    return angles;
}

/// A crank-rocker O A B Q with an effort on one of the links at the frame and a couple on the other.
struct FourBar {
    double crank, rod, rocker, base, drawn;

    static FourBar random(Random& random) {
        const auto number = [&](double least, double most) { return short_number(random, least, most); };
        while (true) {
            FourBar bar{number(0.5, 1.5), number(2, 5), number(2, 5), number(2, 5), number(5, 355)};
            const double longest = std::max({bar.rod, bar.rocker, bar.base});
            const double others = bar.rod + bar.rocker + bar.base - longest;
            if (bar.crank + longest < others - 0.2) return bar;
        }
    }
    std::string text(const std::string& effort_on, const std::string& couple_on) const {
        return R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "Q": [)" + number_text(base) +
               R"(, 0], "A": {"from": "O", "distance": )" + number_text(crank) + R"(, "angle": )" + number_text(drawn) +
               R"(}, "B": {"meet": [{"circle": "A", "radius": )" + number_text(rod) +
               R"(}, {"circle": "Q", "radius": )" + number_text(rocker) +
               R"(}], "side": "left"}}, "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B", "Q"]},
            "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
            {"revolute": "B", "bodies": [3, 4]}, {"revolute": "Q", "bodies": [4, 1]}],
            "drivers": [{"body": 2, "omega": 1}], "loads": [{"couple": "C", "body": )" +
               couple_on + R"(, "value": 7}], "effort": {"couple": "M", "body": )" + effort_on + "}}";
    }
    /// The crank's angles at which crank and rod are in line: there the rocker rests.
    std::vector<double> dead_points() const {
        std::vector<double> at;
        for (const double way : {rod + crank, rod - crank}) {
            const double away = std::acos((base * base + way * way - rocker * rocker) / (2 * base * way));
            // B to the left of A → Q, above the frame's line.
            at.push_back((way > rod ? away : away + turn_ / 2) - drawn * degree_);
        }
        return within_a_turn(at);
    }
};

TEST(FollowedColumns, AnEffortOnTheRockerHasItsPolesWhereTheRockerRests) {
    Random random(7);
    for (int i = 0; i < unless_sanitized(250, 10) && !testing::Test::HasFailure(); ++i) {
        const FourBar bar = FourBar::random(random);
        SCOPED_TRACE(bar.text("4", "2"));
        Swept with_poles = swept_file(bar.text("4", "2"));
        const FollowedColumn effort = with_poles.followed("effort M");
        expect_places(effort.poles, bar.dead_points(), "poles");
        EXPECT_TRUE(effort.zeros.empty());
        EXPECT_FALSE(effort.mean || effort.least || effort.greatest);
        // The other way round it is zero there; over a whole turn the couple does no work.
        Swept with_zeros = swept_file(bar.text("2", "4"));
        const FollowedColumn driving = with_zeros.followed("effort M");
        expect_places(driving.zeros, bar.dead_points(), "zeros");
        EXPECT_TRUE(driving.poles.empty());
        EXPECT_NEAR(driving.mean.value(), 0, 1e-7);
    }
}

/// A slider-crank whose slider is loaded along its guide; a force at the crank's pin, in a fixed direction, balances.
TEST(FollowedColumns, TheEffortOfASliderCrankHasThePolesAndZerosOfItsClosedForm) {
    Random random(11);
    for (int i = 0; i < unless_sanitized(250, 10) && !testing::Test::HasFailure(); ++i) {
        const auto number = [&](double least, double most) { return short_number(random, least, most); };
        const double crank = number(0.5, 1.5), rod = number(3, 5), offset = number(-0.6, 0.6);
        const double drawn = number(0, 360), along = number(0, 360);
        const std::string text =
            R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "G": [0, )" + number_text(offset) +
            R"(], "A": {"from": "O", "distance": )" + number_text(crank) + R"(, "angle": )" + number_text(drawn) +
            R"(}, "B": {"meet": [{"circle": "A", "radius": )" + number_text(rod) +
            R"(}, {"line": "G", "angle": 0}], "near": [10, 0]}}, "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
            "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
            {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": 0}],
            "drivers": [{"body": 2, "omega": 1}], "loads": [{"force": "P", "body": 4, "at": "B", "value": [3, 0]}],
            "effort": {"force": "F", "body": 2, "at": "A", "along": )" +
            number_text(along) + "}}";
        SCOPED_TRACE(text);
        Swept s = swept_file(text);
        const FollowedColumn effort = s.followed("effort F");
        // The velocity of A, square to the crank, is square to the force; that of B vanishes at its dead points.
        const double start = drawn * degree_, line = along * degree_;
        expect_places(effort.poles, within_a_turn({line - start, line + turn_ / 2 - start}), "poles");
        expect_places(effort.zeros,
                      within_a_turn({std::asin(offset / (rod + crank)) - start,
                                     turn_ / 2 + std::asin(offset / (rod - crank)) - start}),
                      "zeros");
    }
}

TEST(FollowedColumns, ARowOnAPoleHasAnEmptyCellAndTheOthersStay) {
    Swept s = swept_file(R"({"kinegraph": 1, "points": {"O": [0,0], "H": {"from": "O", "distance": 1, "angle": 30}},
        "bodies": {"2": ["O","H"]}, "joints": [{"revolute": "O", "bodies": [0,2]}], "frame": 0,
        "drivers": [{"body": 2, "omega": 1}], "loads": [{"couple": "C", "body": 2, "value": 10}],
        "effort": {"force": "F", "body": 2, "at": "H", "along": 90}})");
    expect_places(s.followed("effort F").poles, {60 * degree_, 240 * degree_}, "poles");
    const auto row = s.cycle->row(60 * degree_);
    ASSERT_TRUE(row.has_value());
    const std::vector<bool>& empty = s.cycle->empty_cells();
    EXPECT_TRUE(empty[s.column("effort F")] && empty[s.column("Fy O 2 on 0")]);
    EXPECT_FALSE(empty[s.column("Fx O 2 on 0")] || empty[s.column("vx H")]);
    EXPECT_NEAR((*row)[s.column("vx H")], -1, 1e-9);
    EXPECT_EQ((*row)[s.column("vy H")], 0);
    EXPECT_NEAR((*row)[s.column("angle 2")], 90 * degree_, 1e-15);
    ASSERT_TRUE(s.cycle->row(61 * degree_).has_value());
    EXPECT_EQ(std::count(s.cycle->empty_cells().begin(), s.cycle->empty_cells().end(), true), 0);
}

TEST(FollowedColumns, FollowingLeavesTheRowsAsTheyWere) {
    const std::string text = tests::contents(tests::example_file("four_bar_weights"));
    Swept plain = swept_file(text), after = swept_file(text);
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < after.cycle->columns().size(); ++i) all.push_back(i);
    after.cycle->follow(after.travel, all);
    for (int k = 0; k <= 36; ++k) {
        const auto a = plain.cycle->row(plain.travel.at(k / 36.0)), b = after.cycle->row(after.travel.at(k / 36.0));
        ASSERT_TRUE(a && b);
        EXPECT_TRUE(std::equal(a->begin(), a->end(), b->begin(), b->end())) << k;
    }
}

TEST(FollowedColumns, TheExtremesAreNowhereExceeded) {
    for (const std::string name : {"four_bar_weights", "engine_inertia_gas", "whitworth", "watt_six_bar"}) {
        Swept s = swept_file(tests::contents(tests::example_file(name)));
        std::vector<std::size_t> all;
        for (std::size_t i = 2; i < s.cycle->columns().size(); ++i) all.push_back(i);
        const FollowedCycle found = s.cycle->follow(s.travel, all);
        for (int k = 0; k <= 997; ++k) {
            const auto row = s.cycle->row(s.travel.at(k / 997.0));
            for (std::size_t i = 2; row && i < row->size(); ++i) {
                const FollowedColumn& column = found.columns[i];
                ASSERT_TRUE(column.is_followed);
                const double rounding = 1e-9 * (1 + std::abs((*row)[i]));
                if (column.least) {
                    EXPECT_GE((*row)[i], column.least->value - rounding) << name << s.cycle->columns()[i].name;
                }
                if (column.greatest) {
                    EXPECT_LE((*row)[i], column.greatest->value + rounding) << name << s.cycle->columns()[i].name;
                }
            }
        }
    }
}

TEST(FollowedColumns, AnEccentricLiftsOffWhereItsSpringIsTooWeak) {
    const double e = 0.015, mass = 0.9, k = 1000, omega = 500 * turn_ / 60;
    Swept s = swept_file(R"({"kinegraph": 1, "units": {"length": "mm", "angular velocity": "rpm"}, "frame": 0,
        "points": {"O": [0, 0], "C": [15, 0], "P": [15, 40], "F": [0, 40], "H": [0, 75], "K": [0, 160]},
        "bodies": {"2": {"points": ["O", "C"], "circle": {"centre": "C", "radius": 40}}, "3": ["F", "H"], "0": ["K"]},
        "joints": [{"revolute": "O", "bodies": [0, 2]},
        {"contact": "P", "bodies": [3, 2], "profiles": {"3": {"line": 0}}, "pushes": [0, 1]},
        {"prismatic": "H", "bodies": [3, 0], "along": 90}], "drivers": [{"body": 2, "omega": 500}],
        "masses": {"3": {"mass": 0.9, "centre": "H"}}, "inertia forces": true,
        "loads": [{"spring": "S", "bodies": [3, 0], "between": ["H", "K"], "stiffness": 1000, "free length": 102.5}],
        "effort": {"couple": "M", "body": 2}})");
    // F = k (17.5 mm + e sin φ) − m ω² e sin φ, since the spring is 85 mm − e sin φ long.
    const double at = std::asin(k * 0.0175 / (e * (mass * omega * omega - k)));
    const FollowedCycle& found = s.cycle->follow(s.travel, {});
    ASSERT_EQ(found.separations.size(), 1u);
    EXPECT_NEAR(found.separations[0].from, at, 1e-9);
    EXPECT_NEAR(found.separations[0].to, turn_ / 2 - at, 1e-9);
}

TEST(FollowedColumns, WhatBalancesInEveryPositionIsZero) {
    Swept s = swept_file(R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 0,
        "points": {"O": [0, 0], "H": [0, 100], "S": {"from": "O", "distance": 80, "angle": 25},
        "G": {"from": "O", "distance": 400, "angle": 25}}, "bodies": {"2": ["O", "S", "G"], "0": ["H"]},
        "joints": [{"revolute": "O", "bodies": [0, 2]}], "masses": {"2": {"mass": 2, "centre": "G"}},
        "gravity": [0, -9.81], "drivers": [{"body": 2, "omega": 1}],
        "loads": [{"spring": "S", "bodies": [2, 0], "between": ["S", "H"], "stiffness": 981, "free length": 0}],
        "effort": {"couple": "M", "body": 2}, "find": ["forces"]})");
    const std::size_t effort = s.column("effort M");
    for (int k = 0; k <= 50; ++k) {
        const auto row = s.cycle->row(turn_ * k / 50);
        ASSERT_TRUE(row.has_value());
        EXPECT_EQ((*row)[effort], 0);
    }
    EXPECT_LT(s.cycle->difference().share, 1e-12);
}

}  // namespace
}  // namespace kinegraph::followed_columns_test
