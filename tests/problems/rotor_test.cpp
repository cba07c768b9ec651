// Balancing of rotors: published numbers, exact laws (the polygons close, turned and reordered rotors), random rotors
// against the check, rotors that need no mass, what one plane leaves, bearings, polygons on paper.
#include "engine/file/units.hpp"  // before signal.h, which makes a macro of si_value

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "engine/results/results.hpp"
#include "problems/rotor/rotor.hpp"
#include "render/problems/problem_sheet.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/problem_tests.hpp"

namespace kinegraph::rotor_test {
namespace {

using tests::example;

constexpr double degree = std::numbers::pi / 180;

const RotorSolution& rotor_of(const Solution& solution) { return tests::found_in<RotorSolution>(solution); }
const RotorProblem& stated_in(const Solution& solution) { return solution.mechanism.problem->as<RotorProblem>(); }
Solution balanced(const std::string& members) { return tests::stated("rotor", members); }
std::vector<std::string> keys_of(const Solution& solution) {
    std::vector<std::string> keys;
    for (const ProblemValue& each : solution.problem->values) keys.push_back(each.key);
    return keys;
}

/// A mass as a file states it.
struct Mass {
    std::string name, mass, radius, angle;
    int z = 0;
};
/// Each mass in a plane of its own; `rest`: further members.
std::string file_of(const std::vector<Mass>& masses, const std::string& rest, int a = -40, int b = 310) {
    std::string planes = R"("A": )" + std::to_string(a) + R"(, "B": )" + std::to_string(b), all;
    for (const Mass& each : masses) {
        planes += ", \"at " + each.name + "\": " + std::to_string(each.z);
        all += (all.empty() ? "" : ", ") + ("\"" + each.name + R"(": {"mass": )" + each.mass) + R"(, "radius": )" +
               each.radius + R"(, "angle": )" + each.angle + R"(, "plane": "at )" + each.name + "\"}";
    }
    return R"("planes": {)" + planes + R"(}, "masses": {)" + all + "}, " + rest;
}
const std::string in_both = R"("correction": [{"plane": "A"}, {"plane": "B"}])";

std::vector<Mass> random_masses(std::mt19937& random, bool exact) {
    // Directions with rational cosine and sine.
    const std::vector<std::string> ways{"[3, 4]",   "[-4, 3]", "[5, -12]", "[-8, -15]",
                                        "[20, 21]", "90",      "-180",     "[0, -7]"};
    std::vector<Mass> masses(2 + random() % 5);
    for (std::size_t i = 0; i < masses.size(); ++i) {
        Mass& each = masses[i];
        each.name = std::to_string(i + 1);
        each.mass = std::to_string(1 + random() % 50) + "." + std::to_string(random() % 10);
        each.radius = std::to_string(5 + random() % 200);
        each.angle = exact ? ways.at(random() % ways.size()) : std::to_string(random() % 360) + ".5";
        each.z = static_cast<int>(random() % 500) - 100;
    }
    return masses;
}

/// Σ U + corrections, and Σ U z + …: both vanish.
void expect_closed(const RotorProblem& problem, const RotorSolution& found) {
    Vector force, couple;
    const auto add = [&](const Vector& unbalance, const std::optional<std::size_t>& plane) {
        force = force + unbalance;
        couple = couple + problem.z_of(plane) * unbalance;
    };
    for (std::size_t i = 0; i < problem.masses.size(); ++i)
        add(found.unbalances[i].size * found.unbalances[i].direction, problem.masses[i].plane);
    for (std::size_t i = 0; i < problem.corrections.size(); ++i)
        add(found.balance.closing[i], problem.corrections[i].plane);
    EXPECT_TRUE(force.is_zero());
    EXPECT_TRUE(couple.is_zero());
}

TEST(Rotor, OnePlaneHasThePublishedNumbers) {
    // Khurmi and Gupta, Theory of Machines, balancing of several masses in one plane: 116 kg at 0.2 m, 201.48°, with
    // components rounded to three figures.
    const Solution solution = tests::solved(R"({"kinegraph": 1, "rotor": {"masses": {
        "1": {"mass": 200, "radius": 0.2, "angle": 0}, "2": {"mass": 300, "radius": 0.15, "angle": 45},
        "3": {"mass": 240, "radius": 0.25, "angle": 120}, "4": {"mass": 260, "radius": 0.3, "angle": 255}},
        "correction": [{"radius": 0.2}]}})");
    const RotorSolution::Correction& found = rotor_of(solution).corrections.at(0);
    EXPECT_NEAR(*found.mass, 116, 0.5);
    EXPECT_NEAR(found.angle, 201.48 * degree, 0.3 * degree);
    EXPECT_EQ(keys_of(solution), (std::vector<std::string>{"unbalance", "angle", "mass"}));
}

TEST(Rotor, TwoPlanesHaveThePublishedNumbers) {
    // The same, masses A … D with corrections in X and Y: 355 kg and 182.5 kg at 100 mm, measured on the drawing 145°
    // and 12° clockwise from A. A drawing is good for 1 % and two degrees.
    const Solution solution =
        balanced(R"("planes": {"a": 0, "X": 100, "b": 300, "c": 400, "Y": 500, "d": 700}, "masses": {
        "A": {"mass": 200, "radius": 80, "angle": 0, "plane": "a"}, "B": {"mass": 300, "radius": 70, "angle": 45, "plane": "b"},
        "C": {"mass": 400, "radius": 60, "angle": 115, "plane": "c"},
        "D": {"mass": 200, "radius": 80, "angle": 235, "plane": "d"}},
        "correction": [{"plane": "X", "radius": 100}, {"plane": "Y", "radius": 100}])");
    const RotorSolution& found = rotor_of(solution);
    EXPECT_NEAR(*found.corrections[0].mass, 355, 3.55);
    EXPECT_NEAR(found.corrections[0].angle, (360 - 145) * degree, 2 * degree);
    EXPECT_NEAR(*found.corrections[1].mass, 182.5, 1.825);
    EXPECT_NEAR(found.corrections[1].angle, (360 - 12) * degree, 2 * degree);
}

TEST(Rotor, ExampleHasTheNumbersOfItsComponents) {
    // By hand, in components: Σ U l cos θ = −4384.9, Σ U l sin θ = −13639.8 kg mm² about A; l_B = 360 mm.
    const RotorSolution& found = rotor_of(example("rotor/four_masses"));
    double x = 0, y = 0, fx = 0, fy = 0;
    const std::vector<std::array<double, 3>> rows{{120, 20, 60}, {120, 95, 140}, {120, 190, 220}, {112.5, 300, 290}};
    for (const auto& [u, angle, l] : rows) {
        fx += u * std::cos(angle * degree);
        fy += u * std::sin(angle * degree);
        x += u * l * std::cos(angle * degree);
        y += u * l * std::sin(angle * degree);
    }
    EXPECT_NEAR(x, -4384.9, 0.05);
    EXPECT_NEAR(y, -13639.8, 0.05);
    EXPECT_NEAR(found.corrections[1].unbalance * 1e6, 1e3 * std::hypot(x, y) / 360, 1e-6);
    EXPECT_NEAR(*found.corrections[1].mass, 0.663299, 1e-6);
    EXPECT_NEAR(found.corrections[1].angle, 72.179 * degree, 1e-5);
    EXPECT_NEAR(*found.corrections[0].mass, 1e-3 * std::hypot(fx - x / 360, fy - y / 360) / 0.06, 1e-9);
    EXPECT_NEAR(*found.corrections[0].mass, 1.598236, 1e-6);
    EXPECT_NEAR(found.corrections[0].angle, 236.765 * degree, 1e-5);
    EXPECT_NEAR(found.reactions[0].force, 297.100, 1e-3);
    EXPECT_NEAR(found.reactions[1].force, 78.3416, 1e-4);
}

TEST(Rotor, WithTheCorrectionsBothPolygonsCloseExactly) {
    std::mt19937 random(1);
    for (int round = 0; round < 40; ++round) {
        const std::string members = file_of(random_masses(random, true), in_both);
        SCOPED_TRACE(members);
        const Solution solution = balanced(members);
        const RotorSolution& found = rotor_of(solution);
        EXPECT_TRUE(found.exact);
        expect_closed(stated_in(solution), found);
        for (const RotorPolygon* polygon : {&found.balance.couples, &found.balance.forces}) {
            // Each side begins where the last one ends; the last ends where the first begins.
            const auto& sides = polygon->sides;
            ASSERT_GE(sides.size(), 2u);
            for (std::size_t i = 1; i < sides.size(); ++i) EXPECT_EQ(sides[i].tail, sides[i - 1].tip);
            EXPECT_EQ(sides.back().tip, sides.front().tail);
        }
    }
}

TEST(Rotor, TurningAllAnglesTurnsTheAnswer) {
    std::mt19937 random(2);
    for (int round = 0; round < 20; ++round) {
        std::vector<Mass> masses = random_masses(random, false);
        const RotorSolution before = rotor_of(balanced(file_of(masses, in_both)));
        for (Mass& each : masses) each.angle = std::to_string(std::stod(each.angle) + 37);
        const RotorSolution after = rotor_of(balanced(file_of(masses, in_both)));
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_NEAR(after.corrections[i].unbalance, before.corrections[i].unbalance,
                        1e-14 * before.corrections[i].unbalance);
            const double turned = after.corrections[i].angle - before.corrections[i].angle - 37 * degree;
            EXPECT_NEAR(std::remainder(turned, 360 * degree), 0, 1e-12);
        }
    }
    // A quarter turn, exactly.
    const auto closing = [](const std::string& first, const std::string& second) {
        return rotor_of(balanced(file_of({{"1", "2", "30", first, 0}, {"2", "3", "40", second, 100}}, in_both)))
            .balance.closing;
    };
    const auto here = closing("[3, 4]", "[-5, 12]"), turned = closing("[-4, 3]", "[-12, -5]");
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(quarter_turn(here[i]), turned[i]);
}

TEST(Rotor, OrderOfTheMassesAndOriginOfTheShaftDoNotMatter) {
    std::mt19937 random(3);
    for (int round = 0; round < 20; ++round) {
        std::vector<Mass> masses = random_masses(random, true);
        const auto closing = [&](int shift) {
            std::vector<Mass> moved = masses;
            for (Mass& each : moved) each.z += shift;
            return rotor_of(balanced(file_of(moved, in_both, -40 + shift, 310 + shift))).balance.closing;
        };
        const auto first = closing(0);
        EXPECT_EQ(closing(1234), first);
        std::shuffle(masses.begin(), masses.end(), random);
        EXPECT_EQ(closing(0), first);
        // A and B in the other order.
        const std::string other = R"("correction": [{"plane": "B"}, {"plane": "A"}])";
        const auto swapped = rotor_of(balanced(file_of(masses, other))).balance.closing;
        EXPECT_EQ(swapped, (std::vector<Vector>{first[1], first[0]}));
    }
}

TEST(Rotor, RandomRotorsAgreeWithTheCheck) {
    std::mt19937 random(4);
    const std::vector<std::string> corrections{
        in_both, R"("correction": [{"plane": "A", "radius": 35}, {"plane": "B", "mass": 0.4}])",
        R"("correction": [{"plane": "B", "radius": 35}])"};
    for (int round = 0; round < 60; ++round) {
        std::string members = file_of(random_masses(random, false), corrections.at(random() % corrections.size()));
        if (random() % 2 == 0) members += R"(, "bearings": ["A", "B"], "omega": "1450 rpm")";
        SCOPED_TRACE(members);
        const Solution solution = balanced(members);
        // Sums of a few terms in doubles, where terms may cancel to a thousandth.
        tests::expect_near_check(*solution.problem, 1e-10, tests::Against::itself);
        EXPECT_TRUE(
            std::none_of(solution.problem->remarks.begin(), solution.problem->remarks.end(),
                         [](const Words& each) { return each.in(Language::en).find("check") != std::string::npos; }));
    }
}

TEST(Rotor, ABalancedRotorNeedsNoMass) {
    // Cosines and sines of 120° are not rational: that they cancel is a verdict.
    const std::string star = R"("masses": {"1": {"mass": 2, "radius": 50, "angle": 10, "plane": "M"},
        "2": {"mass": 2, "radius": 50, "angle": 130, "plane": "M"}, "3": {"mass": 1, "radius": 100, "angle": 250, "plane": "M"}},
        "planes": {"A": 0, "M": 70, "B": 100}, )";
    const Solution solution = balanced(
        star + R"("correction": [{"plane": "A", "radius": 40}, {"plane": "B"}], "bearings": ["B", "A"], "omega": 100)");
    const RotorSolution& found = rotor_of(solution);
    EXPECT_TRUE(found.is_balanced_already());
    EXPECT_FALSE(found.exact);
    EXPECT_EQ(*found.corrections[0].mass, 0);
    for (const RotorSolution::Reaction& each : found.reactions) EXPECT_TRUE(each.vanishes);
    EXPECT_EQ(keys_of(solution),
              (std::vector<std::string>{"unbalance A", "mass A", "unbalance B", "reaction B", "reaction A"}));
    ASSERT_EQ(solution.problem->remarks.size(), 1u);
    EXPECT_NE(solution.problem->remarks[0].in(Language::en).find("balanced already"), std::string::npos);
    // A nanometre more is no rounding.
    std::string off = star;
    off.replace(off.find("100, \"angle\": 250"), 3, "100.000001");
    EXPECT_FALSE(rotor_of(balanced(off + R"("correction": [{"plane": "A"}, {"plane": "B"}])")).is_balanced_already());
}

TEST(Rotor, CorrectedRotorIsBalanced) {
    // U = (3, 0) and (0, 4): the correction (−3, −4) of size 5.
    const std::string masses =
        R"("masses": {"1": {"mass": 3, "radius": 1, "angle": 0}, "2": {"mass": 4, "radius": 1, "angle": 90})";
    const RotorSolution found = rotor_of(balanced(masses + R"(}, "correction": [{"radius": 2}])"));
    EXPECT_EQ(*found.corrections[0].mass, 2.5);
    EXPECT_TRUE(found.exact);
    const RotorSolution again = rotor_of(
        balanced(masses + R"(, "3": {"mass": 2.5, "radius": 2, "angle": [-3, -4]}}, "correction": [{"radius": 2}])"));
    EXPECT_TRUE(again.is_balanced_already());
}

TEST(Rotor, OnePlaneLeavesACouple) {
    // Two equal and opposite masses 300 mm apart: static balance is there, dynamic is not.
    const std::vector<Mass> pair{{"1", "2", "50", "0", 0}, {"2", "2", "50", "180", 300}};
    const std::string run = R"(, "bearings": ["A", "B"], "omega": 100)";
    const Solution statically = balanced(file_of(pair, R"("correction": [{"plane": "A"}])" + run, -100, 400));
    const RotorSolution& one = rotor_of(statically);
    EXPECT_TRUE(one.is_balanced_already());
    EXPECT_EQ(*one.couple_left, (Vector{-Exact::ratio(3, 100), 0}));  // 2 · 0.05 · 0.3 kg m²
    EXPECT_DOUBLE_EQ(*one.reaction_left, 0.03 * 100 * 100 / 0.5);
    EXPECT_EQ(statically.problem->remarks.size(), 2u);
    // Dynamically the corrections are such a pair, too.
    const RotorSolution two = rotor_of(balanced(file_of(pair, in_both + run, -100, 400)));
    EXPECT_EQ(two.balance.closing[0], -two.balance.closing[1]);
    EXPECT_FALSE(two.is_balanced_already());
    // With all masses in the correction plane nothing is left.
    const Solution disc = balanced(
        file_of({{"1", "2", "50", "33", 5}, {"2", "1", "50", "99", 5}}, R"("correction": [{"plane": "A"}])", 5, 10));
    EXPECT_TRUE(rotor_of(disc).couple_left->is_zero());
    EXPECT_TRUE(disc.problem->remarks.empty());
}

TEST(Rotor, BearingsHoldTheForcesOfTheMasses) {
    const std::vector<Mass> masses{{"1", "2", "50", "[3, 4]", 100}, {"2", "3", "20", "180", 200}};
    const auto held = [&](const std::string& omega) {
        return rotor_of(balanced(file_of(masses, in_both + R"(, "bearings": ["B", "A"], "omega": )" + omega)));
    };
    const RotorSolution slow = held("50"), fast = held("-150");
    for (std::size_t i = 0; i < 2; ++i) {
        // As corrections in their planes, times ω².
        EXPECT_EQ(slow.held->closing[i], slow.balance.closing[1 - i]);
        EXPECT_DOUBLE_EQ(slow.reactions[i].force, 2500 * slow.corrections[1 - i].unbalance);
        EXPECT_NEAR(fast.reactions[i].force, 9 * slow.reactions[i].force, 1e-12 * fast.reactions[i].force);
        EXPECT_EQ(fast.reactions[i].angle, slow.reactions[i].angle);
    }
}

TEST(Rotor, ResultsNameTheCorrections) {
    const auto results =
        nlohmann::json::parse(results_json(example("rotor/fan"), true, [](const Message&) { return std::string(); }));
    const auto& rotor = results.at("rotor");
    EXPECT_EQ(rotor.at("kind"), "static");
    EXPECT_EQ(rotor.at("balanced already"), false);
    // (16, 12) + (−24, 0) + (0, −30) kg mm, closed by (8, 18).
    EXPECT_EQ(rotor.at("exact"), nlohmann::json::parse(R"([["1/125", "9/500"]])"));
    EXPECT_NEAR(rotor.at("corrections").at(0).at("radius").get<double>(), std::hypot(8e-3, 18e-3) / 0.2, 1e-15);
    const auto dynamic = nlohmann::json::parse(
        results_json(example("rotor/four_masses"), true, [](const Message&) { return std::string(); }));
    EXPECT_TRUE(dynamic.at("rotor").at("exact").is_null());
    EXPECT_EQ(dynamic.at("rotor").at("corrections").at(1).at("plane"), "B");
    EXPECT_EQ(dynamic.at("rotor").at("reactions").size(), 2u);
}

TEST(Rotor, UnbalancesAreSaidInTheUnitsOfTheFile) {
    const Solution& solution = example("rotor/four_masses");
    const auto found = std::find_if(solution.problem->values.begin(), solution.problem->values.end(),
                                    [](const ProblemValue& each) { return each.key == "unbalance A"; });
    ASSERT_NE(found, solution.problem->values.end());
    EXPECT_EQ(found->unit, "kg m");
    EXPECT_NEAR(found->value, 0.0958942, 1e-7);
    const std::string table = render::problem_table(solution, Language::en);
    EXPECT_NE(table.find("95.894 kg mm"), std::string::npos) << table;
}

/// Along one line they would cover each other.
TEST(Rotor, VectorsAlongOneLineStandSideBySide) {
    using namespace render;
    const Theme theme;
    const Solution solution = balanced(
        file_of({{"1", "2", "50", "0", 0}, {"2", "3", "50", "180", 100}, {"3", "2", "50", "0", 200}}, in_both));
    const DrawingContext context{solution, theme, tests::fonts()};
    for (const RotorFigure which : {RotorFigure::forces, RotorFigure::couples}) {
        const Figure figure = rotor_polygon(context, which, 80, 70);
        std::vector<double> heights;
        for (const Mark& mark : figure.marks)
            if (const auto* axis = std::get_if<Axis>(&mark)) {
                EXPECT_NEAR(axis->tail.y, axis->tip.y, 1e-9);
                heights.push_back(axis->tip.y);
            }
        ASSERT_GE(heights.size(), 4u);
        std::sort(heights.begin(), heights.end());
        for (std::size_t i = 1; i < heights.size(); ++i) EXPECT_GT(heights[i] - heights[i - 1], 2);
    }
}

/// What is measured on paper is the result, and the polygons close.
TEST(Rotor, PolygonsCloseOnPaper) {
    using namespace render;
    const Theme theme;
    std::size_t drawn = 0;
    for (const char* const name : {"rotor/four_masses", "rotor/fan"}) {
        SCOPED_TRACE(name);
        const Solution& solution = example(name);
        const DrawingContext context{solution, theme, tests::fonts()};
        std::vector<RotorFigure> figures{RotorFigure::forces};
        if (stated_in(solution).is_dynamic())
            figures.insert(figures.end(),
                           {RotorFigure::couples, RotorFigure::bearing_couples, RotorFigure::bearing_forces});
        for (const RotorFigure which : figures) {
            const Figure figure = rotor_polygon(context, which, 80, 70);
            std::vector<Axis> axes;
            std::vector<double> values;
            for (const Mark& mark : figure.marks) {
                if (const auto* axis = std::get_if<Axis>(&mark)) axes.push_back(*axis);
                if (const auto* group = std::get_if<GroupBegin>(&mark); group != nullptr && group->cls == "vector")
                    values.push_back(std::stod(*group->attribute("data-value")));
            }
            ASSERT_EQ(axes.size(), values.size());
            ASSERT_GE(axes.size(), 4u);
            const Unit unit = which == RotorFigure::couples || which == RotorFigure::bearing_couples
                                  ? unit_of_couple(solution.mechanism.units)
                                  : unit_of_unbalance(solution.mechanism.units);
            for (std::size_t i = 0; i < axes.size(); ++i) {
                const Spot next = axes[(i + 1) % axes.size()].tail;
                EXPECT_LT(length(axes[i].tip - next), 1e-6);
                EXPECT_NEAR(length(axes[i].tip - axes[i].tail) * figure.scale * unit.si.to_double(), values[i], 1e-9);
                ++drawn;
            }
        }
    }
    EXPECT_GE(drawn, 20u);
}

}  // namespace
}  // namespace kinegraph::rotor_test
