// The kinematics of higher pairs: rolling, sliding contacts and gears, held against closed forms, against the lower
// pairs that are equivalent to them (exactly), against the laws of the plane and, on random mechanisms, against the
// check.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "tests/support/near_the_check.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::higher_pairs_test {
namespace {

using tests::solved;
using tests::worst_difference;

struct Reading {
    const Solution& solution;

    BodyIndex body(const char* name) const { return solution.mechanism.body_named(name).value(); }
    const PointMotion& motion(const char* point, const char* carrier) const {
        for (const PointMotion& node : solution.points) {
            if (node.point == solution.mechanism.point_named(point) &&
                std::count(node.bodies.begin(), node.bodies.end(), body(carrier)) > 0)
                return node;
        }
        throw std::out_of_range(std::string(point) + " on " + carrier + " has no motion");
    }
    Vector v(const char* point, const char* carrier) const { return motion(point, carrier).velocity.value(); }
    Vector a(const char* point, const char* carrier) const { return motion(point, carrier).acceleration.value(); }
    Exact omega(const char* name) const { return solution.bodies.at(at_index(body(name))).omega.value(); }
    Exact alpha(const char* name) const { return solution.bodies.at(at_index(body(name))).alpha.value(); }
};

/// Solved wholly, and as the check has it.
void expect_solved(const Solution& solution) {
    for (const Unsolved& missing : solution.unsolved) ADD_FAILURE() << english_of(missing);
    EXPECT_FALSE(solution.checks.empty());
    EXPECT_LE(worst_difference(solution), 1e-9);
}

// --- rolling
// -------------------------------------------------------------------------------------------------------------------

/// A disc of radius 1/5 that rolls on the x axis from left to right.
const std::string disc_on_line = R"({"kinegraph": 1, "frame": 1,
 "points": {"C": [0, 0.2], "P": [0, 0], "A": [0.12, 0.36]},
 "bodies": {"2": {"points": ["C", "P", "A"], "circle": {"centre": "C", "radius": 0.2}}},
 "joints": [{"rolling": "P", "bodies": [2, 1], "profiles": {"1": {"line": [1, 0]}}}],
 "drivers": [{"body": 2, "omega": -3, "alpha": 2}]})";

TEST(Rolling, OnALineEveryPointDrawsItsCycloid) {
    const Solution solution = solved(disc_on_line);
    expect_solved(solution);
    const Reading read{solution};
    EXPECT_EQ(read.v("P", "2"), Vector{});
    EXPECT_EQ(read.a("P", "2"), (Vector{0, Exact::ratio(9, 5)})) << "ω² r towards the centre";
    EXPECT_EQ(read.v("C", "2"), (Vector{Exact::ratio(3, 5), 0}));
    EXPECT_EQ(read.a("C", "2"), (Vector{Exact::ratio(-2, 5), 0})) << "α r along the line, nothing else";
    // ω ∧ PA, and a_C + α ∧ CA − ω² CA with CA = (0.12, 0.16).
    EXPECT_EQ(read.v("A", "2"), (Vector{Exact::ratio(27, 25), Exact::ratio(-9, 25)}));
    EXPECT_EQ(read.a("A", "2"), (Vector{Exact::ratio(-9, 5), Exact::ratio(-6, 5)}));
}

/// A disc of radius 5 about (3, 4)·k/5, touching a circle of the frame of radius 10 about the origin: k = 5 inside, 15
/// outside.
std::string disc_on_circle(const char* centre) {
    return std::string(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "C": )") + centre + R"(, "P": [6, 8]},
 "bodies": {"1": {"points": ["O"], "circle": {"centre": "O", "radius": 10}},
            "2": {"points": ["C", "P"], "circle": {"centre": "C", "radius": 5}}},
 "joints": [{"rolling": "P", "bodies": [2, 1]}], "drivers": [{"body": 2, "omega": 3, "alpha": 2}]})";
}

TEST(Rolling, OnACircleTheContactAcceleratesByBothRadii) {
    // ω² r₁r₂/(r₁ − r₂) inside the ring, ω² r₁r₂/(r₁ + r₂) on the outside, towards the disc's centre.
    const Solution inside = solved(disc_on_circle("[3, 4]"));
    expect_solved(inside);
    EXPECT_EQ((Reading{inside}.a("P", "2")), (Vector{-54, -72})) << "9 · 50/5 = 90";
    const Solution outside = solved(disc_on_circle("[9, 12]"));
    expect_solved(outside);
    EXPECT_EQ((Reading{outside}.a("P", "2")), (Vector{18, 24})) << "9 · 50/15 = 30";
    // The centre runs on a circle of radius r₁ ∓ r₂ with v = ω r₂.
    EXPECT_EQ((Reading{inside}.v("C", "2")), (Vector{12, -9}));
    EXPECT_EQ(dot(Reading{inside}.a("C", "2"), Vector{3, 4}), Exact(-45 * 5)) << "v²/(r₁ − r₂) = 225/5";
    EXPECT_EQ(dot(Reading{outside}.a("C", "2"), Vector{3, 4}), Exact(-15 * 5)) << "v²/(r₁ + r₂) = 225/15";
}

TEST(Rolling, ABoardOnTwoRollersGoesTwiceAsFast) {
    const std::string text = R"({"kinegraph": 1, "frame": 1,
 "points": {"A": [0, 0], "B": [7, 0], "C": [0, 1], "D": [7, 1], "E": [0, 2], "F": [7, 2], "G": [3, 3]},
 "bodies": {"2": {"points": ["C"], "circle": {"centre": "C", "radius": 1}},
            "3": {"points": ["D"], "circle": {"centre": "D", "radius": 1}}, "4": ["E", "F", "G"]},
 "joints": [{"rolling": "A", "bodies": [2, 1], "profiles": {"1": {"line": [1, 0]}}},
            {"rolling": "B", "bodies": [1, 3], "profiles": {"1": {"line": [1, 0]}}},
            {"rolling": "E", "bodies": [4, 2], "profiles": {"4": {"line": [1, 0]}}},
            {"rolling": "F", "bodies": [3, 4], "profiles": {"4": {"line": [1, 0]}}}],
 "drivers": [DRIVER]})";
    for (const char* driver : {R"({"body": 2, "omega": -2, "alpha": -1})",
                               R"({"body": 4, "at": "G", "along": [1, 0], "speed": 4, "acceleration": 2})"}) {
        const Solution solution = solved(std::string(text).replace(text.find("DRIVER"), 6, driver));
        expect_solved(solution);
        const Reading read{solution};
        EXPECT_EQ(read.v("G", "4"), (Vector{4, 0})) << driver;
        EXPECT_EQ(read.a("G", "4"), (Vector{2, 0})) << driver;
        EXPECT_EQ(read.omega("4"), Exact(0)) << driver;
        EXPECT_EQ(read.omega("3"), Exact(-2)) << driver;
        EXPECT_EQ(read.alpha("3"), Exact(-1)) << driver;
        EXPECT_EQ(read.a("D", "3"), (Vector{1, 0})) << driver;
    }
}

TEST(Rolling, WithoutProfilesOnlyVelocitiesAreKnown) {
    const Solution solution =
        solved(R"({"kinegraph": 1, "frame": 1, "points": {"C": [0, 2], "P": [0, 0]}, "bodies": {"2": ["C"]},
 "joints": [{"rolling": "P", "bodies": [2, 1], "tangent": [1, 0]}], "drivers": [{"body": 2, "omega": 1}]})");
    const Reading read{solution};
    EXPECT_EQ(read.v("C", "2"), (Vector{-2, 0}));
    EXPECT_FALSE(read.motion("C", "2").acceleration);
    ASSERT_EQ(solution.unsolved.size(), 1U);
    EXPECT_EQ(english(solution.unsolved[0].why),
              "it needs the curvatures at P; give the profiles of both bodies there");
}

// --- contacts
// ------------------------------------------------------------------------------------------------------------------

/// An eccentric disc about O with its centre C, and what follows it upwards.
std::string eccentric(const std::string& points, const std::string& bodies, const std::string& joints) {
    return R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "C": [30, 40], )" + points +
           R"(}, "bodies": {"2": {"points": ["O", "C"], "circle": {"centre": "C", "radius": 50}}, )" + bodies +
           R"(}, "joints": [{"revolute": "O", "bodies": [1, 2]}, )" + joints +
           R"(], "drivers": [{"body": 2, "omega": 5, "alpha": 2}]})";
}

TEST(Contact, FlatFollowerOfAnEccentricMovesHarmonically) {
    // s = e sin θ + r: v = e ω cos θ = 30 · 5, a = e α cos θ − e ω² sin θ = 30 · 2 − 40 · 25.
    for (const char* order : {"3, 2", "2, 3"}) {
        const Solution solution = solved(eccentric(
            R"("P": [30, 90], "G": [0, 120])", R"("3": ["G"])",
            std::string(R"({"contact": "P", "bodies": [)") + order +
                R"(], "profiles": {"3": {"line": [1, 0]}}}, {"prismatic": "G", "bodies": [3, 1], "along": [0, 1]})"));
        expect_solved(solution);
        const Reading read{solution};
        EXPECT_EQ(read.v("G", "3"), (Vector{0, 150}));
        EXPECT_EQ(read.a("G", "3"), (Vector{0, -940}));
        ASSERT_EQ(solution.equivalent_linkages.size(), 1U);
        EXPECT_EQ(solution.equivalent_linkages[0].kind, EquivalentLinkage::Kind::slot);
        EXPECT_EQ(solution.equivalent_linkages[0].bodies, (std::array{read.body("2"), read.body("3")}));
    }
}

TEST(Contact, RollerFollowerIsItsSliderCrank) {
    // A roller of radius 40 on the disc of radius 50 moves the follower as a rod CR of 90 does; a roller that turns, as
    // its own body rolling on the disc, moves it so too. A ring about C whose inside touches it is as good.
    const std::string guide = R"({"prismatic": "R", "bodies": [3, 1], "along": [0, 1]})";
    const std::string points = R"("P": {"from": "C", "to": "R", "distance": 50}, "R": [30, 130])";
    const Solution contact =
        solved(eccentric(points, R"("3": ["R"])",
                         R"({"contact": "P", "bodies": [3, 2], "profiles": {"3": {"circle": "R"}}}, )" + guide));
    const Solution roller =
        solved(eccentric(points, R"("3": ["R"], "4": {"points": ["R"], "circle": {"centre": "R", "radius": 40}})",
                         R"({"rolling": "P", "bodies": [4, 2]}, {"revolute": "R", "bodies": [3, 4]}, )" + guide));
    const Solution linkage =
        solved(eccentric(points, R"("3": ["R"], "4": ["C", "R"])",
                         R"({"revolute": "C", "bodies": [2, 4]}, {"revolute": "R", "bodies": [3, 4]}, )" + guide));
    for (const Solution* solution : {&contact, &roller, &linkage}) expect_solved(*solution);
    EXPECT_EQ((Reading{contact}.v("R", "3")), (Reading{linkage}.v("R", "3")));
    EXPECT_EQ((Reading{contact}.a("R", "3")), (Reading{linkage}.a("R", "3")));
    EXPECT_EQ((Reading{roller}.v("R", "3")), (Reading{linkage}.v("R", "3")));
    EXPECT_EQ((Reading{roller}.a("R", "3")), (Reading{linkage}.a("R", "3")));
    EXPECT_EQ(roller.mobility.gruebler, 1);
    ASSERT_EQ(contact.equivalent_linkages.size(), 1U);
    EXPECT_EQ(contact.equivalent_linkages[0].kind, EquivalentLinkage::Kind::link);
    EXPECT_TRUE(roller.equivalent_linkages.empty());
}

TEST(Contact, KnifeEdgeIsALinkFromTheCentre) {
    const std::string guide = R"({"prismatic": "P", "bodies": [3, 1], "along": [0, 1], "name": "guide"})";
    const std::string points = R"("P": [0, 80])";  // CP = (−30, 40)
    const Solution contact = solved(eccentric(
        points, R"("3": ["P"])", R"({"contact": "P", "bodies": [3, 2], "profiles": {"3": {"tip": true}}}, )" + guide));
    const Solution linkage =
        solved(eccentric(points, R"("3": ["P"], "4": ["C", "P"])",
                         R"({"revolute": "C", "bodies": [2, 4]}, {"revolute": "P", "bodies": [3, 4]}, )" + guide));
    expect_solved(contact);
    EXPECT_EQ((Reading{contact}.v("P", "3")), (Reading{linkage}.v("P", "3")));
    EXPECT_EQ((Reading{contact}.a("P", "3")), (Reading{linkage}.a("P", "3")));
    // In closed form: s = e sin θ + √(r² − e² cos² θ), with e sin θ = 40 = √(…): ds/dθ = e cos θ (1 + tan θ) = 60.
    EXPECT_EQ((Reading{contact}.v("P", "3")), (Vector{0, 300}));
}

TEST(Contact, ATipOnALineIsAPinInASlot) {
    const auto crank_and_lever = [](const std::string& joint) {
        return solved(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": [3, 4], "Q": [-9, -1]},
 "bodies": {"2": ["O", "A"], "3": ["Q"]}, "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "Q",
 "bodies": [1, 3]}, )" +
                      joint + R"(], "drivers": [{"body": 2, "omega": 7, "alpha": -5}]})");
    };
    const Solution tip = crank_and_lever(
        R"({"contact": "A", "bodies": [2, 3], "profiles": {"2": {"tip": true}, "3": {"line": [12, 5]}}})");
    const Solution slot = crank_and_lever(R"({"pin-slot": "A", "bodies": [2, 3], "along": [12, 5]})");
    expect_solved(tip);
    EXPECT_EQ((Reading{tip}.omega("3")), (Reading{slot}.omega("3")));
    EXPECT_EQ((Reading{tip}.alpha("3")), (Reading{slot}.alpha("3")));
    ASSERT_EQ(tip.sliding.size(), 1U);
    EXPECT_EQ(tip.sliding[0].velocity, slot.sliding[0].velocity);
    EXPECT_EQ(tip.sliding[0].acceleration, slot.sliding[0].acceleration);
    EXPECT_EQ(tip.sliding[0].coriolis, slot.sliding[0].coriolis);
}

TEST(Contact, SlidesAlongItsTangent) {
    // The flat of a swinging follower on the eccentric.
    const Solution solution = solved(eccentric(
        R"("P": [60, 80], "Q": [140, 20])", R"("3": ["Q"])",
        R"({"contact": "P", "bodies": [3, 2], "profiles": {"3": {"line": [4, -3]}}}, {"revolute": "Q", "bodies": [1,
        3]})"));
    expect_solved(solution);
    ASSERT_EQ(solution.sliding.size(), 1U);
    EXPECT_EQ(dot(*solution.sliding[0].velocity, Vector{3, 4}), Exact(0));
    // Seen from the disc the flat rolls and slides on a circle: along the normal its point accelerates by −(v + ω_r
    // r)²/r … the check has it; here only that the two differ by Coriolis' term as they must.
    const Reading read{solution};
    EXPECT_EQ(*solution.sliding[0].coriolis, 2 * read.omega("2") * quarter_turn(*solution.sliding[0].velocity));
}

TEST(Contact, WithoutCurvaturesAccelerationsAskForThem) {
    const Solution solution = solved(eccentric(R"("P": [60, 80], "Q": [140, 20])", R"("3": ["Q", "P"], "4": ["C"])",
                                               R"({"contact": "P", "bodies": [3, 4], "tangent": [4, -3]},
                                                  {"weld": "C", "bodies": [2, 4]}, {"revolute": "Q", "bodies": [1,
                                                  3]})"));
    EXPECT_TRUE((Reading{solution}.motion("P", "3").velocity));
    ASSERT_FALSE(solution.unsolved.empty());
    EXPECT_EQ(english(solution.unsolved[0].what), "acceleration of body 3");
    EXPECT_EQ(english(solution.unsolved[0].why),
              "it needs the curvatures at P; give the profiles of both bodies there");
}

// --- gears
// ---------------------------------------------------------------------------------------------------------------------

/// Sun 2 (r = 3), planet 3 (r = 2) and ring (r = 7) with the arm 4; the ring is body 5 or the frame.
std::string planetary(const std::string& pair, bool ring_turns, const std::string& drivers) {
    const std::string ring = ring_turns ? "5" : "1";
    const std::string arm = pair == "gear" ? R"(, "arm": 4)" : "";
    return R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "C": [3, 4], "P": [1.8, 2.4], "Q": [4.2, 5.6],
    "X": [3, 2]},
 "bodies": {"2": {"points": ["O"], "circle": {"centre": "O", "radius": 3}},
            "3": {"points": ["C", "X"], "circle": {"centre": "C", "radius": 2}}, "4": ["O", "C"],
            ")" +
           ring + R"(": {"points": ["O"], "circle": {"centre": "O", "radius": 7}}},
 "joints": [{"revolute": "O", "bodies": [1, 2, 4)" +
           (ring_turns ? ", 5" : "") + R"(]}, {"revolute": "C", "bodies": [3, 4]},
  {")" + pair +
           R"(": "P", "bodies": [2, 3])" + arm + R"(}, {")" + pair + R"(": "Q", "bodies": [3, )" + ring + "]" + arm +
           R"(}], "drivers": [)" + drivers + "]}";
}

TEST(Gears, PlanetaryTrainObeysWillis) {
    for (const auto& [turns, drivers] :
         {std::pair(false, R"({"body": 2, "omega": 10, "alpha": 2})"),
          {false, R"({"body": 4, "omega": 3, "alpha": 5})"},
          {false, R"({"body": 3, "omega": -4, "alpha": 1})"},
          {true, R"({"body": 2, "omega": 10}, {"body": 5, "omega": -1, "alpha": 3})"},
          {true, R"({"body": 2, "omega": 10}, {"body": 4, "omega": 7, "alpha": 3})"},
          {true, R"({"body": 4, "omega": 2}, {"body": 2, "relative to": 4, "omega": 5, "alpha": 1})"},
          {true, R"({"body": 4, "omega": 2}, {"body": 3, "relative to": 4, "omega": 5})"}}) {
        const Solution solution = solved(planetary("gear", turns, drivers));
        expect_solved(solution);
        const Reading read{solution};
        const auto willis = [&, turns = turns, drivers = drivers](auto quantity, const Exact& arm) {
            const Exact ring = turns ? quantity("5") : Exact(0);
            EXPECT_EQ(3 * (quantity("2") - arm), -7 * (ring - arm)) << drivers;
            EXPECT_EQ(3 * (quantity("2") - arm), -2 * (quantity("3") - arm)) << drivers;
        };
        willis([&](const char* body) { return read.omega(body); }, read.omega("4"));
        willis([&](const char* body) { return read.alpha(body); }, read.alpha("4"));
    }
}

TEST(Gears, PitchCirclesMoveAsWheelsThatRoll) {
    const std::string sun = R"({"body": 2, "omega": 10, "alpha": 2})";
    const Solution gears = solved(planetary("gear", false, sun)), wheels = solved(planetary("rolling", false, sun));
    EXPECT_EQ((Reading{gears}.a("X", "3")), (Reading{wheels}.a("X", "3")));
    EXPECT_EQ((Reading{gears}.v("X", "3")), (Reading{wheels}.v("X", "3")));
    EXPECT_EQ((Reading{gears}.alpha("4")), (Reading{wheels}.alpha("4")));
    EXPECT_LE(worst_difference(wheels), 1e-9);
}

TEST(Gears, RackGoesWithThePinionsRim) {
    const auto train = [](const std::string& driver) {
        return solved(
            R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"}, "points": {"O": [0, 0], "P": [0, -30],
            "G": [40, -40]},
 "bodies": {"2": {"points": ["O"], "circle": {"centre": "O", "radius": 30}}, "3": ["G"]},
 "joints": [{"revolute": "O", "bodies": [1, 2]}, {"gear": "P", "bodies": [2, 3], "profiles": {"3": {"line": [1, 0]}}},
            {"prismatic": "G", "bodies": [3, 1], "along": [1, 0]}], "drivers": [)" +
            driver + "]}");
    };
    const Solution pinion = train(R"({"body": 2, "omega": 4, "alpha": -3})");
    expect_solved(pinion);
    EXPECT_EQ((Reading{pinion}.v("G", "3")), (Vector{Exact::ratio(3, 25), 0}));
    EXPECT_EQ((Reading{pinion}.a("G", "3")), (Vector{Exact::ratio(-9, 100), 0}));
    const Solution rack = train(R"({"joint": "G", "speed": 0.12, "acceleration": -0.09})");
    expect_solved(rack);
    EXPECT_EQ((Reading{rack}.omega("2")), Exact(4));
    EXPECT_EQ((Reading{rack}.alpha("2")), Exact(-3));
}

// --- laws
// ---------------------------------------------------------------------------------------------------------------------

TEST(HigherPairs, ThreeCentresOfThreeBodiesLieOnALine) {
    const std::string cam = eccentric(
        R"("P": [60, 80], "Q": [140, 20])", R"("3": ["Q"])",
        R"({"contact": "P", "bodies": [3, 2], "profiles": {"3": {"line": [4, -3]}}}, {"revolute": "Q", "bodies": [1,
        3]})");
    for (const std::string& text : {cam, planetary("gear", false, R"({"body": 2, "omega": 10})")}) {
        const Solution solution = solved(text);
        const Mechanism& mechanism = solution.mechanism;
        ASSERT_GE(mechanism.bodies.size(), 3U);
        const auto centre = [&](BodyIndex i, BodyIndex j) -> const ProjectivePoint& {
            for (const InstantCentre& c : solution.centres)
                if (c.first == i && c.second == j) return c.at.value();
            throw std::out_of_range("centre");
        };
        for (const BodyIndex i : indices_of(mechanism.bodies)) {
            for (const BodyIndex j : mechanism.bodies_after(i)) {
                for (const BodyIndex k : mechanism.bodies_after(j)) {
                    const auto &a = centre(i, j), &b = centre(j, k), &c = centre(i, k);
                    const Exact determinant =
                        a.x * (b.y * c.w - c.y * b.w) - a.y * (b.x * c.w - c.x * b.w) + a.w * (b.x * c.y - c.x * b.y);
                    EXPECT_EQ(determinant, Exact(0)) << i.number() << j.number() << k.number();
                }
            }
        }
    }
}

// --- forces
// --------------------------------------------------------------------------------------------------------------------

TEST(HigherPairs, InertiaOfARackActsOnItsPinion) {
    // M = (J + m r²) ω̇ with J = 0.01, m = 5, r = 0.04; gravity is square to the rack.
    const Solution solution =
        solved(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "P": [0, -0.04], "G": [0.07, -0.055]},
 "bodies": {"2": {"points": ["O"], "circle": {"centre": "O", "radius": 0.04}}, "3": ["G"]},
 "joints": [{"revolute": "O", "bodies": [1, 2]}, {"gear": "P", "bodies": [2, 3], "profiles": {"3": {"line": [1,
 0]}}, "pressure angle": 20},
            {"prismatic": "G", "bodies": [3, 1], "along": 0}],
 "drivers": [{"body": 2, "omega": 6, "alpha": -10}], "gravity": [0, -9.81], "inertia forces": true,
 "masses": {"2": {"mass": 4, "centre": "O", "inertia": 0.01}, "3": {"mass": 5, "centre": "G", "inertia": 0}},
 "effort": [{"couple": "M", "body": 2}]})");
    expect_solved(solution);
    ASSERT_EQ(solution.efforts.size(), 1U);
    EXPECT_NEAR(solution.efforts[0].value->to_double(), -0.18, 1e-15);
}

TEST(HigherPairs, AFollowerTooFastLiftsOff) {
    // The flat follower weighs m g and is slowed by m e ω² sin θ: it stays on the cam while ω² < g/(e sin θ) = 981/4.
    const auto follower = [](int omega) {
        return solved(
            R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "C": [0.03, 0.04], "P": [0.03, 0.09], "G": [0,
            0.12]},
 "bodies": {"2": {"points": ["O", "C"], "circle": {"centre": "C", "radius": 0.05}}, "3": ["G"]},
 "joints": [{"revolute": "O", "bodies": [1, 2]}, {"prismatic": "G", "bodies": [3, 1], "along": [0, 1]},
            {"contact": "P", "bodies": [3, 2], "profiles": {"3": {"line": [1, 0]}}, "pushes": [0, 1]}],
 "drivers": [{"body": 2, "omega": )" +
            std::to_string(omega) +
            R"(}], "gravity": [0, -9.81], "inertia forces": true,
 "masses": {"3": {"mass": 2, "centre": "G", "inertia": 0}}, "effort": [{"couple": "M", "body": 2}]})");
    };
    const Solution slow = follower(15), fast = follower(16);
    expect_solved(slow);
    expect_solved(fast);
    EXPECT_TRUE(slow.remarks.empty());
    ASSERT_EQ(fast.remarks.size(), 1U);
    EXPECT_EQ(english(fast.remarks[0]), "The contact at P would have to pull: there the bodies lift off.");
}

// --- random mechanisms
// ---------------------------------------------------------------------------------------------------------

/// Two to four moving bodies on an open chain of hinges and sleeves, closed by random contacts, rollings and slots
/// until one freedom is left; a random body drives. Directions are those of Pythagorean triangles, places decimals: all
/// is exact.
class RandomHigherPairs {
public:
    explicit RandomHigherPairs(std::uint64_t seed) : random_(seed), bodies_(random_.whole(2, 4)) {}

    std::string text() {
        for (int body = 1; body <= bodies_; ++body) {
            const int parent = random_.whole(0, body - 1);
            joined_[static_cast<std::size_t>(body)] = parent;
            const std::string between = ", \"bodies\": [" + std::to_string(body) + ", " + std::to_string(parent) + "]";
            if (random_.chance(80)) {
                add_joint("\"revolute\": " + place() + between);
            } else {
                add_joint("\"prismatic\": " + place() + between + ", \"along\": " + bearing(direction()));
            }
        }
        for (int freedoms = bodies_; freedoms > 1;) freedoms -= close(freedoms);
        std::string text = R"({"kinegraph": 1, "frame": 0, "points": {)" + points_ + "}, \"bodies\": {";
        for (int body = 1; body <= bodies_; ++body)
            text += (body > 1 ? ", \"" : "\"") + std::to_string(body) + "\": [\"T" + std::to_string(body) + "\"]";
        return text + "}, \"joints\": [" + joints_ +
               "], \"drivers\": [{\"body\": " + std::to_string(random_.whole(1, bodies_)) +
               ", \"omega\": " + std::to_string(random_.whole(1, 9)) +
               ", \"alpha\": " + std::to_string(random_.whole(-9, 9)) + "}]}";
    }

private:
    struct Whole {
        int x, y;
    };
    static std::string bearing(Whole a) { return "[" + std::to_string(a.x) + ", " + std::to_string(a.y) + "]"; }
    Whole direction() {
        static constexpr std::array<Whole, 5> triangles{{{1, 0}, {3, 4}, {5, 12}, {15, 8}, {21, 20}}};
        Whole d = triangles[static_cast<std::size_t>(random_.whole(0, 4))];
        if (random_.chance(50)) std::swap(d.x, d.y);
        if (random_.chance(50)) d.x = -d.x;
        return d;
    }
    std::string add_point(Whole at) {
        const std::string name = "A" + std::to_string(count_++);
        points_ += (points_.empty() ? "\"" : ", \"") + name + "\": " + bearing(at);
        return '"' + name + '"';
    }
    Whole anywhere() { return {random_.whole(-600, 600), random_.whole(-600, 600)}; }
    std::string place() { return add_point(anywhere()); }
    void add_joint(const std::string& joint) { joints_ += (joints_.empty() ? "{" : ", {") + joint + "}"; }

    /// A profile through the contact with this normal; `kind` 0: round, 1: straight, 2: a tip.
    std::string profile(int kind, Whole at, Whole normal) {
        if (kind == 1) return "{\"line\": " + bearing({-normal.y, normal.x}) + "}";
        if (kind == 2) return "{\"tip\": true}";
        // Two circles with one centre leave the accelerations open.
        int reach = 0;
        do {
            reach = random_.whole(1, 12) * (random_.chance(50) ? 1 : -1);
        } while (reach == last_reach_);
        last_reach_ = reach;
        return "{\"circle\": " + add_point({at.x + reach * normal.x, at.y + reach * normal.y}) + "}";
    }

    /// Adds a pair and returns how many freedoms it takes.
    int close(int freedoms) {
        int first = 0, second = 0;
        do {
            first = random_.whole(0, bodies_);
            second = random_.whole(0, bodies_);
        } while (first == second || joined_[static_cast<std::size_t>(first)] == second ||
                 joined_[static_cast<std::size_t>(second)] == first);
        const std::string between = ", \"bodies\": [" + std::to_string(first) + ", " + std::to_string(second) + "]";
        const Whole at = anywhere(), normal = direction();
        const std::string point = add_point(at);
        const int which = random_.whole(0, 9);
        if (which == 0) {
            add_joint("\"pin-slot\": " + point + between + ", \"along\": " + bearing(normal));
            return 1;
        }
        const bool rolls = freedoms > 2 && which < 4;
        static constexpr std::array<std::array<int, 2>, 8> kinds{
            {{0, 0}, {0, 1}, {1, 0}, {0, 0}, {2, 0}, {0, 2}, {1, 2}, {2, 1}}};
        const auto& [one, two] = kinds[static_cast<std::size_t>(random_.whole(0, rolls ? 3 : 7))];
        const std::string profiles = ", \"profiles\": {\"" + std::to_string(first) + "\": " + profile(one, at, normal) +
                                     ", \"" + std::to_string(second) + "\": " + profile(two, at, normal) + "}";
        add_joint((rolls ? "\"rolling\": " : "\"contact\": ") + point + between + profiles);
        return rolls ? 2 : 1;
    }

    Random random_;
    int bodies_, count_ = 0, last_reach_ = 0;
    std::array<int, 5> joined_{-1, -1, -1, -1, -1};  ///< by body: to which its own hinge or sleeve ties it
    std::string points_ = R"("T1": [11, 7], "T2": [-70, 31], "T3": [53, -90], "T4": [-27, -64])", joints_;
};

TEST(HigherPairs, RandomMechanismsAgreeWithTheCheck) {
    int movable = 0;
    for (std::uint64_t seed = 0; seed < 250; ++seed) {
        const std::string text = RandomHigherPairs(seed).text();
        const Solution solution = solved(text);
        // What the contacts lock, and drivers of a body that cannot move, are no motion to draw.
        if (solution.mobility.effective != 1 || !solution.mobility.idle_drivers.empty()) continue;
        ++movable;
        for (const Unsolved& missing : solution.unsolved)
            ADD_FAILURE() << "seed " << seed << ": " << english_of(missing) << "\n" << text;
        EXPECT_LE(worst_difference(solution), 1e-9) << "seed " << seed << ": " << text;
    }
    EXPECT_GE(movable, 125);
}

/// A spool rolls on its rim, and its thread leaves from the inner circle: the profile at the joint counts, not the
/// circle of the body.
TEST(Rolling, ABodyTouchesWithTheCircleOfItsJoint) {
    const std::string spool = R"({"kinegraph": 1, "frame": 1, "points": {"C": [0, 0.3], "P": [0, 0], "Q": [0, 0.2],
        "T": [1, 0.2]}, "bodies": {"2": {"points": ["C"], "circle": {"centre": "C", "radius": 0.3}}, "3": ["Q", "T"]},
        "joints": [{"rolling": "P", "bodies": [2, 1], "profiles": {"1": {"line": 0}}},
        {"rolling": "Q", "bodies": [3, 2], "profiles": {"3": {"line": 0}, "2": {"circle": "C"}}},
        {"prismatic": "T", "bodies": [3, 1], "along": 0}], "drivers": [{"joint": "T", "speed": 1.2}]})";
    const Solution solution = solved(spool);
    expect_solved(solution);
    EXPECT_EQ((Reading{solution}.omega("2")), -6);  // the thread moves by 0.2 m per radian
    // Without a profile the body's own circle counts, and the message says what to give.
    std::string bare = spool;
    bare.replace(bare.find(R"(, "2": {"circle": "C"})"), std::string(R"(, "2": {"circle": "C"})").size(), "");
    const auto mechanism = read_mechanism(bare, "spool.json");
    ASSERT_TRUE(mechanism);
    const auto pose = draw_pose(*mechanism);
    ASSERT_FALSE(pose);
    EXPECT_EQ(pose.error().front().message.in(Language::en),
              "Q lies 0.1 m from C, but the circle of body 2 has radius 0.3 m: 0.2 m off; if body 2 touches there with "
              "another circle, give that under the joint’s \"profiles\"");
}

}  // namespace
}  // namespace kinegraph::higher_pairs_test
