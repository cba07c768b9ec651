// Finite displacements of a body: poles, angles and fixed pivots, exactly and against complex numbers; places that are
// moved or refused.
#include "engine/file/units.hpp"  // before signal.h, which makes a macro of si_value

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "problems/positions/positions.hpp"
#include "tests/support/problem_tests.hpp"

namespace kinegraph::positions_of_a_body_test {
namespace {

using std::numbers::pi;
using tests::example;

const PositionsSolution& positions_of(const Solution& solution) { return tests::found_in<PositionsSolution>(solution); }
Solution placed(const std::string& positions) {
    return tests::solved(R"~({"kinegraph": 1, "positions": [)~" + positions + "]}");
}

TEST(Displacements, PoleIsEquallyFarFromBothPositions) {
    const Displacement found = positions_of(example("motion/displacement")).displacements.at(0);
    EXPECT_EQ(found.kind, Displacement::Kind::general);
    // A quarter turn, A (0, 0) → (60, 20) mm: the pole is (20, 40) mm, exactly.
    EXPECT_EQ(*found.pole, (Vector{Exact::ratio(20, 1000), Exact::ratio(40, 1000)}));
    EXPECT_NEAR(found.angle, pi / 2, 1e-15);
}

TEST(Displacements, AllKindsAreTold) {
    const auto only = [](const std::string& positions) { return positions_of(placed(positions)).displacements.at(0); };
    using Kind = Displacement::Kind;
    using By = Displacement::By;
    EXPECT_EQ(only(R"~({"A": [0, 0], "B": [1, 0]}, {"A": [0, 0], "B": [1, 0]})~").kind, Kind::rest);
    EXPECT_EQ(only(R"~({"A": [0, 0], "B": [1, 0]}, {"A": [2, 3], "B": [3, 3]})~").kind, Kind::translation);
    // Along AB: one bisector each, parallel; across AB: one and the same.
    EXPECT_EQ(only(R"~({"A": [0, 0], "B": [1, 0]}, {"A": [5, 0], "B": [6, 0]})~").kind, Kind::translation);
    EXPECT_EQ(only(R"~({"A": [0, 0], "B": [1, 0]}, {"A": [0, 4], "B": [1, 4]})~").kind, Kind::translation);
    const Displacement about = only(R"~({"A": [0, 0], "B": [1, 0]}, {"A": [0, 0], "B": [0, 1]})~");
    EXPECT_EQ(about.kind, Kind::rotation);
    EXPECT_TRUE(about.pole->is_zero());
    EXPECT_NEAR(about.angle, pi / 2, 1e-15);
    // Mirror images of each other: the bisectors coincide, the joins meet in (0, 2).
    const Displacement mirrored = only(R"~({"A": [-1, 1], "B": [-2, 0]}, {"A": [1, 1], "B": [2, 0]})~");
    EXPECT_EQ(mirrored.by, By::joins);
    EXPECT_EQ(*mirrored.pole, (Vector{0, 2}));
    // All on one line, about the common middle.
    const Displacement half = only(R"~({"A": [0, 0], "B": [1, 0]}, {"A": [3, 0], "B": [2, 0]})~");
    EXPECT_EQ(half.by, By::middle);
    EXPECT_EQ(*half.pole, (Vector{Exact::ratio(3, 2), 0}));
    EXPECT_NEAR(std::abs(half.angle), pi, 1e-15);
}

TEST(Displacements, PivotsAreEquallyFarFromThreePlaces) {
    const Solution& solution = example("motion/three_positions");
    const auto& problem = solution.mechanism.problem->as<PositionsProblem>();
    const PositionsSolution& found = positions_of(solution);
    for (std::size_t point = 0; point < 2; ++point)
        for (const auto& position : problem.positions)
            EXPECT_NEAR(length(position.places.at(point) - *found.pivots.at(point).centre),
                        found.pivots.at(point).radius, 1e-14);
    // Angles add up.
    EXPECT_NEAR(found.displacements[0].angle + found.displacements[1].angle, found.displacements[2].angle, 1e-14);
    EXPECT_NEAR(found.displacements[0].angle, -12 * pi / 180, 1e-14);
}

TEST(Displacements, PivotsThatAreNone) {
    const PositionsSolution straight = positions_of(
        placed(R"~({"A": [0, 0], "B": [0, 1]}, {"A": [1, 0], "turned": "10°"}, {"A": [3, 0], "turned": "30°"})~"));
    EXPECT_EQ(straight.pivots[0].kind, FixedPivot::Kind::straight);
    EXPECT_EQ(straight.pivots[1].kind, FixedPivot::Kind::pivot);
    const PositionsSolution fixed = positions_of(
        placed(R"~({"A": [0, 0], "B": [0, 1]}, {"A": [0, 0], "turned": "10°"}, {"A": [0, 0], "turned": "30°"})~"));
    EXPECT_EQ(fixed.pivots[0].kind, FixedPivot::Kind::fixed);
    EXPECT_NEAR(length(*fixed.pivots[1].centre), 0, 1e-15);
    const PositionsSolution twice = positions_of(
        placed(R"~({"A": [0, 0], "B": [0, 1]}, {"A": [0, 0], "turned": "10°"}, {"A": [1, 1], "turned": "30°"})~"));
    EXPECT_EQ(twice.pivots[0].kind, FixedPivot::Kind::free);
}

TEST(Displacements, RandomPositionsAgreeWithComplexNumbers) {
    std::mt19937 random(3);
    const auto number = [&] { return std::to_string(static_cast<int>(random() % 2001) - 1000); };
    for (int i = 0; i < 40; ++i) {
        std::string positions =
            R"~({"A": [)~" + number() + ", " + number() + R"~(], "B": [)~" + number() + ", " + number() + "]}";
        for (int k = 0; k < 2; ++k)
            positions += R"~(, {"A": [)~" + number() + ", " + number() + R"~(], "turned": ")~" +
                         std::to_string(static_cast<int>(random() % 359) - 179) + R"~( deg"})~";
        SCOPED_TRACE(positions);
        const Solution solution = placed(positions);
        ASSERT_FALSE(solution.problem->values.empty());
        double largest = 1;
        for (const ProblemValue& each : solution.problem->values) largest = std::max(largest, std::abs(each.value));
        for (const ProblemValue& each : solution.problem->values)
            EXPECT_NEAR(each.value, *each.numeric, 1e-9 * largest) << each.name.in(Language::en);
    }
}

TEST(Displacements, RoundedPlacesAreMovedAndSaid) {
    const Solution rounded = placed(R"~({"A": [0, 0], "B": [100, 0]}, {"A": [10, 10], "B": [80.711, 80.711]})~");
    EXPECT_EQ(rounded.problem->remarks.size(), 1u);
    const auto& places = rounded.mechanism.problem->as<PositionsProblem>().positions[1].places;
    EXPECT_NEAR(length(places[1] - places[0]), 100, 1e-12);
    const auto refused = read_mechanism(
        R"~({"kinegraph": 1, "positions": [{"A": [0, 0], "B": [100, 0]}, {"A": [10, 10], "B": [80, 90]}]})~", "p.json");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().front().where, "/positions/1/B");
    EXPECT_NE(refused.error().front().message.in(Language::en).find("keeps distances"), std::string::npos);
}

}  // namespace
}  // namespace kinegraph::positions_of_a_body_test
