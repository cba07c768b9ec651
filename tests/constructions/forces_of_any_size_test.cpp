// Forces at any size: where no order of bodies leads on, equilibrium equations are solved together. Closed forms of
// scissor lifts, exact equilibrium of every body, and reasons that are true.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "constructions/statics/forces/solvable_blocks.hpp"
#include "lang/keys/phrases.hpp"
#include "lang/keys/sentences.hpp"
#include "tests/support/force_laws.hpp"
#include "tests/support/scissor_lift.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::forces_of_any_size_test {
namespace {

using Json = nlohmann::json;
using tests::scissor;
using tests::solved;

/// A ring of bars, with bars across: no pin has only two unknown bars, and no three bars can be cut.
Json ring(int pins) {
    Json points, bodies, joints = Json::array(), loads = Json::array();
    std::vector<Json> at(static_cast<std::size_t>(pins), Json::array());
    const auto point = [](int i) { return "P" + std::to_string(i); };
    for (int i = 0; i < pins; ++i) {
        const double angle = 6.283185307179586 * i / pins + 0.1 * (i % 3);
        points[point(i)] = {std::round(1000 * 10 * std::cos(angle)) / 1000,
                            std::round(1000 * 7 * std::sin(angle)) / 1000};
    }
    int bars = 0;
    const auto bar = [&](int from, int to) {
        const std::string body = "s" + std::to_string(bars++);
        bodies[body] = {point(from), point(to % pins)};
        at[static_cast<std::size_t>(from)].push_back(body);
        at[static_cast<std::size_t>(to % pins)].push_back(body);
    };
    for (int i = 0; i < pins; ++i) bar(i, i + 1);
    for (int i = 0; i < pins / 2; ++i) bar(i, i + pins / 2);
    for (int i = 0; bars < 2 * pins - 3; ++i) bar(i, i + pins / 4 + 1);
    at[0].push_back("0");
    for (int i = 0; i < pins; ++i)
        joints.push_back({{"revolute", point(i)}, {"bodies", at[static_cast<std::size_t>(i)]}});
    joints.push_back(
        {{"pin-slot", point(pins / 2)}, {"bodies", {at[static_cast<std::size_t>(pins / 2)][0], "0"}}, {"along", 0}});
    for (int i = 1; i < pins; i += 3)
        loads.push_back({{"force", "W" + std::to_string(i)}, {"pin", point(i)}, {"value", {1, -10}}});
    return {{"kinegraph", 1},   {"points", points}, {"bodies", bodies},
            {"joints", joints}, {"loads", loads},   {"find", {"forces"}}};
}

bool says(const Solution& solution, Key sentence) {
    return std::any_of(solution.protocol.statements.begin(), solution.protocol.statements.end(),
                       [&](const Statement& each) { return each.message.sentence == sentence; });
}

void expect_all_forces(const Solution& solution) {
    EXPECT_TRUE(solution.unsolved.empty()) << english_of(solution.unsolved.front());
    ASSERT_FALSE(solution.forces.empty());
    for (const JointForce& each : solution.forces) EXPECT_TRUE(each.force.has_value());
    ASSERT_FALSE(solution.checks.empty());
    for (const CheckRow& row : solution.checks)
        EXPECT_NEAR(row.graphical, row.numeric, 1e-6 * (1 + std::abs(row.numeric)));
}

class ScissorLift : public testing::TestWithParam<int> {};

/// Virtual work: the top rises n times as much as one stage, so P = n · W · 400/300.
TEST_P(ScissorLift, HasTheForceOfVirtualWork) {
    const Solution solution = solved(scissor(GetParam()).dump());
    expect_all_forces(solution);
    ASSERT_TRUE(solution.efforts.front().value.has_value());
    EXPECT_EQ(*solution.efforts.front().value, Exact::ratio(4000 * GetParam(), 3));
    expect_equilibrium_of_bodies(solution);
}

INSTANTIATE_TEST_SUITE_P(Stages, ScissorLift, testing::Values(1, 2, 5, 9, 10, 30));

TEST(ScissorLift, IsSolvedStageByStage) {
    const Solution solution = solved(scissor(12).dump());
    ASSERT_TRUE(says(solution, lang::sentences::equations_together));
    for (const Statement& each : solution.protocol.statements)
        if (each.message.sentence == lang::sentences::equations_together) {
            EXPECT_LE(std::get<Count>(each.message.arguments[1]).value, 6) << english(each.message);
        }
}

class RingOfBars : public testing::TestWithParam<int> {};

TEST_P(RingOfBars, IsInEquilibrium) {
    const Solution solution = solved(ring(GetParam()).dump());
    expect_all_forces(solution);
    expect_equilibrium_of_bodies(solution);
}

INSTANTIATE_TEST_SUITE_P(Pins, RingOfBars, testing::Values(8, 20, 100));

/// A lift whose top also slides along a wall is held once more than it needs: what stays open is indeterminate, at any
/// size, and never at a dead point.
TEST(IndeterminateLift, GivesTheTrueReason) {
    for (const int stages : {3, 20}) {
        Json file = scissor(stages);
        file["joints"].push_back({{"pin-slot", "L" + std::to_string(stages)},
                                  {"bodies", {"b" + std::to_string(stages - 1), "0"}},
                                  {"along", 90}});
        const Solution solution = solved(file.dump());
        for (const Unsolved& each : solution.unsolved)
            EXPECT_EQ(each.why.sentence, lang::phrases::indeterminate) << english_of(each);
    }
}

/// The effort across the motion that is free does no work in it: the only case where this may be said.
TEST(DeadPoint, IsSaidWhereVirtualWorkSaysSo) {
    for (const int stages : {1, 3, 20}) {
        Json file = scissor(stages);
        file["effort"]["along"] = 90;
        const Solution solution = solved(file.dump());
        ASSERT_FALSE(solution.unsolved.empty()) << stages;
        EXPECT_EQ(solution.unsolved.back().why.sentence, lang::phrases::effort_without_work);
    }
}

/// Components are taken in the direction of the virtual translation: "along its line" is said of a force only where its
/// line has that direction.
TEST(VirtualTranslation, IsNamed) {
    const Json wedge = Json::parse(R"({"kinegraph": 1, "units": {"length": "mm"},
        "points": {"A": [0, 0], "B": {"from": "A", "distance": 60, "angle": 15},
                   "C": {"from": "B", "distance": 70, "angle": 70}, "D": [-80, 0]},
        "bodies": {"2": ["A", "D"], "3": ["B", "C"]},
        "joints": [{"prismatic": "A", "bodies": [2, 0], "along": 0}, {"prismatic": "B", "bodies": [3, 2], "along": 15},
                   {"prismatic": "C", "bodies": [3, 0], "along": 70}],
        "loads": [{"force": "F", "body": 3, "at": "C", "magnitude": -1000, "along": 70}],
        "effort": {"force": "P", "body": 2, "at": "D", "along": 0}, "find": ["forces"]})");
    const Solution solution = solved(wedge.dump());
    EXPECT_FALSE(says(solution, lang::sentences::components_alone));
    std::string told;
    for (const Statement& each : solution.protocol.statements)
        if (each.message.sentence == lang::sentences::translation_alone) told += english(each.message) + "\n";
    EXPECT_NE(told.find("∥"), std::string::npos) << told;
}

// --- which equations are solved together

using Blocks = std::vector<std::vector<std::size_t>>;
Blocks equations_of(const std::vector<std::vector<std::size_t>>& unknowns_in, std::size_t unknowns) {
    std::vector<std::size_t> owner(unknowns_in.size());
    for (std::size_t i = 0; i < owner.size(); ++i) owner[i] = i;
    Blocks found;
    for (const statics::SolvableBlock& each : statics::solvable_blocks(unknowns_in, owner, unknowns))
        found.push_back(each.equations);
    return found;
}

TEST(SolvableBlocks, AreTheSmallest) {
    // The second equation has one unknown; the others need its value.
    EXPECT_EQ(equations_of({{0, 1, 2}, {1}, {0, 2}}, 3), (Blocks{{1}}));
    EXPECT_EQ(equations_of({{0, 1}, {0, 1}, {0, 1, 2}}, 3), (Blocks{{0, 1}}));
}
TEST(SolvableBlocks, LeaveWhatIsNotDetermined) {
    EXPECT_EQ(equations_of({{0, 1}}, 2), Blocks{});
    EXPECT_EQ(equations_of({{0, 1}, {0, 1}, {0, 1}, {2}}, 3), (Blocks{{3}, {0, 1}}));
    EXPECT_EQ(equations_of({{0, 1}, {2}}, 3), (Blocks{{1}}));
}

}  // namespace
}  // namespace kinegraph::forces_of_any_size_test
