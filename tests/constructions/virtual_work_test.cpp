// Virtual displacements: efforts found without a reaction, held against those of the force polygons, the velocity
// ratios and the check; the numbers of the course.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/solution/displacements.hpp"
#include "tests/support/files.hpp"
#include "tests/support/random_loads.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::virtual_work_test {
namespace {

Solution displaced(const std::string& text) {
    auto mechanism = read_mechanism(text, "test.json");
    if (!mechanism) throw std::runtime_error(mechanism.error().front().message.in(Language::en));
    mechanism->find.virtual_work = true;
    auto solution = solve(*std::move(mechanism));
    if (!solution) throw std::runtime_error(solution.error().front().message.in(Language::en));
    return *std::move(solution);
}

/// What else the file may say: loads, an effort; without drivers.
std::string slider_crank(const std::string& more) {
    return R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1,
      "points": {"O": [0, 0], "A": {"from": "O", "distance": 50, "angle": 60},
                 "B": {"meet": [{"circle": "A", "radius": 150}, {"line": [0, 0], "angle": 0}], "near": [170, 0]}},
      "bodies": {"2": {"points": ["O", "A"]}, "3": {"points": ["A", "B"]}, "4": {"points": ["B"]}},
      "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
      "bodies": [3, 4]},
                 {"prismatic": "B", "bodies": [4, 1], "along": 0}])" +
           more + "}";
}

/// Every effort that both find: by the polygons of the forces, by the displacements drawn, by the ratios of the
/// equations.
int hold_efforts_together(const Solution& solution, const std::string& name) {
    const Displacements& found = *solution.displacements;
    int held = 0;
    double largest = 1e-6;  // N, N m: what balances nothing is nothing up to rounding
    for (const EffortValue& effort : solution.efforts)
        if (effort.value) largest = std::max(largest, std::abs(effort.value->to_double()));
    for (const Displacements::Effort& effort : found.efforts) {
        if (solution.efforts.empty()) break;  // forces are not asked for
        const EffortValue& by_forces = solution.efforts[at_index(effort.given)];
        if (!effort.value || !by_forces.value) continue;
        ++held;
        const double value = effort.value->to_double();
        EXPECT_NEAR(value, by_forces.value->to_double(), 1e-9 * largest) << name << " " << by_forces.name;
        if (solution.pose.exact && found.freedoms.size() == 1) {
            EXPECT_EQ(*effort.value, *by_forces.value) << name;
        }
        if (effort.ratio) {
            EXPECT_NEAR(*effort.ratio, value, 1e-9 * largest) << name << " by ratios";
        }
    }
    for (const CheckRow& row : solution.checks)
        if (row.quantity.kind == Quantity::Kind::virtual_effort) {
            EXPECT_LE(std::abs(row.difference), 1e-9 * std::max(largest, std::abs(row.numeric))) << name;
        }
    return held;
}

TEST(VirtualWork, LiftsTheSluiceGateOfTheCourse) {
    const Solution& solution = tests::example("virtual_work");
    ASSERT_TRUE(solution.displacements);
    const Displacements& found = *solution.displacements;
    ASSERT_EQ(found.freedoms.size(), 1U);
    EXPECT_TRUE(found.freedoms.front().chosen) << "nothing drives it";
    EXPECT_EQ(coordinate_name(solution.mechanism, found.freedoms.front().driver), "theta 1");
    ASSERT_EQ(found.efforts.size(), 1U);
    ASSERT_TRUE(found.efforts.front().value);
    // The course reads 18 mm, 2.09e7 N, off its drawing; the force polygons of sluice_gate.json give 20.6419708 MN.
    EXPECT_NEAR(std::abs(found.efforts.front().value->to_double()), 2.09e7, 0.02e7 * 2);
    EXPECT_NEAR(found.efforts.front().value->to_double(), -2.06419708e7, 1);
    EXPECT_NEAR(found.efforts.front().ratio.value(), -2.06419708e7, 1);
    // δL = m g · 10 m · δθ for the weight alone: O lies 10 m to the left of the hinge.
    const VirtualWork& work = *found.freedoms.front().moved->virtual_work;
    EXPECT_EQ(work.total, Exact(1660000) * Exact::from_double(10) * Exact(981) / Exact(100));
    EXPECT_TRUE(solution.free_bodies.empty()) << "no reaction was found on the way";
    EXPECT_TRUE(std::any_of(solution.checks.begin(), solution.checks.end(),
                            [](const CheckRow& row) { return row.quantity.kind == Quantity::Kind::virtual_effort; }));
}

TEST(VirtualWork, IsTheCoursesVelocityRatioForASliderCrank) {
    const Solution solution = displaced(slider_crank(
        R"(, "loads": [{"force": "F", "body": 4, "at": "B", "value": [-1000, 0]}], "effort": {"couple": "M",
        "body": 2})"));
    const Displacements& found = *solution.displacements;
    // M = −F Λ, Λ = dc/dα = −50.84 mm/rad.
    EXPECT_NEAR(found.efforts.front().value->to_double(), -50.84, 0.005);
    EXPECT_GT(hold_efforts_together(solution, "slider-crank"), 0);
}

TEST(VirtualWork, AgreesWithTheForcePolygonsOfEveryExample) {
    int held = 0;
    for (const std::string& name : tests::example_names()) {
        const std::string text = tests::contents(tests::example_file(name));
        auto mechanism = read_mechanism(text, name);
        ASSERT_TRUE(mechanism) << name;
        if (mechanism->efforts.empty() || mechanism->joints.empty()) continue;
        const Solution solution = displaced(text);
        if (!solution.displacements->why_not.empty()) {
            EXPECT_TRUE(solution.mobility.effective == 0)
                << name << ": " << solution.displacements->why_not.in(Language::en);
            continue;
        }
        held += hold_efforts_together(solution, name);
    }
    EXPECT_GE(held, 12);
}

TEST(VirtualWork, AgreesWithTheForcePolygonsOfRandomMechanisms) {
    int held = 0;
    for (int seed = 1; seed <= unless_sanitized(25, 5); ++seed) {
        const RandomMechanism drawn = random_mechanism(static_cast<std::uint64_t>(seed) * 29);
        const Solution bare = tests::solved(drawn.text);
        const std::string text = under_random_loads(drawn.text, bare.mechanism, bare.pose,
                                                    static_cast<std::uint64_t>(seed), drawn.freedoms, true);
        const Solution solution = displaced(text);
        ASSERT_TRUE(solution.displacements->why_not.empty())
            << solution.displacements->why_not.in(Language::en) << text;
        held += hold_efforts_together(solution, drawn.recipe + text);
    }
    EXPECT_GE(held, unless_sanitized(12, 2));
}

TEST(VirtualWork, HasAnEquationForEachFreedom) {
    // Two links in a row, each with a couple: Γ_1 = −F_y (x_B − x_O) …, by moments about the hinges.
    const Solution solution = displaced(R"({"kinegraph": 1, "frame": 0,
      "points": {"O": [0, 0], "A": [2, 1], "B": [3, -1]},
      "bodies": {"1": {"points": ["O", "A"]}, "2": {"points": ["A", "B"]}},
      "joints": [{"revolute": "O", "bodies": [0, 1]}, {"revolute": "A", "bodies": [1, 2]}],
      "loads": [{"force": "F", "body": 2, "at": "B", "value": [7, -5]}],
      "effort": [{"couple": "M1", "body": 1}, {"couple": "M2", "body": 2, "from": 1}]})");
    const Displacements& found = *solution.displacements;
    ASSERT_EQ(found.freedoms.size(), 2U);
    ASSERT_EQ(found.efforts.size(), 2U);
    EXPECT_EQ(*found.efforts[0].value, Exact(-(3 * -5 - -1 * 7)));
    EXPECT_EQ(*found.efforts[1].value, Exact(-(1 * -5 - -2 * 7)));
    EXPECT_TRUE(found.balanced);
}

TEST(VirtualWork, TellsEquilibriumAndItsAbsence) {
    const std::string still = R"(, "loads": [{"force": "F", "body": 4, "at": "B", "value": [0, -9]}])";
    EXPECT_TRUE(displaced(slider_crank(still)).displacements->balanced) << "the force lies across the slide";
    const std::string pushed = R"(, "loads": [{"force": "F", "body": 4, "at": "B", "value": [3, -9]}])";
    EXPECT_FALSE(displaced(slider_crank(pushed)).displacements->balanced);
}

TEST(VirtualWork, HasNothingToSayOfWhatStands) {
    const Solution& solution = tests::example("cantilever");
    EXPECT_EQ(solution.displacements, nullptr);
    EXPECT_FALSE(displaced(tests::contents(tests::example_file("cantilever"))).displacements->why_not.empty());
}

}  // namespace
}  // namespace kinegraph::virtual_work_test
