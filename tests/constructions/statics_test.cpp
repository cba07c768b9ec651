// What statics adds to forces: loads on pins, distributed loads, elastic and torsion springs, units of the trade, and
// whether what is given on a body is in equilibrium. Closed forms, exactly where they are rational; random mechanisms
// under all kinds of load.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "constructions/positions/cycle.hpp"
#include "engine/check/check.hpp"
#include "engine/check/check_forces.hpp"
#include "engine/file/units.hpp"
#include "engine/motion/repositioned.hpp"
#include "engine/results/results.hpp"
#include "lang/keys/sentences.hpp"
#include "render/tables/force_tables.hpp"
#include "tests/support/force_laws.hpp"
#include "tests/support/near_the_check.hpp"
#include "tests/support/random_loads.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::statics_test {
namespace {

using tests::example;
using tests::solved;

const JointForce& action(const Solution& solution, const std::string& joint, const std::string& on) {
    for (const JointForce& each : solution.forces)
        if (solution.mechanism.joint(each.joint).name == joint && solution.mechanism.body(each.on).name == on)
            return each;
    throw std::out_of_range("no action at " + joint + " on " + on);
}
Exact fraction(int above, int below) { return Exact::ratio(above, below); }

// --- closed forms
// ------------------------------------------------------------------------------------------------------------

TEST(DistributedLoads, TheCantileversClampHoldsForceAndCouple) {
    // q l + P = 225 · 2 + 800 N, q l²/2 + P l = 450 + 1600 N m.
    const Solution& solution = example("cantilever");
    EXPECT_EQ(*action(solution, "A", "2").force, (Vector{0, 1250}));
    EXPECT_EQ(*action(solution, "A", "2").couple, Exact(2050));
}

TEST(SupportsWithCouples, AreToldAsForceAndCoupleAndAsOneForceAside) {
    // M = 2050 N m beside 1250 N: one force at d = M/F = 1.64 m.
    const Solution& solution = example("cantilever");
    const FreeBody& beam = solution.free_bodies.at(0);
    int found = 0;
    for (const AppliedForce& applied : beam.forces) {
        const JointForce* pair = render::at_the_pair(solution, beam, applied);
        EXPECT_EQ(pair != nullptr, applied.is_reaction());
        if (pair == nullptr) continue;
        ++found;
        EXPECT_EQ(*pair->couple, Exact(2050));
        EXPECT_EQ(applied.at, (Vector{fraction(41, 25), 0}));
    }
    EXPECT_EQ(found, 1);
    // A hinge holds none.
    const Solution& beams = example("gerber_beam");
    for (const FreeBody& body : beams.free_bodies)
        for (const AppliedForce& applied : body.forces) EXPECT_EQ(render::at_the_pair(beams, body, applied), nullptr);
}

TEST(DistributedLoads, AGerberBeamIsSolvedFromItsSuspendedPart) {
    // The triangle of 9 kN two thirds from G: C = 6, G = 3 kN; then B · 4 = 10 · 2.5 + 3 · 5 and A = 10 + 3 − B.
    const Solution& solution = example("gerber_beam");
    EXPECT_EQ(*action(solution, "C", "3").force, (Vector{0, 6000}));
    EXPECT_EQ(*action(solution, "G", "3").force, (Vector{0, 3000}));
    EXPECT_EQ(*action(solution, "B", "2").force, (Vector{0, 10000}));
    EXPECT_EQ(*action(solution, "A", "2").force, (Vector{0, 3000}));
}

TEST(DistributedLoads, OfEqualAndOppositeEndsAreACouple) {
    // From −q to q on a length l: M = q l²/6 about any point, upwards at the far end.
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [3, 0]},
        "bodies": {"2": ["A", "B"]}, "joints": [{"weld": "A", "bodies": [1, 2]}],
        "loads": [{"distributed": "q", "body": 2, "from": "A", "to": "B", "intensity": [-40, 40], "along": 90}]})");
    EXPECT_EQ(*action(solution, "A", "2").couple, Exact(-60));
    EXPECT_TRUE(action(solution, "A", "2").force->is_zero());
    EXPECT_LT(tests::worst_difference(solution), 1e-9);
}

TEST(PinLoads, ThePinIsANodeOfItsOwn) {
    // Wind (1800, −2400) N on the middle of the left half, 2 kN on the crown's pin. Moments about A: 8 B_y = 4 · 2000 +
    // 2 · 2400
    // + 1.5 · 1800; body 3 carries two forces, so B runs along BC.
    const Solution& solution = example("three_hinged_arch");
    const Vector b = *action(solution, "B", "3").force, a = *action(solution, "A", "2").force;
    EXPECT_EQ(b, (Vector{fraction(-7750, 3), fraction(3875, 2)}));
    EXPECT_EQ(a, (Vector{fraction(2350, 3), fraction(4925, 2)}));
    // The pin on both: with its load nothing is left.
    const JointForce &on_2 = action(solution, "C", "2"), &on_3 = action(solution, "C", "3");
    EXPECT_EQ(on_2.from, none);
    EXPECT_EQ(*on_2.force + *on_3.force, (Vector{0, -2000}));
    EXPECT_EQ(*on_3.force, -b);
}

TEST(PinLoads, MoveWithTheirPin) {
    // A load on the pin A of a crank is the same for the effort as on the crank, and loses no power.
    const auto lever = [](const std::string& where) {
        return solved(
            R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": [3, 4], "C": [9, 0]},
            "bodies": {"2": ["O", "A"], "3": ["A", "C"], "4": ["C"]},
            "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
                       {"revolute": "C", "bodies": [3, 4]}, {"prismatic": "C", "bodies": [4, 1], "along": 0}],
            "drivers": [{"body": 2, "omega": 2}], "loads": [{"force": "F", )" +
            where + R"(, "value": [70, -30]}], "effort": {"couple": "M", "body": 2}, "find": ["velocity", "forces"]})");
    };
    const Solution on_pin = lever(R"("pin": "A")"), on_crank = lever(R"("body": 2, "at": "A")");
    EXPECT_EQ(*on_pin.efforts[0].value, *on_crank.efforts[0].value);
    ASSERT_TRUE(on_pin.virtual_work && on_crank.virtual_work);
    EXPECT_TRUE(on_pin.virtual_work->total.is_zero());
    EXPECT_EQ(on_pin.virtual_work->entries.size(), on_crank.virtual_work->entries.size());
}

TEST(Springs, AGasSpringPushes) {
    // 15 · 9.81 · 0.4 − 400 (0.8 · 0.32 − 0.6 · 0.24) = 0.8 F.
    EXPECT_EQ(*example("car_bonnet").efforts[0].value, fraction(17575, 1000));
}

TEST(Springs, ElasticOnesPullByTheirStretchAlsoWhereTheyMove) {
    constexpr double right = std::numbers::pi / 2;
    const auto closed = [](double turn) {
        // The lever of 0.5 m turned on from (0.3, 0.4); S in (0.3, 0).
        const double x = 0.5 * std::cos(std::atan2(0.4, 0.3) + turn), y = 0.5 * std::sin(std::atan2(0.4, 0.3) + turn);
        const double length = std::hypot(x - 0.3, y), pull = 1000 * (length - 0.25);
        return -(x * -y - y * (0.3 - x)) * pull / length + 12 * (right + turn);
    };
    const Solution& drawn = example("lever_on_springs");
    EXPECT_NEAR(drawn.efforts[0].value->to_double(), 45 + 6 * std::numbers::pi, 1e-9);
    EXPECT_NEAR(closed(0), 45 + 6 * std::numbers::pi, 1e-9);
    ASSERT_TRUE(drawn.virtual_work);
    EXPECT_TRUE(drawn.virtual_work->total.is_zero());

    const Mechanism& mechanism = drawn.mechanism;
    auto cycle = Cycle::of(mechanism, drawn.pose, 0);
    ASSERT_TRUE(cycle);
    ASSERT_TRUE(cycle->begin(*travel_of(cycle->positions(), true, {}, {}), true).empty());
    for (const double turn : {-2.1, -0.4, 0.9, 3.0, 7.5}) {
        const auto row = cycle->row(turn);
        ASSERT_TRUE(row);
        for (std::size_t i = 0; i < row->size(); ++i)
            if (cycle->columns()[i].name == "effort M_2") {
                EXPECT_NEAR((*row)[i], closed(turn), 1e-9) << turn;
            }
        Positions positions = cycle->positions();
        ASSERT_TRUE(positions.move_to(turn));
        Repositioned moved = *Mover(mechanism, drawn.pose).moved(positions, Exact::from_double(turn));
        const Solution there = solve(std::move(moved.mechanism), std::move(moved.pose),
                                     [finer = std::move(moved.finer)] { return finer; });
        EXPECT_NEAR(there.efforts[0].value->to_double(), closed(turn), 1e-9) << turn;
    }
    EXPECT_LT(cycle->difference().share, 1e-9);
}

// --- units
// -------------------------------------------------------------------------------------------------------------------

TEST(UnitsOfTheTrade, AreExact) {
    const auto si = [](const char* text, QuantityKind kind) { return read_quantity(text, kind).value().in_si(); };
    const Exact pound_force = *Exact::from_decimal("4.4482216152605"), inch = *Exact::from_decimal("0.0254");
    const Exact foot = 12 * inch;
    EXPECT_EQ(si("3 kgf", QuantityKind::force), 3 * *Exact::from_decimal("9.80665"));
    EXPECT_EQ(si("2 lb s^2/in", QuantityKind::mass), 2 * pound_force / inch);
    EXPECT_EQ(si("2 lb in s^2", QuantityKind::inertia), 2 * pound_force * inch);
    EXPECT_EQ(si("1 slug ft^2", QuantityKind::inertia), si("1 slug", QuantityKind::mass) * foot * foot);
    EXPECT_EQ(si("1 N/mm", QuantityKind::force_per_length), Exact(1000));
    EXPECT_EQ(si("180 N m/deg", QuantityKind::torsional_stiffness) * pi() / 180, Exact(180));
}

TEST(UnitsOfTheTrade, APressureOnAnAreaIsAForce) {
    const auto force = [](const std::string& how) {
        const Solution solution =
            solved(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0]}, "bodies": {"2": ["A"]},
            "joints": [{"weld": "A", "bodies": [1, 2]}], "parameters": {"m": "2 kg"},
            "loads": [{"force": "F", "body": 2, "at": "A", )" +
                   how + R"(, "along": 0}]})");
        return action(solution, "A", "2").force->x;
    };
    EXPECT_EQ(force(R"("pressure": "5 bar", "area": "12 cm²")"), Exact(-600));
    EXPECT_EQ(force(R"("magnitude": "= 5 bar * 12 cm²")"), Exact(-600));
    // As they were read before there were areas and forces per length.
    EXPECT_EQ(force(R"("magnitude": "= 5 bar * 2 cm^2")"), Exact(-200));
    EXPECT_EQ(force(R"("magnitude": "= 10 N/m * 2 kg")"), Exact(-10));
}

// --- is it in equilibrium?
// ---------------------------------------------------------------------------------------------------

std::string plate(const std::string& loads, const std::string& more = "") {
    return R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [3, 0], "C": [3, 4]}, "bodies": {"2": ["A",
    "B", "C"])" +
           more + R"(}, "joints": [], "loads": [)" + loads + "]}";
}
std::string resultant_of(const Solution& solution) {
    const auto json = nlohmann::json::parse(results_json(solution, false, [](const Message& m) { return english(m); }));
    return json.contains("resultant") ? json["resultant"].dump() : "none";
}

/// Loads that cancel leave a body two forces, and the sentence says so: no load is passed over in silence.
TEST(Equilibrium, LoadsThatCancelAreNamedBesideTheTwoForces) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 0,
        "points": {"A": [0, 0], "B": [10, 2], "C": [5, 5], "D": [2, 5], "F": [2, 2]},
        "bodies": {"1": ["A", "F", "D", "C"], "2": ["C", "B"]},
        "joints": [{"revolute": "A", "bodies": [0, 1]}, {"revolute": "C", "bodies": [1, 2]},
                   {"revolute": "B", "bodies": [0, 2]}],
        "loads": [{"force": "P", "body": 1, "at": "D", "value": [0, -7]},
                  {"force": "S", "body": 1, "at": "F", "value": [0, 7]},
                  {"force": "U", "body": 2, "at": "C", "value": [3, -20]}]})");
    EXPECT_EQ(english(solution.protocol.statements[0].message),
              "Body 1 carries, besides F_P, F_S, which are in equilibrium, two forces only, so both act along AC.");
    expect_determined_forces_only(
        solution, check_forces(solution.mechanism, solution.pose, check_motion(solution.mechanism, solution.pose)));
}

/// A rope between two bodies acts on the two taken together where the loads of one of them act alone.
TEST(Equilibrium, OfLoadsThatActAloneTheRopesOtherEndDoesNot) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 0,
        "points": {"A": [0, 0], "B": [10, 2], "C": [5, 5], "D": [2, 5], "E": [8, 5], "G": [8, 3]},
        "bodies": {"1": ["A", "D", "C"], "2": ["C", "E", "B", "G"]},
        "joints": [{"revolute": "A", "bodies": [0, 1]}, {"revolute": "C", "bodies": [1, 2]},
                   {"revolute": "B", "bodies": [0, 2]}],
        "loads": [{"force": "S", "bodies": [1, 2], "between": ["D", "E"], "magnitude": 5},
                  {"force": "P", "body": 1, "at": "D", "value": [3, -1]},
                  {"force": "Q", "body": 2, "at": "G", "value": [0, -9]}]})");
    ASSERT_TRUE(solution.superposition);
    expect_determined_forces_only(
        solution, check_forces(solution.mechanism, solution.pose, check_motion(solution.mechanism, solution.pose)));
}

/// The centre of a mass belongs to its body, listed there or not: its inertia force is the same.
TEST(InertiaForces, OfACentreThatTheBodyDoesNotListAreTheSame) {
    const auto crank = [](const char* listed) {
        return solved(std::string(R"({"kinegraph": 1, "frame": 1,
            "points": {"O": [0, 0], "A": [3, 4], "G": [1, 3]}, "bodies": {"2": ["O", "A")") +
                      listed + R"(]},
            "joints": [{"revolute": "O", "bodies": [1, 2]}], "drivers": [{"body": 2, "omega": 2, "alpha": 3}],
            "masses": {"2": {"mass": 5, "centre": "G", "inertia": 7}}, "inertia forces": true,
            "effort": {"couple": "M", "body": 2}})");
    };
    const Solution listed = crank(R"(, "G")"), unlisted = crank("");
    EXPECT_TRUE(unlisted.unsolved.empty());
    ASSERT_TRUE(unlisted.efforts.front().value);
    EXPECT_EQ(*unlisted.efforts.front().value, *listed.efforts.front().value);
    EXPECT_EQ(*unlisted.efforts.front().value, Exact(3 * (7 + 5 * 10)));  // α (J + m OG²)
}

TEST(Equilibrium, WhatIsLeftOverIsAForceAlongALine) {
    const Solution& solution = example("plate_under_forces");
    ASSERT_EQ(solution.resultants.size(), 1U);
    const Resultant& found = solution.resultants[0];
    EXPECT_EQ(*found.force, (Vector{300, 400}));
    EXPECT_EQ(*found.couple, Exact(140));  // 0.6 · 400 − 100
    EXPECT_EQ(*found.through, (Vector{fraction(28, 125), fraction(-21, 125)}));
    EXPECT_FALSE(found.vanishes);
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_EQ(resultant_of(solution), R"({"2":{"couple":140,"force":[300,400],"through":[0.224,-0.168]}})");
    // The gap of the polygon is the resultant, from its beginning to its end.
    const auto& sides = solution.protocol.polygons.at(static_cast<std::size_t>(found.polygon)).vectors;
    ASSERT_EQ(sides.size(), 3U);
    EXPECT_EQ(solution.protocol.value_of(solution.protocol.vectors[static_cast<std::size_t>(sides[2])]),
              (Vector{300, 400}));
}

TEST(Equilibrium, TwoForcesTwoAndACoupleThree) {
    const auto left = [](const std::string& loads) { return resultant_of(solved(plate(loads))); };
    const std::string nothing = R"({"2":{"couple":0,"force":[0,0],"through":null}})";
    const auto force = [](const char* name, const char* at, const char* value) {
        return std::string(R"({"force": ")") + name + R"(", "body": 2, "at": ")" + at + R"(", "value": )" + value + "}";
    };
    const std::string up = force("P", "B", "[0, 10]"), pair = up + ", " + force("Q", "A", "[0, -10]");
    EXPECT_EQ(left(up + ", " + force("Q", "C", "[0, -10]")), nothing);
    EXPECT_EQ(left(pair), R"({"2":{"couple":30,"force":[0,0],"through":null}})");
    EXPECT_EQ(left(pair + R"(, {"couple": "M", "body": 2, "value": -30})"), nothing);
    EXPECT_EQ(left(force("P", "A", "[3, 4]") + ", " + force("Q", "B", "[-3, 0]") + ", " + force("R", "C", "[0, -4]")),
              R"({"2":{"couple":-12,"force":[0,0],"through":null}})");
    const Solution balanced = solved(plate(up + ", " + force("Q", "C", "[0, -10]")));
    EXPECT_TRUE(balanced.unsolved.empty());
    ASSERT_EQ(balanced.free_bodies.size(), 1U);
    EXPECT_GE(balanced.free_bodies[0].polygon, 0);
}

TEST(Equilibrium, BodiesThatHangTogetherAreTakenTogether) {
    // Two plates pinned in B: the pin's force is no one's load. Out of equilibrium it is not told.
    const std::string text = R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [3, 0], "C": [6, 0]},
        "bodies": {"2": ["A", "B"], "3": ["B", "C"]}, "joints": [{"revolute": "B", "bodies": [2, 3]}],
        "loads": [{"force": "P", "body": 2, "at": "A", "value": [-5, 0]}, {"force": "Q", "body": 3, "at": "C",
        "value": [X, 0]}]})";
    const auto with = [&](const std::string& x) {
        std::string changed = text;
        return solved(changed.replace(changed.find('X'), 1, x));
    };
    const Solution still = with("5"), left = with("7");
    EXPECT_EQ(resultant_of(still), R"({"2,3":{"couple":0,"force":[0,0],"through":null}})");
    EXPECT_TRUE(still.unsolved.empty());
    EXPECT_EQ(*action(still, "B", "3").force, (Vector{-5, 0}));
    EXPECT_EQ(resultant_of(left), R"({"2,3":{"couple":0,"force":[2,0],"through":[0,0]}})");
    EXPECT_TRUE(left.unsolved.empty());
    for (const JointForce& each : left.forces) EXPECT_FALSE(each.force);
    ASSERT_EQ(left.protocol.statements.size(), 1U);
    EXPECT_EQ(left.protocol.statements[0].message.sentence, lang::sentences::resultant_force);
}

TEST(Equilibrium, OfAMechanismThatIsDrivenOrHeldNothingIsAsked) {
    EXPECT_EQ(resultant_of(example("beam")), "none");
    EXPECT_EQ(resultant_of(example("exam_2001")), "none");
}

TEST(Equilibrium, LoadsAtRestAskForForcesAlone) {
    const Solution solution =
        solved(plate(R"({"force": "P", "body": 2, "at": "A", "value": [1, 0]})", R"(, "3": ["C"])"));
    EXPECT_TRUE(solution.centres.empty());
    EXPECT_TRUE(solution.unsolved.empty());
}

// --- at random
// ---------------------------------------------------------------------------------------------------------------

/// True where equilibrium determines all; then everything has been held.
bool hold(std::uint64_t seed) {
    const RandomMechanism random = random_mechanism(seed);
    if (random.bodies > 8) return false;
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + random.recipe);
    const auto bare = read_mechanism(random.text, "bare");
    if (!bare) return ADD_FAILURE() << bare.error().front().message.in(Language::en), false;
    const auto pose = draw_pose(*bare);
    if (!pose) return ADD_FAILURE() << pose.error().front().message.in(Language::en), false;
    std::string text = under_random_loads(random.text, *bare, *pose, seed, random.freedoms, true);
    text.insert(text.rfind("\n}"), ",\n  \"find\": [\"velocity\", \"acceleration\", \"forces\"]");
    if (std::getenv("KINEGRAPH_SEED") != nullptr) std::fputs(text.c_str(), stderr);
    const Solution solution = solved(text);
    const NumericForces numeric =
        check_forces(solution.mechanism, solution.pose, check_motion(solution.mechanism, solution.pose));
    if (!wholly_known(numeric)) {
        EXPECT_FALSE(solution.unsolved.empty());
        expect_determined_forces_only(solution, numeric);
        return false;
    }
    for (const Unsolved& unsolved : solution.unsolved) ADD_FAILURE() << english_of(unsolved);
    if (solution.unsolved.empty()) expect_laws_of_forces(solution, numeric);
    return true;
}

TEST(RandomStatics, AllKindsOfLoadObeyTheLaws) {
    EXPECT_TRUE(hold_quarter(0, unless_sanitized(240, 40), hold, testing::Test::HasFailure)) << "too few draws counted";
}

/// The check measures every body from one of its own places: far from the origin it confirms the same forces.
TEST(Statics, AreConfirmedFarFromTheOrigin) {
    const auto text = [](const std::string& at) {
        const auto place = [&](const char* x, const char* y) {
            return "[\"= " + at + " + " + x + "\", \"= " + at + " - " + y + "\"]";
        };
        return R"({"kinegraph": 1, "frame": 1, "points": {"O": )" + place("0", "0") + R"(, "A": )" +
               place("0.3123456789", "0.4234567891") + R"(, "B": )" + place("1.7345678912", "0.1") +
               R"(}, "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]}, "joints": [
            {"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
            {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": [3.1, 1.7],
            "name": "G"}], "loads": [{"force": "F", "body": 3, "at": "A", "value": [30, -40]}],
            "effort": {"force": "P", "joint": "G"}, "find": ["forces"]})";
    };
    for (const char* at : {"0", "1000000", "1000000.3", "30000000.7"}) {
        const Solution solution = solved(text(at));
        ASSERT_TRUE(solution.unsolved.empty()) << at;
        EXPECT_GT(solution.checks.size(), 10U);
        EXPECT_LE(tests::worst_difference(solution), 1e-9) << at;
        for (const Message& remark : solution.remarks) EXPECT_NE(remark.sentence, lang::sentences::check_differs) << at;
    }
}

}  // namespace
}  // namespace kinegraph::statics_test
