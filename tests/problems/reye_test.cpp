// Reye's hypothesis: published numbers, equilibrium done numerically, limits, a shoe that locks itself.
#include "engine/file/units.hpp"  // before signal.h, which makes a macro of si_value

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "constructions/solving/solve.hpp"
#include "problems/reye/reye.hpp"
#include "tests/support/problem_tests.hpp"

namespace kinegraph::reye_test {
namespace {

using std::numbers::pi;
using tests::example;

const ReyeSolution& reye_of(const Solution& solution) { return tests::found_in<ReyeSolution>(solution); }
Solution worn(const std::string& members) { return tests::stated("reye", members); }

TEST(Reye, PadHasThePublishedNumbers) {
    const Solution& solution = example("contact/pad");
    const ReyeSolution& found = reye_of(solution);
    EXPECT_EQ(*found.m, Exact(3));
    EXPECT_DOUBLE_EQ(found.first, 0.08e6);
    EXPECT_DOUBLE_EQ(found.second, 0.32e6);
    EXPECT_EQ(*found.resultant, Exact::ratio(6, 100));
    EXPECT_DOUBLE_EQ(*found.friction_force, 150);
}

TEST(Reye, PadLiftsOutsideItsMiddleThird) {
    const Solution& solution = example("contact/pad_lifting");
    const ReyeSolution& found = reye_of(solution);
    EXPECT_TRUE(found.lifts);
    EXPECT_DOUBLE_EQ(found.begin, 0.04);
    EXPECT_DOUBLE_EQ(found.end, 0.1);
    EXPECT_DOUBLE_EQ(found.second, 2 * 1000 / (0.06 * 0.05));
    EXPECT_EQ(found.first, 0);
    EXPECT_DOUBLE_EQ((*found.worn)[1], 2e-15 * found.second * 0.5 * 36000);
    EXPECT_EQ(solution.problem->remarks.size(), 1u);
    // At the limits the triangle spans the whole face.
    const Solution edge = worn(R"("kind": "pad", "force": 300, "length": 90, "width": 10, "offset": 30)");
    EXPECT_FALSE(reye_of(edge).lifts);
    EXPECT_EQ(reye_of(edge).second, 0);
    EXPECT_EQ(reye_of(worn(R"("kind": "block", "force": 300, "length": 90, "width": 10)")).first, 300 / 0.0009);
}

TEST(Reye, ClutchHasBothClosedForms) {
    // Shigley 16–5: wear F f (D + d)/4, pressure F f (D³ − d³)/3(D² − d²), for each surface.
    const ReyeSolution found = reye_of(example("contact/clutch"));
    EXPECT_NEAR(*found.torque, 2 * 0.3 * 4000 * 0.08, 1e-9);
    EXPECT_NEAR(*found.uniform_torque,
                2 * 0.3 * 4000 * (0.2 * 0.2 * 0.2 - 0.12 * 0.12 * 0.12) / (3 * (0.2 * 0.2 - 0.12 * 0.12)), 1e-9);
    EXPECT_NEAR(found.first * 0.06, found.second * 0.1, 1e-6);
}

TEST(Reye, LeadingShoeTakesMoreThanTrailing) {
    const auto shoe = [](const char* sense, const char* friction) {
        return std::string(
                   R"("kind": "shoe", "force": 1000, "radius": 150, "width": 32, "pivot": 120, "arm": 210,
                    "from": 10, "to": 130, "inside": true, "sense": ")") +
               sense + R"(", "friction": )" + friction;
    };
    const ReyeSolution leading = reye_of(worn(shoe("leading", "0.3"))),
                       trailing = reye_of(worn(shoe("trailing", "0.3")));
    EXPECT_GT(*leading.torque, *trailing.torque);
    // Q c = C(N₁ ∓ fF₁): the reciprocals are linear in f, and meet where friction has no moment.
    const double none = 0.5 * (1 / leading.greatest + 1 / trailing.greatest);
    const double limit = *leading.locking_friction;
    EXPECT_NEAR(1 / leading.greatest, none * (1 - 0.3 / limit), 1e-9 * none);
    auto mechanism = read_mechanism(
        R"({"kinegraph": 1, "units": {"length": "mm"}, "reye": {)" + shoe("leading", "2") + "}}", "shoe.json");
    ASSERT_TRUE(mechanism);
    const auto locked = solve(*std::move(mechanism));
    ASSERT_FALSE(locked);
    EXPECT_EQ(locked.error().front().code, ErrorCode::no_unique_answer);
    EXPECT_GT(2, limit);
}

TEST(Reye, ShoesOfAPublishedBrake) {
    // Shigley, example 16–2: p_a = 1000 kPa and 366 N m on the leading shoe, 443 kPa and 162 N m on the trailing one, F
    // = 2.28 kN.
    const auto shoe = [](const char* sense) {
        return reye_of(worn(std::string(
                                R"("kind": "shoe", "force": "2.28 kN", "friction": 0.32, "radius": 150, "width": 32,
                    "pivot": 122.9, )") +
                            R"("arm": 212.4, "from": 0, "to": 126, "inside": true, "sense": ")" + sense + "\""));
    };
    EXPECT_NEAR(shoe("leading").greatest, 1000e3, 10e3);
    EXPECT_NEAR(*shoe("leading").torque, 366, 4);
    EXPECT_NEAR(shoe("trailing").greatest, 443e3, 4e3);
    EXPECT_NEAR(*shoe("trailing").torque, 162, 2);
}

TEST(Reye, AgreesWithTheStripsOnEveryExample) {
    for (const char* name : {"pad", "pad_lifting", "clutch", "drum_shoe", "outer_shoe"}) {
        SCOPED_TRACE(name);
        const Solution& solution = example(std::string("contact/") + name);
        tests::expect_near_check(*solution.problem, 1e-6, tests::Against::itself);
    }
}

}  // namespace
}  // namespace kinegraph::reye_test
