// Sentences that say what was done: how a centre follows from velocities, which couple balances what, by which theorem
// a centre of curvature is found, why teeth and contacts push.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lang/keys/sentences.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::told_as_found_test {
namespace {

using tests::example;
using tests::solved;

std::vector<const Message*> told(const Solution& solution, Key sentence) {
    std::vector<const Message*> found;
    for (const Statement& each : solution.protocol.statements)
        if (each.message.sentence == sentence) found.push_back(&each.message);
    return found;
}
bool remarked(const Solution& solution, Key sentence) {
    return std::any_of(solution.remarks.begin(), solution.remarks.end(),
                       [&](const Message& each) { return each.sentence == sentence; });
}

/// A double planet on an arm with two inputs: its pitch points and its pin are in line with the sun.
const char* const reverted_train = R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm", "angular velocity": "rpm"},
    "points": {"O": [0, 0], "C": {"from": "O", "distance": 60, "angle": 30},
               "P": {"from": "O", "to": "C", "distance": 40}, "Q": {"from": "O", "to": "C", "distance": 35}},
    "bodies": {"2": {"points": ["O"], "circle": {"centre": "O", "radius": 40}},
               "3": {"points": ["C"], "circle": {"centre": "C", "radius": 25}},
               "4": {"points": ["O"], "circle": {"centre": "O", "radius": 35}}, "5": {"points": ["O", "C"]}},
    "joints": [{"revolute": "O", "bodies": [1, 2, 4, 5]}, {"revolute": "C", "bodies": [3, 5]},
               {"gear": "P", "bodies": [2, 3], "arm": 5, "profiles": {"3": {"circle": "C"}}},
               {"gear": "Q", "bodies": [3, 4], "arm": 5}],
    "drivers": [{"body": 5, "omega": 300}, {"body": 2, "omega": -120}], "find": ["velocity", "instant centres"]})";

/// Parallel velocities have normals in one line, which meet nowhere: r = v/ω.
TEST(ToldAsFound, CentresOfParallelVelocitiesAreNoMeetsOfNormals) {
    const Solution train = solved(reverted_train);
    EXPECT_TRUE(told(train, lang::sentences::centre_from_velocities).empty());
    const auto by_omega = told(train, lang::sentences::centre_from_omega);
    ASSERT_EQ(by_omega.size(), 1U);
    const std::string text = english(*by_omega.front());
    EXPECT_NE(text.find("normal to v_C at C"), std::string::npos) << text;
}

/// Relative velocities of two bodies that both move stand in no polygon: their centre parts the join of their own.
TEST(ToldAsFound, CentresOfTwoMovingBodiesPartTheJoinOfTheirOwn) {
    const Solution& five = example("five_bar");
    EXPECT_FALSE(told(five, lang::sentences::centre_by_ratio).empty());
    for (const Message* each : told(five, lang::sentences::centre_from_velocities)) {
        const auto* centre = std::get_if<Symbol>(each->arguments.data());
        ASSERT_NE(centre, nullptr);
        EXPECT_EQ(centre->about.front(), '1') << english(*each);
    }
}

/// What is calculated is ρ = CP²/CW.
TEST(ToldAsFound, CentresOfCurvatureAreByEulerSavary) {
    const Solution& curve = example("coupler_curve");
    std::size_t found = 0;
    for (const Statement& each : curve.protocol.statements) {
        if (each.message.sentence != lang::sentences::curvature_conjugate) continue;
        EXPECT_EQ(each.source, "Euler–Savary");
        ++found;
    }
    EXPECT_GE(found, 1U);
}

/// A slider's pin has its centre at infinity: the line through the other centre is parallel to its ray.
TEST(ToldAsFound, ABobillierWithOneCentreFarAwayNamesTheParallel) {
    const Solution crank = solved(R"({"kinegraph": 1, "frame": 1,
        "points": {"O": [0, 0], "A": [3, 4], "B": [15, 0], "M": [9, 2]},
        "bodies": {"2": ["O", "A"], "3": ["A", "B", "M"], "4": ["B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
                   {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": 0}],
        "drivers": [{"body": 2, "omega": 1}], "find": ["curvature"]})");
    EXPECT_TRUE(told(crank, lang::sentences::curvature_bobillier).empty());
    EXPECT_EQ(told(crank, lang::sentences::curvature_bobillier_one_far).size(), 1U);
}

/// One known force is no resultant.
TEST(ToldAsFound, TheClosingLinePartsOneKnownForce) {
    EXPECT_TRUE(told(example("pliers"), lang::sentences::funicular_parallel).empty());
    EXPECT_FALSE(told(example("pliers"), lang::sentences::funicular_parallel_one).empty());
}

/// A block in a guide under a force aside: the polygon gives the forces, moments give the couple of the guide.
TEST(ToldAsFound, ACoupleSaysAboutWhichPoint) {
    const Solution block = solved(R"({"kinegraph": 1, "frame": 1,
        "points": {"B": [0, 0], "E": [0, 2]}, "bodies": {"2": ["B", "E"]},
        "joints": [{"prismatic": "B", "bodies": [2, 1], "along": 0}],
        "loads": [{"force": "W", "body": 2, "at": "E", "value": [-6, -5]}],
        "effort": {"force": "F", "body": 2, "at": "B", "along": 0}, "find": ["forces"]})");
    std::size_t about = 0;
    for (const Statement& each : block.protocol.statements)
        about += english(each.message).find("moments about B give M_12") != std::string::npos ? 1 : 0;
    EXPECT_EQ(about, 1U);
}

/// Teeth have two lines of action: a remark says why one is taken.
TEST(ToldAsFound, OfTwoLinesOfActionOneIsReasoned) {
    EXPECT_TRUE(remarked(example("joint_contact/spur_gears"), lang::sentences::teeth_push));
    EXPECT_FALSE(remarked(example("pliers"), lang::sentences::teeth_push));
}

/// A lever with a round shoe on a round cam, under a force: it can only push, although the file does not say so.
std::string lever_on_cam(const std::string& force) {
    return R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "E": [0, 1], "A": [0, 5], "D": [8, 5],
               "P": {"from": "E", "to": "A", "distance": 3}},
        "bodies": {"2": {"points": ["O", "E"], "circle": {"centre": "E", "radius": 3}},
                   "3": {"points": ["D", "A"], "circle": {"centre": "A", "radius": 1}}},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "D", "bodies": [1, 3]},
                   {"contact": "P", "bodies": [3, 2]}],
        "loads": [{"force": "Q", "body": 3, "at": "A", "value": [0, )" +
           force + R"(]}], "effort": {"couple": "M", "body": 2}, "find": ["forces"]})";
}
TEST(ToldAsFound, RoundProfilesThatPullLiftOff) {
    EXPECT_TRUE(remarked(solved(lever_on_cam("7")), lang::sentences::lift_off));
    EXPECT_FALSE(remarked(solved(lever_on_cam("-7")), lang::sentences::lift_off));
}

/// A pin in a slot curved about K: the normal part of its relative acceleration is v²/ρ.
TEST(ToldAsFound, TheNormalPartInACurvedSlotIsTheSquareByTheRadius) {
    const Solution slotted = solved(R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
        "points": {"O2": [0, 0], "A": [30, 40], "O4": [-120, -20], "K": [-114, -8]},
        "bodies": {"2": ["O2", "A"], "4": ["O4"]},
        "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "O4", "bodies": [1, 4]},
                   {"pin-slot": "A", "bodies": [2, 4], "arc": "K"}],
        "drivers": [{"body": 2, "omega": 20}], "find": ["velocity", "acceleration"]})");
    std::size_t by_square = 0;
    for (const Statement& each : slotted.protocol.statements)
        for (const Working& working : each.message.worked_arithmetic) {
            if (working.of.about != "AA*" || working.of.term != "n") continue;
            ASSERT_EQ(working.factors.size(), 1U);
            EXPECT_TRUE(working.factors.front().squared);
            ASSERT_TRUE(working.divisor);
            EXPECT_NEAR(*working.divisor, std::hypot(0.144, 0.048), 1e-15);
            ++by_square;
        }
    EXPECT_EQ(by_square, 1U);
}

}  // namespace
}  // namespace kinegraph::told_as_found_test
