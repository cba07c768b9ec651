// The record as a program: every example replayed in Exact and in doubles, with other drivers and loads; cut to some
// results; what results hang on; which guard flips.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/board/replay.hpp"
#include "tests/support/replay_laws.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::program_test {
namespace {

using tests::example;
using tests::example_names;

std::size_t at(auto index) { return at_index(index); }

std::string four_bar(const std::string& omega, const std::string& more = "") {
    return R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "points": {"A0": [0, 0], "A": [30, 40],
    "B": [150, 90],
        "B0": [180, 0]}, "bodies": {"2": ["A0", "A"], "3": ["A", "B"], "4": ["B0", "B"]},
        "joints": [{"revolute": "A0", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
        {"revolute": "B", "bodies": [3, 4]}, {"revolute": "B0", "bodies": [1, 4]}],
        "drivers": [{"body": 2, "omega": )" +
           omega + R"(, "alpha": "1 rad/s^2"}])" + more + "}";
}

TEST(Program, EveryExampleReplays) {
    int as_fresh = 0;
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution& solution = example(name);
        tests::expect_identical_replay(solution);
        EXPECT_LE(tests::difference_in_doubles(solution), tests::loss_in_doubles);
        as_fresh += tests::expect_fresh_solution(solution) ? 1 : 0;
    }
    EXPECT_GE(as_fresh, static_cast<int>(example_names().size()) - 6) << "few guards hang on speeds and loads";
}

TEST(Program, HoldsNoSearch) {
    const Solution& butterfly = example("double_butterfly");
    EXPECT_LE(butterfly.protocol.program.strokes.size(), 900U);
}

TEST(Program, GivensHaveTheirNames) {
    const Solution solution = tests::solved(four_bar("\"2 rad/s\""));
    const Program& program = solution.protocol.program;
    std::vector<std::string> names;
    for (const Given& given : program.givens) names.push_back(given.name);
    for (const char* name :
         {"/points/A0", "/points/A", "/points/B", "/points/B0", "/drivers/0/omega", "/drivers/0/alpha"})
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
}

TEST(Program, KnowsWhatAResultHangsOn) {
    const Solution solution = tests::solved(four_bar("\"2 rad/s\""));
    const Program& program = solution.protocol.program;
    const auto names = [&](ElementIndex element) {
        std::vector<std::string> found;
        for (const int given : hangs_on(program, element)) found.push_back(program.givens[at(given)].name);
        return found;
    };
    const auto has = [](const std::vector<std::string>& all, const char* name) {
        return std::count(all.begin(), all.end(), name) == 1;
    };
    const auto omega = names(solution.bodies[2].omega.element()), alpha = names(solution.bodies[2].alpha.element());
    EXPECT_TRUE(has(omega, "/points/B") && has(omega, "/drivers/0/omega"));
    EXPECT_FALSE(has(omega, "/drivers/0/alpha")) << "an angular velocity does not hang on an acceleration";
    EXPECT_TRUE(has(alpha, "/drivers/0/alpha") && has(alpha, "/drivers/0/omega"));
}

TEST(Program, IsCutToWhatIsWanted) {
    const Solution solution = tests::solved(four_bar("\"2 rad/s\""));
    const Program& program = solution.protocol.program;
    const ElementIndex omega = solution.bodies[2].omega.element();
    const Cut velocities = cut(program, {omega}, solution.settled.velocities);
    EXPECT_LT(velocities.program.strokes.size(), program.strokes.size());
    for (const Stroke& stroke : velocities.program.strokes) EXPECT_NE(stroke.plane, Plane::acceleration);
    const Evaluation again =
        evaluate(velocities.program, givens_of(velocities.program, solution.mechanism, solution.pose), solution.pose);
    ASSERT_FALSE(again.flipped);
    EXPECT_EQ(std::get<Exact>(again.values[at(velocities.element[at(omega)])]), *solution.bodies[2].omega);
}

/// A crank brought to rest: what was a body that moves is one that stands, and the record says so before it gives a
/// number.
TEST(Program, SaysWhichGuardFlips) {
    const Solution moving = tests::solved(four_bar("\"2 rad/s\""));
    const Solution resting = tests::solved(four_bar("0"));
    const Program& program = moving.protocol.program;
    const Evaluation stopped = evaluate(program, givens_of(program, resting.mechanism, resting.pose), resting.pose);
    ASSERT_TRUE(stopped.flipped);
    const Guard& guard = program.guards[at(*stopped.flipped)];
    EXPECT_TRUE(guard.question == Guard::Question::zero_vector || guard.question == Guard::Question::zero_scalar);
    EXPECT_EQ(guard.verdict, 0);
    EXPECT_LE(stopped.values.size(), program.strokes.size());

    Replay replay(program, givens_of(program, resting.mechanism, resting.pose), resting.pose.size.to_double());
    EXPECT_EQ(replay.run(), stopped.flipped) << "in doubles the same guard";
}

/// In doubles the givens are changed one by one, and the record follows: twice the speed, twice the velocities.
TEST(Program, IsReplayedWithOtherGivens) {
    const Solution solution = tests::solved(four_bar("\"2 rad/s\""));
    const Program& program = solution.protocol.program;
    Replay replay(program, givens_of(program, solution.mechanism, solution.pose), solution.pose.size.to_double());
    ASSERT_FALSE(replay.run());
    const ElementIndex omega = solution.bodies[3].omega.element();
    const double before = replay.scalar(omega);
    const auto driver = std::find_if(program.givens.begin(), program.givens.end(),
                                     [](const Given& given) { return given.name == "/drivers/0/omega"; });
    replay.give(static_cast<int>(driver - program.givens.begin()), 4.0);
    ASSERT_FALSE(replay.run());
    EXPECT_DOUBLE_EQ(replay.scalar(omega), 2 * before);
}

}  // namespace
}  // namespace kinegraph::program_test
