// Where no order of bodies leads on: moments about a hinge, of one body or of several as one. No sentence tells of a
// trial that no figure shows; every sentence of moments has its arms on a free body, and every body is in equilibrium.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <nlohmann/json.hpp>

#include "lang/keys/sentences.hpp"
#include "tests/support/force_laws.hpp"
#include "tests/support/near_the_check.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::by_moments_test {
namespace {

using Json = nlohmann::json;
using tests::solved;

std::size_t said(const Solution& solution, Key sentence) {
    const auto& all = solution.protocol.statements;
    return static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [&](const Statement& each) { return each.message.sentence == sentence; }));
}
const JointForce& at_joint(const Solution& solution, const std::string& joint, const std::string& on) {
    const auto found = std::find_if(solution.forces.begin(), solution.forces.end(), [&](const JointForce& each) {
        return each.on != none && solution.mechanism.body(each.on).name == on &&
               solution.mechanism.joint(each.joint).name == joint;
    });
    if (found == solution.forces.end()) throw std::out_of_range(joint);
    return *found;
}

/// Each sentence of moments has the arm of the force that it gives, about the hinge that it names.
void expect_arms(const Solution& solution) {
    for (const StatementIndex index : indices_of(solution.protocol.statements)) {
        const Message& message = solution.protocol.statements[at_index(index)].message;
        if (message.sentence != lang::sentences::moments_give) continue;
        const std::string& centre = std::get<PointName>(message.arguments[1]).name;
        int sought = 0;
        for (const FreeBody& body : solution.free_bodies)
            for (const FreeBody::Arm& arm : body.arms) {
                if (arm.statement != index) continue;
                EXPECT_EQ(arm.name, centre);
                sought += arm.is_sought ? 1 : 0;
            }
        EXPECT_GE(sought, 1) << centre;
    }
}

Json pin(const std::string& at, const std::string& one, const std::string& other) {
    return {{"revolute", at}, {"bodies", {one, other}}};
}

/// Two legs crossed and pinned at M, on two hinges; a seat across them with a weight.
TEST(ByMoments, AFoldingStoolWithASeat) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1,
        "points": {"A": [0, 0], "B": [0.4, 0], "M": [0.2, 0.225], "C": [0.4, 0.45], "D": [0, 0.45], "G": [0.16, 0.45]},
        "bodies": {"2": ["A", "C", "M"], "3": ["B", "D", "M"], "5": ["D", "C", "G"]},
        "joints": [{"revolute": "M", "bodies": [2, 3]}, {"revolute": "A", "bodies": [2, 1]},
                   {"revolute": "B", "bodies": [3, 1]}, {"revolute": "D", "bodies": [3, 5]},
                   {"contact": "C", "bodies": [5, 2], "tangent": [1, 0], "pushes": [0, 1]}],
        "loads": [{"force": "W", "body": 5, "at": "G", "value": [0, -750]}]})");
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_EQ(said(solution, lang::sentences::moments_give), 2U);
    EXPECT_EQ(said(solution, lang::sentences::virtual_work_gives), 0U);
    // Of the seat D has 450 N and C 300 N; B = 300 N and A = 450 N upwards. About M of leg 2: 0.225 H = 0.2 (450 +
    // 300).
    const Exact thrust = Exact(750) * Exact::ratio(8, 9);
    EXPECT_EQ(*at_joint(solution, "A", "2").force, (Vector{thrust, 450}));
    EXPECT_EQ(*at_joint(solution, "B", "3").force, (Vector{-thrust, 300}));
    expect_equilibrium_of_bodies(solution);
    expect_arms(solution);
}

/// Arches of two bodies and frames of three, oblique, with a load on every body of which one may be a couple.
Json loaded(bool frame, std::mt19937& random) {
    const auto any = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
    Json points{{"A", {0, any(-3, 3)}},
                {"B", {20 + any(0, 5), any(-3, 3)}},
                {"M", {9 + any(0, 3), 12 + any(0, 6)}},
                {"P", {3 + any(0, 2), 9 + any(0, 3)}},
                {"Q", {17 + any(0, 2), 10 + any(0, 3)}}};
    Json bodies{{"2", {"A", "M", "P"}}, {"3", {"B", "M", "Q"}}};
    Json joints = Json::array({pin("M", "2", "3"), pin("A", "2", "1")});
    if (frame) {
        points["E"] = {3 + any(0, 2), 4 + any(0, 2)};
        points["F"] = {16 + any(0, 3), 4 + any(0, 2)};
        points["R"] = {9 + any(0, 3), 7};
        bodies["2"].push_back("E");
        bodies["3"].push_back("F");
        bodies["4"] = {"E", "F", "R"};
        joints.push_back({{"contact", "B"}, {"bodies", {"3", "1"}}, {"tangent", {1, 0}}});
        joints.push_back(pin("E", "2", "4"));
        joints.push_back(pin("F", "3", "4"));
    } else {
        joints.push_back(pin("B", "3", "1"));
        bodies["5"] = {"P", "Q"};
        joints.push_back(pin("P", "2", "5"));
        joints.push_back({{"contact", "Q"}, {"bodies", {"5", "3"}}, {"tangent", {1, 0}}});
    }
    const std::string on = frame ? "4" : "5", at = frame ? "R" : "P";
    Json loads = Json::array({{{"force", "W"}, {"body", on}, {"at", at}, {"value", {any(-20, 20), -30 - any(0, 20)}}}});
    loads.push_back({{"couple", "C"}, {"body", on}, {"value", any(1, 40)}});
    return {{"kinegraph", 1},   {"frame", 1},     {"points", points},  {"bodies", bodies},
            {"joints", joints}, {"loads", loads}, {"find", {"forces"}}};
}

TEST(ByMoments, ArchesAndFramesOfAnyShapeNeedNoOtherEquation) {
    std::mt19937 random(17);
    std::size_t moments = 0;
    for (int n = 0; n < 60; ++n) {
        const Json file = loaded(n % 2 == 1, random);
        SCOPED_TRACE(file.dump());
        const Solution solution = solved(file.dump());
        ASSERT_TRUE(solution.unsolved.empty());
        moments += said(solution, lang::sentences::moments_give);
        EXPECT_EQ(said(solution, lang::sentences::virtual_work_gives), 0U);
        EXPECT_EQ(said(solution, lang::sentences::equations_together), 0U);
        expect_equilibrium_of_bodies(solution);
        expect_arms(solution);
        EXPECT_LT(tests::worst_difference(solution), 1e-9);
    }
    EXPECT_GE(moments, 120U);
}

}  // namespace
}  // namespace kinegraph::by_moments_test
