// The motion of a point: closed forms, derivatives in symbols against the rules of differentiation, what is not
// defined, what is refused, and that nothing hostile takes long.
#include "engine/file/units.hpp"  // before signal.h, which makes a macro of si_value

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "constructions/solving/solve.hpp"
#include "engine/file/expression.hpp"
#include "engine/results/results.hpp"
#include "problems/point/point.hpp"
#include "render/figures/caption.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/problem_tests.hpp"
#include "tests/support/schema_gate.hpp"
#include "tests/support/through_all.hpp"

namespace kinegraph::point_test {
namespace {

using std::numbers::pi;
using tests::example;

const PointMotionSolution& motion_of(const Solution& solution) {
    return tests::found_in<PointMotionSolution>(solution);
}
Solution moving(const std::string& members) {
    return tests::solved(R"~({"kinegraph": 1, "motion": {)~" + members + "}}");
}

/// The derivative in symbols, as text.
std::string derivative(const std::string& text, NamedConstants& constants) {
    const ExpressionForm form{"t", QuantityKind::time, QuantityKind::length, 1};
    const auto letter = [](std::string_view) { return tl::expected<Measured, Words>(bare(Exact(3))); };
    const auto read = read_expression(text, form, letter, constants);
    if (!read) return read.error().in(Language::en);
    const auto derived = derivative(read->tree, constants);
    return derived ? written(*derived, constants, "t") : derived.error().message.in(Language::en);
}

// ----- closed forms

TEST(PointMotion, ProjectileHasItsClosedForms) {
    const PointMotionSolution found = motion_of(example("motion/projectile"));
    const double g = 9.81, vx = 10, vy = 20 * std::sin(pi / 3) - g, v = std::hypot(vx, vy);
    EXPECT_NEAR(found.speed, v, 1e-12);
    EXPECT_NEAR(found.along, -g * vy / v, 1e-12);
    EXPECT_NEAR(found.across, g * vx / v, 1e-12);
    EXPECT_NEAR(found.radius, v * v * v / (g * vx), 1e-10);
    // s = ∫ (v_x² + v_y²)^½ dt
    const auto primitive = [&](double u) { return 0.5 * (u * std::hypot(vx, u) + vx * vx * std::asinh(u / vx)); };
    EXPECT_NEAR(found.way, (primitive(20 * std::sin(pi / 3)) - primitive(vy)) / g, 1e-10);
    const nlohmann::json results = nlohmann::json::parse(
        results_json(example("motion/projectile"), false, [](const Message&) { return std::string(); }));
    EXPECT_EQ(results.at("motion").at("derivatives").at("y").at(1), "v0*sin(alpha) - g*t");
    EXPECT_EQ(results.at("motion").at("derivatives").at("y").at(2), "-g");
}

TEST(PointMotion, CirclesHaveTheirRadiusAndCentre) {
    const PointMotionSolution uniform = motion_of(example("motion/circular"));
    EXPECT_NEAR(uniform.across, 4 * 0.05, 1e-15);
    EXPECT_NEAR(uniform.radius, 0.05, 1e-15);
    EXPECT_NEAR(length(*uniform.centre), 0, 1e-15);
    EXPECT_EQ(uniform.along, 0);  // what is only rounding is nothing
    const PointMotionSolution accelerated = motion_of(example("motion/accelerated_circle"));
    EXPECT_NEAR(accelerated.along, 1.5, 1e-14);
    EXPECT_NEAR(accelerated.across, 9 / 2.0, 1e-14);
    EXPECT_NEAR(accelerated.radius, 2, 1e-14);
    EXPECT_NEAR(accelerated.way, 3, 1e-14);
}

// y = x²/2p: s = (x √(p² + x²)/p + p arsinh(x/p))/2, however tight the bend at the vertex.
TEST(PointMotion, ATightParabolaHasItsLengthByConstructionAndCheck) {
    for (const double p : {2.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-7, 1e-9, 1e-15, 1e-30}) {
        for (const char* start : {"0", "-0.01"}) {
            if (p < 1e-7 && *start == '-') continue;  // too far up its arm
            std::array<char, 32> text{};
            std::snprintf(text.data(), text.size(), "%g m", p);
            const Solution solution =
                moving(R"~("point": "P", "path": {"y": "x^2/(2*p)", "start": )~" + std::string(start) +
                       R"(}, "s": "v*t", "constants": {"v": "1 m/s", "p": ")" + text.data() +
                       R"("}, "at": "2 s", "from": 0, "to": "3 s")");
            const VectorOf<double> place = to_double(motion_of(solution).place);
            const auto way = [p](double x) { return (x * std::hypot(p, x) / p + p * std::asinh(x / p)) / 2; };
            const double from = std::strtod(start, nullptr), whole = std::max(2.0, -way(from));
            EXPECT_NEAR(way(place.x) - way(from), 2, 1e-11 * whole) << text.data() << " from " << start;
            EXPECT_NEAR(place.y, place.x * place.x / (2 * p), 1e-12 * whole) << text.data();
            for (const ProblemValue& each : solution.problem->values)
                if (each.key == "x" || each.key == "y" || each.key == "way" || each.key == "speed") {
                    EXPECT_NEAR(each.value, *each.numeric, 1e-10 * whole) << each.key << ", p = " << text.data();
                }
        }
    }
}

TEST(PointMotion, HarmonicAndUniformMotionAreStraight) {
    const Solution& harmonic = example("motion/harmonic");
    const PointMotionSolution& found = motion_of(harmonic);
    EXPECT_TRUE(found.straight);
    EXPECT_FALSE(found.centre);
    EXPECT_NEAR(found.acceleration.x.to_double(), -4 * pi * pi * found.place.x.to_double(), 1e-12);
    EXPECT_EQ(harmonic.problem->remarks.size(), 1u);
    const PointMotionSolution uniform = motion_of(example("motion/uniform"));
    EXPECT_TRUE(uniform.acceleration.is_zero());
    EXPECT_TRUE(uniform.straight);
    EXPECT_NEAR(uniform.way, 10, 1e-12);
}

TEST(PointMotion, SpiralKeepsItsAngle) {
    // r = r₀e^{kθ}: the velocity makes the same angle with every radius, and ρ = r (1 + k²)^½.
    const PointMotionSolution found = motion_of(example("motion/spiral"));
    EXPECT_NEAR(found.polar_velocity[1] / found.polar_velocity[0], 1 / 0.2, 1e-13);
    EXPECT_NEAR(found.radius, found.r * std::sqrt(1 + 0.04), 1e-12);
    EXPECT_NEAR(found.r, 0.5 * std::exp(0.8), 1e-14);
    EXPECT_NEAR(found.polar_acceleration[1], 2 * found.polar_velocity[0] * 1, 1e-13);
}

TEST(PointMotion, WayAlongAParabolaIsItsLength) {
    const PointMotionSolution found = motion_of(example("motion/parabola"));
    const double x = found.place.x.to_double(), p = 2, s = 2 + 0.25 * 4;
    EXPECT_NEAR(0.5 * (x * std::hypot(1, x / p) + p * std::asinh(x / p)), s, 1e-12);
    EXPECT_NEAR(found.radius, p * std::pow(1 + x * x / p / p, 1.5), 1e-11);
    EXPECT_NEAR(found.along, 0.5, 1e-13);
    EXPECT_NEAR(found.speed, 2, 1e-13);
}

TEST(PointMotion, AtRestNoTangentIsDefined) {
    const Solution& solution = example("motion/at_rest");
    const PointMotionSolution& found = motion_of(solution);
    EXPECT_TRUE(found.rests);
    EXPECT_TRUE(found.at_pole);
    EXPECT_FALSE(found.tangential || found.normal || found.centre);
    EXPECT_NEAR(found.acceleration.y.to_double(), 1, 1e-15);
    EXPECT_EQ(solution.problem->remarks.size(), 2u);
    const nlohmann::json results =
        nlohmann::json::parse(results_json(solution, false, [](const Message&) { return std::string(); }));
    EXPECT_TRUE(results.at("motion").at("radius of curvature").is_null());
    EXPECT_TRUE(results.at("motion").at("polar").is_null());
    // At a turn of the harmonic motion too, where v is no more than rounding.
    EXPECT_TRUE(motion_of(moving(R"~("x": "2*cos(pi*t)", "at": 1, "to": 2)~")).rests);
}

TEST(PointMotion, UnitsAreTheFilesWhereAnExpressionHasNone) {
    const PointMotionSolution bare_law = motion_of(tests::solved(
        R"~({"kinegraph": 1, "units": {"length": "cm"}, "motion": {"x": "3*t^2", "y": "t", "at": 1, "to": 2}})~"));
    EXPECT_NEAR(bare_law.velocity.x.to_double(), 0.06, 1e-16);
    // An angle alone is a number: radians.
    const PointMotionSolution polar = motion_of(moving(R"~("r": "2 m", "theta": "30° + 2*t", "at": 0, "to": 1)~"));
    EXPECT_NEAR(polar.theta, pi / 6, 1e-15);
    EXPECT_NEAR(polar.speed, 4, 1e-14);
    // Parameters are known too.
    const PointMotionSolution set = motion_of(tests::solved(
        R"~({"kinegraph": 1, "parameters": {"v": "2 m/s"}, "motion": {"x": "v*t + b", "constants": {"b": "= v*1 s"},
        "at": 1, "to": 2}})~"));
    EXPECT_NEAR(set.place.x.to_double(), 4, 1e-15);
}

TEST(PointMotion, ConstantsHaveUnitsPutTogether) {
    const PointMotionSolution found = motion_of(moving(
        R"~("x": "j*t^3/6", "y": "R*exp(k*t)", "constants": {"j": "6 m/s³", "R": "2 m", "k": "0.5 1/s"}, "at": 1,
        "to": 2)~"));
    EXPECT_NEAR(found.velocity.x.to_double(), 3, 1e-14);
    EXPECT_NEAR(found.velocity.y.to_double(), std::exp(0.5), 1e-14);
}

TEST(PointMotion, WhatIsFiniteIsNotTakenForAPole) {
    const auto follows = [](const std::string& law) {
        return motion_of(moving(R"~("x": ")~" + law + R"~(", "at": 0.5, "to": 1)~")).course.size() > 1;
    };
    for (const char* law : {"(1 - t^2)^(5/2)", "1/(t^2 - t + 0.2501)", "sqrt(t^2 + 1e-6)",
                            "tan(t) + atan(1/(t + 0.001))", "exp(-t)*cos(20*t)/(1 + t^2)", "log(1 + t)*asin(t/2)"})
        EXPECT_TRUE(follows(law)) << law;
}

TEST(PointMotion, ConstructionIsOnRecord) {
    const PointMotionSolution found = motion_of(example("motion/projectile"));
    const Protocol& record = found.record;
    const Vector foot = record.point(found.elements.foot).place() - found.place;
    EXPECT_TRUE(dot(foot, found.velocity).is_zero());
    EXPECT_TRUE(cross(found.acceleration - foot, found.velocity).is_zero());
    const Vector arm = record.point(found.elements.centre).place() - found.place;
    // ρ a_n = v², exactly.
    EXPECT_EQ(dot(arm, foot), squared_length(found.velocity));
    EXPECT_GT(record.program.strokes.size(), 8u);
}

TEST(PointMotion, ExamplesFollowThePublishedSchema) {
    for (const char* name :
         {"projectile", "spiral", "parabola", "accelerated_circle", "displacement", "three_positions"})
        EXPECT_TRUE(refused_by_schema(tests::contents(tests::example_file(std::string("motion/") + name))).empty())
            << name;
}

// ----- derivatives

TEST(PointMotion, DerivativesInSymbolsReadLikeABook) {
    NamedConstants constants;
    EXPECT_EQ(derivative("a*cos(w*t)", constants), "-a*w*sin(w*t)");
    EXPECT_EQ(derivative("t^3/3 - 2*t + 7", constants), "t^2 - 2");
    EXPECT_EQ(derivative("exp(-a*t)", constants), "-a*exp(-a*t)");
    EXPECT_EQ(derivative("7", constants), "0");
    // A sum that is divided by keeps a sign of its own, whatever order the library has it in.
    EXPECT_EQ(derivative("1/(b - a*t)", constants), "a/(b - a*t)^2");
    EXPECT_EQ(derivative("t/(w - a)^3", constants), "-1/(a - w)^3");
}

class RandomText {
public:
    explicit RandomText(unsigned seed) : random_(seed) {}
    std::string sum(int depth) {
        std::string text = factor(depth);
        for (int i = pick(3); i-- > 0;) text += (pick(2) == 0 ? " + " : " - ") + factor(depth) + "*" + factor(depth);
        return text;
    }

private:
    int pick(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }
    std::string factor(int depth) {
        static constexpr std::array functions{"sin", "cos", "exp", "atan", "tanh", "cosh"};
        if (depth == 0) return pick(3) == 0 ? std::to_string(1 + pick(9)) : pick(3) == 0 ? "b" : "t";
        switch (pick(5)) {
            case 0:
                return std::string(functions.at(static_cast<std::size_t>(pick(6)))) + "((" + sum(depth - 1) + ")/20)";
            case 1: return "(" + sum(depth - 1) + ")";
            case 2: return "t^" + std::to_string(2 + pick(3));
            case 3: return "sqrt(1 + (" + sum(depth - 1) + ")^2)";
            default: return "(" + sum(depth - 1) + ")/(3 + t^2)";
        }
    }
    std::mt19937 random_;
};

TEST(PointMotion, DerivativesInSymbolsAgreeWithTheRules) {
    RandomText random(7);
    const ExpressionForm form{"t", QuantityKind::time, QuantityKind::length, 1};
    const auto letter = [](std::string_view) { return tl::expected<Measured, Words>(bare(Exact::ratio(7, 5))); };
    int compared = 0;
    for (int i = 0; i < 60; ++i) {
        const std::string text = random.sum(2);
        SCOPED_TRACE(text);
        NamedConstants constants;
        const auto read = read_expression(text, form, letter, constants);
        if (!read) {
            EXPECT_NE(read.error().in(Language::en).find("fill pages"), std::string::npos)
                << read.error().in(Language::en);
            continue;
        }
        ++compared;
        // Written, it reads again as what has the same value.
        const auto again = read_expression(written(read->tree, constants, "t"), form, letter, constants);
        ASSERT_TRUE(again) << again.error().in(Language::en);
        const auto first = derivative(read->tree, constants);
        ASSERT_TRUE(first);
        const auto second = derivative(*first, constants);
        ASSERT_TRUE(second) << second.error().message.in(Language::en);
        for (const double t : {0.3, 1.7}) {
            const Jet numeric = jet(read->tree, constants, t);
            const double size = std::abs(numeric[0]) + std::abs(numeric[1]) + std::abs(numeric[2]);
            EXPECT_NEAR(estimate(again->tree, constants, t).value, numeric[0], 1e-11 * size);
            EXPECT_NEAR(estimate(*first, constants, t).value, numeric[1], 1e-10 * size);
            EXPECT_NEAR(estimate(*second, constants, t).value, numeric[2], 1e-9 * size);
            // And the rules themselves with differences.
            const double h = 1e-5, ahead = jet(read->tree, constants, t + h)[0],
                         behind = jet(read->tree, constants, t - h)[0];
            EXPECT_NEAR((ahead - behind) / (2 * h), numeric[1], 1e-4 * size);
        }
    }
    EXPECT_GT(compared, 30);
}

// ----- what is refused

struct Refused {
    const char *members, *where, *words;
};
class RefusedMotions : public testing::TestWithParam<Refused> {};

TEST_P(RefusedMotions, SayWhereAndWhy) {
    const auto& [members, where, words] = GetParam();
    auto mechanism = read_mechanism(std::string(R"~({"kinegraph": 1, "motion": {"at": 1, "to": 2, )~") + members + "}}",
                                    "motion.json");
    Errors errors;
    if (!mechanism) {
        errors = mechanism.error();
    } else {
        auto solved = solve(*std::move(mechanism));
        ASSERT_FALSE(solved) << members;
        errors = solved.error();
    }
    EXPECT_EQ(errors.front().where, where);
    EXPECT_NE(errors.front().message.in(Language::en).find(words), std::string::npos)
        << errors.front().message.in(Language::en);
    EXPECT_NE(errors.front().message.in(Language::en), errors.front().message.in(Language::it));
}
INSTANTIATE_TEST_SUITE_P(
    Each, RefusedMotions,
    testing::Values(
        Refused{R"~("x": "2*t +")~", "/motion/x", "the expression ends"},
        Refused{R"~("x": "2t")~", "/motion/x", "a product is written"},
        Refused{R"~("x": "t t")~", "/motion/x", "a product is written"},
        Refused{R"~("x": "(t")~", "/motion/x", "not closed"}, Refused{R"~("x": "foo(t)")~", "/motion/x", "no function"},
        Refused{R"~("x": "q*t")~", "/motion/x", "no constant is named"},
        Refused{R"~("x": "t/0")~", "/motion/x", "divides by zero"},
        Refused{R"~("x": "R + 2*t", "constants": {"R": "2 m"})~", "/motion/x", "do not go together in a sum"},
        Refused{R"~("x": "v", "constants": {"v": "2 m/s"})~", "/motion/x", "a length is wanted"},
        Refused{R"~("x": "R*cos(3*t)", "constants": {"R": "2 m"})~", "/motion/x", "of a number or an angle"},
        Refused{R"~("x": "2^R", "constants": {"R": "2 m"})~", "/motion/x", "an exponent must be a bare number"},
        Refused{R"~("x": "sqrt(R)", "constants": {"R": "2 m"})~", "/motion/x", "no quantity is that root"},
        Refused{R"~("x": "sqrt(t - 5)")~", "/motion/x", "not real"},
        Refused{R"~("x": "sqrt(t)")~", "/motion/x", "infinite"},
        Refused{R"~("x": "1/(t - 1)")~", "/motion/x", "infinite"},
        Refused{R"~("x": "log(t)")~", "/motion/x", "not real"},
        // Where no sample lies, and before and behind which all is finite.
        Refused{R"~("x": "tan(t)")~", "/motion/x", "infinite at t = 1.570796 s"},
        Refused{R"~("x": "1/(t - 1.2345)^2")~", "/motion/x", "infinite at t = 1.2345 s"},
        Refused{R"~("x": "1/(t^2 - 2.2222*t + 1.23454321)")~", "/motion/x", "infinite at t = 1.1111"},
        Refused{R"~("x": "sqrt((t - 1.234)*(t - 1.235))")~", "/motion/x", "at t = 1.23"},
        Refused{R"~("path": {"y": "1/x", "start": -2}, "s": "1000*t")~", "/motion/path/y", "this path"},
        Refused{R"~("x": "k*t", "constants": {"k": "2 m/q"})~", "/motion/constants/k", "unknown unit"},
        Refused{R"~("x": "10^10^10")~", "/motion/x", "an exponent must be"},
        Refused{R"~("x": "((10^1000)^1000)^1000")~", "/motion/x", "digits"},
        Refused{R"~("x": "((t^100)^100)^100")~", "/motion/x", "degree above"},
        Refused{R"~("x": "exp(exp(exp(exp(t*100))))")~", "/motion/x", "infinite"},
        Refused{R"~("x": "t", "constants": {"sin": 2})~", "/motion/constants/sin", "can be no constant"},
        Refused{R"~("x": "t", "theta": "t")~", "/motion/theta", "do not go together"},
        Refused{R"~("r": "t")~", "/motion", "\"theta\" is missing"}, Refused{R"~("y": "t")~", "/motion", "one of"},
        Refused{R"~("path": {"y": "x^2"})~", "/motion", "\"s\" is missing"},
        Refused{R"~("path": {"circle": {"radius": 0}}, "s": "t")~", "/motion/path/circle/radius", "greater than zero"},
        Refused{R"~("path": {"y": "sqrt(1 - x^2)"}, "s": "9*t")~", "/motion/path/y", "this path"},
        Refused{R"~("x": "t", "from": 3)~", "/motion/to", "must end after"},
        Refused{R"~("x": "t", "from": 1.5)~", "/motion/at", "outside"}));

// A flat path has its centre of curvature far beyond the paper: its arc is the tangent there.
TEST(PointMotion, PathsOfAnyExtentsAreDrawn) {
    for (const char* const speed : {"1e-12", "1e-9", "1e-6", "1e-3", "1", "1e3", "1e4", "1e6", "1e9", "1e12"}) {
        const std::string file = R"~({"kinegraph": 1, "motion": {"x": "v0*t", "y": "b*t^2", "constants": {"v0": ")~" +
                                 std::string(speed) + R"~( m/s", "b": "1 m/s²"}, "at": "1 s", "to": "3 s"}})~";
        EXPECT_TRUE(tests::through_all(file, tests::fonts()).drawn) << speed;
    }
    // v²/a of scales in doubles: 1 : 5 × 10¹⁹.
    EXPECT_EQ(render::ratio_words(4.999999999999999e16, Language::en), render::ratio_words(5e16, Language::en));
    EXPECT_EQ(render::ratio_words(0.0025, Language::en), "1 : 2.5");
}

TEST(PointMotion, NothingHostileTakesLong) {
    const auto refuses = [](const std::string& expression) {
        const std::string file = R"~({"kinegraph": 1, "motion": {"x": ")~" + expression + R"~(", "at": 1, "to": 2}})~";
        auto mechanism = read_mechanism(file, "hostile.json");
        return !mechanism || !solve(*std::move(mechanism));
    };
    std::string deep(10000, '(');
    EXPECT_TRUE(refuses(deep + "t" + std::string(10000, ')')));
    std::string nested = "t", powers = "t", product = "t", numbers = "1.0001";
    for (int i = 0; i < 99; ++i) nested = "sin(" + nested + ")";
    EXPECT_TRUE(refuses(nested));
    for (int i = 0; i < 200; ++i) powers += "^t";
    EXPECT_TRUE(refuses(powers));
    for (int i = 0; i < 120; ++i) product += "*sin(t)";
    EXPECT_TRUE(refuses(product));
    for (int i = 0; i < 4; ++i) numbers = "(" + numbers + ")^999";
    EXPECT_TRUE(refuses(numbers));
    EXPECT_TRUE(refuses(std::string(1001, '-') + "t"));
    EXPECT_FALSE(refuses("(1 + t)^400"));
}

}  // namespace
}  // namespace kinegraph::point_test
