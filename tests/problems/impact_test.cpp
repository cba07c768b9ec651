// Impact: momentum, restitution and energy exactly; every class; Routh's course against Newton's laws step by step;
// bodies that part.
#include "engine/file/units.hpp"  // before signal.h, which makes a macro of si_value

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "constructions/solving/solve.hpp"
#include "problems/impact/impact.hpp"
#include "tests/support/problem_tests.hpp"

namespace kinegraph::impact_test {
namespace {

using tests::example;
using tests::solved;

const ImpactSolution& impact_of(const Solution& solution) { return tests::found_in<ImpactSolution>(solution); }
const ImpactProblem& given_in(const Solution& solution) { return solution.mechanism.problem->as<ImpactProblem>(); }

void expect_near_check(const Solution& solution, double share) {
    tests::expect_near_check(*solution.problem, share, tests::Against::largest);
}

/// The laws that hold exactly whatever the friction.
void expect_balance(const Solution& solution) {
    const ImpactSolution& found = impact_of(solution);
    Exact before, after;
    for (std::size_t i = 0; i < 2; ++i) {
        const ImpactSolution::Body& body = found.bodies.at(i);
        const ImpactBody& given = given_in(solution).bodies.at(i);
        if (body.fixed) continue;
        Vector impulse = i == 0 ? found.impulse : -found.impulse;
        if (body.reaction) impulse = impulse + *body.reaction;
        EXPECT_EQ(given.mass * (body.after - body.before), impulse);
        const Exact inertia = given.inertia.value_or(Exact());
        before += (given.mass * squared_length(body.before) + inertia * square(body.omega_before)) / 2;
        after += (given.mass * squared_length(body.after) + inertia * square(body.omega_after)) / 2;
    }
    EXPECT_EQ(before, found.energy_before);
    EXPECT_EQ(before - after, found.energy_lost);
    EXPECT_GE(found.energy_lost.sign(), 0);
    EXPECT_GE(found.separation.sign(), 0);
    EXPECT_LE(abs(found.tangential_impulse), found.friction * found.normal_impulse);
    if (found.friction.is_zero()) {
        EXPECT_EQ(found.kinematic_restitution, found.restitution);
    }
}

TEST(Impact, OfEveryExampleKeepsTheLawsAndAgreesWithNewtonStepByStep) {
    for (const char* name : {"newtons_cradle_pair", "ball_against_wall", "rod_hit_off_centre", "ballistic_pendulum",
                             "billiard_shot", "falling_rod"}) {
        SCOPED_TRACE(name);
        const Solution& solution = example(std::string("contact/") + name);
        expect_balance(solution);
        expect_near_check(solution, 1e-6);
    }
}

TEST(Impact, EqualBallsOfACradleChangeTheirVelocities) {
    const ImpactSolution found = impact_of(example("contact/newtons_cradle_pair"));
    EXPECT_EQ(found.bodies[0].after, (Vector{0, 0}));
    EXPECT_EQ(found.bodies[1].after, (Vector{Exact::ratio(12, 10), 0}));
    EXPECT_TRUE(found.central && found.direct);
    EXPECT_TRUE(found.energy_lost.is_zero());
}

TEST(Impact, BallisticPendulumIsTheClosedForm) {
    // m v h = (I_O + m h²) ω, hit at its centre of percussion: the pivot feels nothing.
    const ImpactSolution found = impact_of(example("contact/ballistic_pendulum"));
    const Exact h = Exact::ratio(5, 4), m = Exact::ratio(1, 100), inertia = Exact::ratio(6, 1);
    EXPECT_EQ(found.bodies[1].omega_after, m * 400 * h / (inertia + m * h * h));
    EXPECT_EQ(*found.bodies[1].percussion, (Vector{0, -h}));
    EXPECT_EQ(*found.bodies[1].reaction, (Vector{0, 0}));
    EXPECT_FALSE(found.central);
}

TEST(Impact, RodHitOffItsCentreIsTheClosedForm) {
    // 1/μ = 1/m + 1/M + d²/I,  J = (1 + e) μ v.
    const ImpactSolution found = impact_of(example("contact/rod_hit_off_centre"));
    const Exact reduced = Exact(1) / (Exact(2) + Exact::ratio(1, 3) + Exact::ratio(4, 100) / Exact::ratio(9, 100));
    EXPECT_EQ(found.impulse, (Vector{0, -(Exact::ratio(3, 2) * reduced * 6)}));
}

TEST(Impact, ASlidingBallLosesFrictionTimesTheImpulse) {
    // A hollow ball (I = 2/3 m r²) stops sliding at (5/2) f (1 + e) v_n = 3.5 m/s along the floor; with 5 m/s it slides
    // throughout.
    const ImpactSolution found = impact_of(example("contact/ball_against_wall"));
    EXPECT_EQ(found.impulse, (Vector{-Exact::ratio(84, 100), Exact::ratio(42, 10)}));
    EXPECT_NEAR(found.obliquity, std::atan2(5, 4), 1e-15);
    EXPECT_TRUE(found.central);
    EXPECT_FALSE(found.direct);
}

/// A rod that falls with its lower end on a floor; friction and restitution vary.
std::string falling(double angle, double sideways, double friction, double restitution) {
    const auto text = [](double value) { return std::to_string(value); };
    return R"({"kinegraph": 1, "impact": {"bodies": {"rod": {"mass": 2, "centre": [)" + text(0.25 * std::cos(angle)) +
           ", " + text(0.25 * std::sin(angle)) + R"(], "inertia": 0.0416667, "velocity": [)" + text(sideways) +
           R"(, -3]}, "floor": {"fixed": true}}, "at": [0, 0], "normal": 90, "restitution": )" + text(restitution) +
           R"(, "friction": )" + text(friction) + "}}";
}

TEST(Impact, RouthAgreesWithNewtonWhereverTheContactSticksSlidesOrTurnsBack) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    int stuck = 0, reversed = 0, slid = 0;
    for (int i = 0; i < 40; ++i) {
        const std::string text =
            falling(0.6 + 2 * share(random), 4 * share(random) - 2, 0.6 * share(random), share(random));
        auto mechanism = read_mechanism(text, "rod.json");
        ASSERT_TRUE(mechanism);
        const auto solution = solve(*std::move(mechanism));
        if (!solution) continue;  // it jams, or would part
        SCOPED_TRACE(text);
        expect_balance(*solution);
        expect_near_check(*solution, 1e-6);
        int sense = 0;
        bool sticks = false, turns = false;
        for (const ImpactSolution::Phase& phase : impact_of(*solution).phases) {
            sticks = sticks || phase.kind == ImpactSolution::Phase::Kind::sticks;
            turns = turns || (sense != 0 && phase.sense == -sense);
            if (phase.sense != 0) sense = phase.sense;
        }
        stuck += sticks;
        reversed += turns;
        slid += !sticks && !turns;
    }
    EXPECT_GT(stuck, 0);
    EXPECT_GT(reversed, 0);
    EXPECT_GT(slid, 0);
}

/// A rod on a pivot comes to rest at once where friction jams it: slip and approach end in the same instant.
TEST(Impact, OfAPivotedRodAgreesWithNewtonAlsoWhereItJams) {
    int jammed = 0;
    for (const char* friction : {"0", "0.5", "1.7", "5"})
        for (const char* pivot : {"[0.3, 1]", "[-0.4, 0.8]", "[0.6, 0.2]"}) {
            const std::string text =
                std::string(R"({"kinegraph": 1, "impact": {"bodies": {"rod": {"mass": 1, "centre": [0.15, 0.5],
                "inertia": 0.1, "omega": 2, "pivot": )") +
                pivot +
                R"(}, "floor": {"fixed": true}}, "at": [0, 0], "normal": 90, "restitution": 0.5, "friction": )" +
                friction + "}}";
            auto mechanism = read_mechanism(text, "rod.json");
            ASSERT_TRUE(mechanism);
            const auto solution = solve(*std::move(mechanism));
            if (!solution) continue;  // it would part
            SCOPED_TRACE(text);
            expect_balance(*solution);
            expect_near_check(*solution, 1e-9);
            for (const Words& remark : solution->problem->remarks)
                EXPECT_EQ(in_english(remark).find("numeric check"), std::string::npos) << in_english(remark);
            jammed += impact_of(*solution).kinematic_restitution.is_zero();
        }
    EXPECT_GT(jammed, 0);
}

TEST(Impact, EveryClassIsToldFromTheOthers) {
    // A disc of centre C that hits the floor at the origin with the velocity v, perfectly plastic and perfectly
    // elastic.
    const auto hit = [](const char* centre, const char* velocity, const char* restitution) {
        return solved(
            std::string(R"({"kinegraph": 1, "impact": {"bodies": {"disc": {"mass": 2, "inertia": 0.5, "centre": )") +
            centre + R"(, "velocity": )" + velocity +
            R"(}, "floor": {"fixed": true}}, "at": [0, 0], "normal": 90, "restitution": )" + restitution + "}}");
    };
    for (const bool central : {true, false})
        for (const bool direct : {true, false}) {
            const char* const centre = central ? "[0, 1]" : "[1, 1]";
            const char* const velocity = direct ? "[0, -3]" : "[4, -3]";
            const Solution plastic = hit(centre, velocity, "0"), elastic = hit(centre, velocity, "1");
            for (const Solution* each : {&plastic, &elastic}) {
                expect_balance(*each);
                EXPECT_EQ(impact_of(*each).central, central);
                EXPECT_EQ(impact_of(*each).direct, direct);
                EXPECT_NEAR(impact_of(*each).obliquity, direct ? 0 : std::atan2(4, 3), 1e-15);
            }
            EXPECT_TRUE(impact_of(plastic).separation.is_zero());
            EXPECT_TRUE(impact_of(elastic).energy_lost.is_zero());
            EXPECT_EQ(impact_of(elastic).separation, -impact_of(elastic).approach);
            EXPECT_EQ(impact_of(elastic).normal_impulse, Exact(2) * impact_of(plastic).normal_impulse);
        }
}

TEST(Impact, ThatIsNoneIsRefused) {
    const auto error = [](const std::string& text) {
        auto mechanism = read_mechanism(text, "test.json");
        EXPECT_TRUE(mechanism) << mechanism.error().front().message.in(Language::en);
        const auto solution = solve(*std::move(mechanism));
        EXPECT_FALSE(solution);
        return solution ? Error{} : solution.error().front();
    };
    const auto two = [](const char* v) {
        return std::string(
                   R"({"kinegraph": 1, "impact": {"bodies": {"1": {"mass": 1, "centre": [-1, 0], "velocity": [)") +
               v + R"(, 0]}, "2": {"mass": 1, "centre": [1, 0]}}, "at": [0, 0], "normal": 0, "restitution": 1}})";
    };
    EXPECT_NE(error(two("-1")).message.in(Language::en).find("part"), std::string::npos);
    EXPECT_NE(error(two("0")).message.in(Language::en).find("do not approach"), std::string::npos);
    EXPECT_EQ(error(two("-1")).where, "/impact");
}

}  // namespace
}  // namespace kinegraph::impact_test
