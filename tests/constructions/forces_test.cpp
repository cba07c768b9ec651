// Forces by construction: the worked problems of the notes with their numbers and their order, the laws (mirrored,
// turned, scaled; concurrency; pins), and what cannot be resolved, with the reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "constructions/solving/solve.hpp"
#include "engine/results/results.hpp"
#include "lang/keys/phrases.hpp"
#include "lang/keys/sentences.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::forces_test {
namespace {

std::size_t at(auto index) { return at_index(index); }

Mechanism read(const std::string& text) {
    auto mechanism = read_mechanism(text, "test.json");
    if (mechanism) return *std::move(mechanism);
    throw std::runtime_error(mechanism.error().front().where + ": " +
                             mechanism.error().front().message.in(Language::en));
}

std::string example(const std::string& name) {
    std::ifstream file(std::string(KINEGRAPH_EXAMPLES_DIR) + "/" + name + ".json");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A solved mechanism, read by the names of its file.
struct Statics {
    Solution solution;

    explicit Statics(const Mechanism& mechanism) {
        auto solved = solve(mechanism);
        if (!solved) throw std::runtime_error(solved.error().front().message.in(Language::en));
        solution = *std::move(solved);
    }
    explicit Statics(const std::string& text) : Statics(read(text)) {}

    const std::string& body(BodyIndex index) const { return solution.mechanism.bodies[at(index)].name; }
    /// "A: 3 on 2", "A: pin on 2".
    std::string name(const JointForce& action) const {
        return solution.mechanism.joints[at(action.joint)].name + ": " +
               (action.from == none ? "pin" : body(action.from)) + " on " + body(action.on);
    }
    const JointForce& action(const std::string& named) const {
        for (const JointForce& each : solution.forces)
            if (name(each) == named) return each;
        throw std::out_of_range("no action " + named);
    }
    const Vector& force(const std::string& named) const { return action(named).force.value(); }
    const Exact& couple(const std::string& named) const { return action(named).couple.value(); }
    const Exact& effort(std::size_t index = 0) const { return solution.efforts.at(index).value.value(); }
    const FreeBody& free_body(const std::string& named) const {
        for (const FreeBody& each : solution.free_bodies)
            if (each.body != none && body(each.body) == named) return each;
        throw std::out_of_range("no free body " + named);
    }

    /// The sentences of the solution: "two forces 2 C D".
    std::vector<std::string> order() const {
        std::vector<std::string> lines;
        for (const Statement& statement : solution.protocol.statements) {
            if (statement.section != Topic::forces) continue;
            std::string line = said(statement.message.sentence);
            for (const Argument& argument : statement.message.arguments) line += " " + written(argument);
            lines.push_back(line);
        }
        return lines;
    }
    static std::string said(Key sentence) {
        using namespace lang::sentences;
        static const std::vector<std::pair<Key, std::string>> names{
            {two_force_body, "two forces"},
            {two_force_guide, "two forces at a guide"},
            {two_force_group, "together two forces"},
            {two_forces_and_couple, "two forces and a couple"},
            {three_force_line, "third line"},
            {inertia_force, "inertia"},
            {polygon, "polygon"},
            {triangle, "triangle"},
            {triangle_at, "concurrent"},
            {polygon_at, "concurrent"},
            {parallel_forces, "parallel"},
            {funicular_parallel, "parallel"},
            {funicular_parallel_one, "parallel"},
            {culmann, "Culmann"},
            {culmann_line, "Culmann"},
            {force_and_couple, "force and couple"},
            {couple_alone, "couple"},
            {no_force_along, "nothing beside"},
            {known_resultant, "resultant"},
            {single_reaction, "opposite"},
            {zero_forces, "nothing"},
            {superposition, "alone"},
            {superposition_next, "alone"},
            {superposition_sum, "sum"},
            {moments_give, "moments"},
            {virtual_work_gives, "virtual work"},
        };
        for (const auto& [key, name] : names)
            if (key == sentence) return name;
        return "?";
    }
    static std::string written(const Argument& argument) {
        if (const auto* point = std::get_if<PointName>(&argument)) return point->name;
        if (const auto* named = std::get_if<BodyName>(&argument)) return named->name;
        if (const auto* symbol = std::get_if<Symbol>(&argument)) return name_of(*symbol);
        if (const auto* text = std::get_if<std::string>(&argument)) return *text;
        if (const auto* symbols = std::get_if<Symbols>(&argument)) {
            std::string sum;
            for (const Symbol& each : *symbols) sum += (sum.empty() ? "" : "+") + name_of(each);
            return sum;
        }
        return "?";
    }
    /// Why the forces are not there; empty where they are.
    std::string why() const {
        for (const Unsolved& unsolved : solution.unsolved)
            if (unsolved.what.sentence == lang::phrases::all_forces) return english(unsolved.why);
        return "";
    }
};

using Lines = std::vector<std::string>;

void expect_near(const Vector& actual, double x, double y) {
    const double size = std::max(std::hypot(x, y), 1e-3);
    EXPECT_NEAR(actual.x.to_double(), x, 1e-12 * size);
    EXPECT_NEAR(actual.y.to_double(), y, 1e-12 * size);
}
void expect_has(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << "\"" << text << "\" without \"" << part << "\"";
}

// --- the worked problems of the notes
// ----------------------------------------------------------------------------------------

TEST(ForcesOfTheSeeds, SluiceGateHasTheSegmentsOfTheNotes) {
    const Statics s(example("sluice_gate"));
    EXPECT_TRUE(s.solution.unsolved.empty());
    const double millimetre = 1.66e6 * 9.81 / 14;  // 14 mm ≙ m g
    struct Row {
        const char* action;
        double notes, geometry, half_digit;
    };
    for (const Row& row :
         {Row{"A: 0 on 1", 6, 6.0, 0.05}, Row{"C: 2 on 1", 12, 12.0, 0.05}, Row{"D: 3 on 2", 12, 12.0, 0.05},
          Row{"E: 4 on 3", 24, 24.4, 0.05}, Row{"F: 5 on 4", 24, 24.4, 0.05}, Row{"B: 0 on 3", 27, 27.0, 0.05},
          Row{"G: 0 on 5", 17, 16.75, 0.005}}) {
        EXPECT_NEAR(length(s.force(row.action)) / millimetre, row.notes, 0.5) << row.action;
        EXPECT_NEAR(length(s.force(row.action)) / millimetre, row.geometry, row.half_digit) << row.action;
    }
    EXPECT_NEAR(-s.effort().to_double() / millimetre, 18, 0.5);
    EXPECT_NEAR(-s.effort().to_double() / millimetre, 17.75, 0.005) << "down along the guide";
    EXPECT_EQ(s.couple("G: 0 on 5"), Exact(0)) << "all forces on the piston pass through F";
    // R_21 and R_32 are one force, R_43 and R_54 another: exactly.
    EXPECT_EQ(s.force("C: 2 on 1"), s.force("D: 3 on 2"));
    EXPECT_EQ(s.force("E: 4 on 3"), s.force("F: 5 on 4"));
}

TEST(ForcesOfTheSeeds, SluiceGateIsResolvedInTheOrderOfTheNotes) {
    EXPECT_EQ(Statics(example("sluice_gate")).order(),
              (Lines{"two forces 2 C D", "concurrent 1 H F_21 F_01", "opposite 2 F_32", "two forces 4 E F",
                     "concurrent 3 K F_43 F_03", "opposite 4 F_54", "triangle 5 F_G F_05"}));
}

TEST(ForcesOfTheSeeds, TipperIsResolvedInTheOrderOfTheNotes) {
    const Statics s(example("tipper"));
    EXPECT_TRUE(s.solution.unsolved.empty());
    EXPECT_TRUE(s.solution.remarks.empty()) << "the roller pushes";
    EXPECT_EQ(s.order(), (Lines{"concurrent 1 H F_41 F_01", "together two forces 2 + 3 C E", "concurrent 4 K F_34 F_04",
                                "nothing beside 3 F_23 F_p M_23", "opposite 2 F_02"}));
}

TEST(ForcesOfTheSeeds, TippersSleeveCarriesNothing) {
    const Statics s(example("tipper"));
    bool said = false;
    for (const Statement& statement : s.solution.protocol.statements)
        said = said || english(statement.message).find("F_23 = 0; the couple M_23 = 0 too") != std::string::npos;
    EXPECT_TRUE(said);
    for (const char* action : {"D: 2 on 3", "D: 3 on 2"}) {
        EXPECT_EQ(s.force(action), Vector{}) << action;
        EXPECT_EQ(s.couple(action), Exact(0)) << action;
    }
    // Box: moments about A, m g x_O = R_41·AF. Cylinder and piston: F_p = R_43.
    EXPECT_NEAR(length(s.force("F: 4 on 1")), 9000 * 9.81 * 1.8794 / std::hypot(2.4432, 0.88925), 1e-8);
    EXPECT_NEAR(s.effort().to_double(), length(s.force("E: 4 on 3")), 1e-8);
    EXPECT_NEAR(s.effort().to_double(), 152783.083, 1e-3);
    EXPECT_EQ(s.force("C: 0 on 2"), s.force("E: 3 on 4"));
    EXPECT_EQ(dot(s.force("F: 4 on 1"), s.solution.pose.at(*s.solution.mechanism.point_named("F"))), Exact(0))
        << "⟂ AF";
}

TEST(ForcesOfTheSeeds, ExamOf2001) {
    const Statics s(example("exam_2001"));
    EXPECT_TRUE(s.solution.unsolved.empty());
    EXPECT_NEAR(length(s.force("A: 2 on 1")), 29.3536, 5e-5);
    EXPECT_NEAR(length(s.force("A: 2 on 1")), 29.3, 0.06) << "the notes";
    EXPECT_NEAR(s.effort().to_double(), -8.0839, 5e-5);
    EXPECT_NEAR(std::abs(s.effort().to_double()), 8.03, 0.06) << "the notes, a slip of 0.05 included";
    EXPECT_NEAR(length(s.force("C: 5 on 4")), 19.2542, 5e-5);
    EXPECT_NEAR(length(s.force("M: 0 on 5")), 85.6374, 5e-5);
    EXPECT_NEAR(s.couple("M: 0 on 5").to_double(), -1.49551, 5e-6) << "the guide's force passes C, not M";
    EXPECT_EQ(s.order(),
              (Lines{"inertia 5 F_i a_M M", "two forces at a guide 2 A D", "two forces 3 O2 B", "third line 4 H F_54 C",
                     "resultant 5 F_g+F_i F_R5", "concurrent 5 K F_45 F_05", "triangle 4 F_24 F_34", "opposite 2 F_12",
                     "force and couple 1 F_01 M_C", "opposite 3 F_03"}));
}

TEST(ForcesOfTheSeeds, RotatingBodyNeedsACouple) {
    const Statics s(example("rotating_body"));
    // F_c = m ω² OG; M = F_1·y_X, for F_1 is the only force that does not pass O.
    EXPECT_EQ(s.force("O: 1 on 2"), (Vector{Exact::ratio(-824656, 10000), Exact::ratio(-297216, 10000)}));
    EXPECT_EQ(s.effort(), Exact::ratio(9848, 1000));
    EXPECT_EQ(s.order(), (Lines{"inertia 2 F_i a_G G", "resultant 2 F_1+F_i F_R2", "force and couple 2 F_12 M_12"}));
}

// --- the other examples
// --------------------------------------------------------------------------------------------------------

TEST(ForceExamples, HaveTheirClosedForms) {
    // M = F Λ and guide F tan β of the slider-crank a = 50, b = 150 mm at 60°.
    const double angle = std::acos(0.5), beta = std::asin(-std::sin(angle) / 3);
    const Statics gas(example("gas_force"));
    EXPECT_NEAR(gas.effort().to_double(), 2000 * -0.05 * (std::sin(angle) - std::cos(angle) * std::tan(beta)), 1e-10);
    EXPECT_NEAR(gas.force("B: 1 on 4").y.to_double(), -2000 * std::tan(beta), 1e-10);

    const Statics pliers(example("pliers"));
    EXPECT_EQ(pliers.effort(), Exact::ratio(20625, 10));
    EXPECT_EQ(pliers.force("B: 4 on 2"), (Vector{0, 1650}));
    EXPECT_EQ(pliers.force("H: 4 on 3"), (Vector{0, -1750}));
    EXPECT_EQ(pliers.force("O: 2 on 1"), (Vector{0, Exact::ratio(37125, 10)}));

    const Statics lever(example("three_parallel_forces"));
    EXPECT_EQ(lever.effort(), Exact(240));
    EXPECT_EQ(lever.force("O: 1 on 2"), (Vector{0, 840}));
    EXPECT_EQ(lever.order(), (Lines{"parallel 2 F_Q F_12 F_P"}));

    const Statics plate(example("four_force_body"));
    EXPECT_EQ(plate.force("A: 3 on 2"), (Vector{0, Exact::ratio(6225, 14)}));
    EXPECT_EQ(plate.force("B: 4 on 2"), (Vector{Exact::ratio(-1650, 7), Exact::ratio(3300, 7)}));
    EXPECT_EQ(plate.force("C: 5 on 2"), (Vector{Exact::ratio(-450, 7), Exact::ratio(-225, 14)}));
    const Lines order = plate.order();
    EXPECT_EQ(order.at(3), "Culmann 2 H K F_32 F_42 F_52");

    const Statics beam(example("beam"));
    const double q = 2000 * std::sin(angle), r = (3000 + 3 * q) / 4;
    expect_near(beam.force("B: 1 on 2"), 0, r);
    expect_near(beam.force("A: 1 on 2"), -1000, 3000 + q - r);

    EXPECT_NEAR(Statics(example("toggle_clamp")).effort().to_double(), 81.5283287471, 1e-9);
    EXPECT_NEAR(Statics(example("cutting_force")).effort().to_double(), 105.900479202, 1e-8);
    EXPECT_NEAR(Statics(example("four_bar_weights")).effort().to_double(), 0.380955749573, 1e-11);
    EXPECT_NEAR(Statics(example("four_bar_inertia")).effort().to_double(), 0.526084841358, 1e-11);
}

TEST(ForceExamples, WeightsOnAllLinksAreSuperposed) {
    const Lines order = Statics(example("four_bar_weights")).order();
    Lines alone;
    std::copy_if(order.begin(), order.end(), std::back_inserter(alone),
                 [](const std::string& line) { return line.rfind("alone", 0) == 0 || line == "sum"; });
    EXPECT_EQ(alone, (Lines{"alone 2", "alone 3", "alone 4", "sum"}));
}

// --- laws
// ---------------------------------------------------------------------------------------------------------------------

/// Where forces are concurrent they are so exactly: each line passes the meet that the protocol names.
TEST(ForceLaws, ConcurrencyIsExact) {
    for (const auto& [file, named] :
         {std::pair("sluice_gate", "1"), std::pair("sluice_gate", "3"), std::pair("tipper", "1"),
          std::pair("tipper", "4"), std::pair("toggle_clamp", "3")}) {
        const Statics s(example(file));
        const FreeBody& body = s.free_body(named);
        ASSERT_EQ(body.meets.size(), 1u) << file << named;
        EXPECT_EQ(body.forces.size(), 3u) << file << named;
        for (const AppliedForce& applied : body.forces)
            EXPECT_EQ(cross(body.meets.front().place - applied.at, applied.force), Exact(0))
                << file << name_of(applied.symbol);
    }
    const Statics exam(example("exam_2001"));
    const FreeBody& four = exam.free_body("4");
    ASSERT_FALSE(four.forces.empty());
    ASSERT_FALSE(four.meets.empty());
    for (const AppliedForce& applied : four.forces)
        EXPECT_LE(std::abs(cross(four.meets.front().place - applied.at, applied.force).to_double()), 1e-25);
}

/// x ↦ a·x − s·b·y, y ↦ b·x + s·a·y; s = −1 mirrors.
struct Similarity {
    Exact a, b;
    int s = 1;

    Vector operator()(const Vector& v) const { return {a * v.x - s * b * v.y, b * v.x + s * a * v.y}; }
    Exact squared_scale() const { return square(a) + square(b); }
    Exact sense() const { return s; }
};

/// The mechanism as it is drawn, every point and direction a given one, moved by the map. Lengths and forces grow by k,
/// couples by k²: so gravity by k, moments of inertia by k².
Mechanism moved(const Solution& solution, const Similarity& map, const Exact& k) {
    Mechanism m = solution.mechanism;
    const Pose& pose = solution.pose;
    const auto turn = [&](Bearing& bearing) { bearing.form = map(direction_of(bearing, pose)); };
    for (std::size_t p = 0; p < m.points.size(); ++p) m.points[p].placement = Coordinates{map(pose.points[p])};
    for (Joint& joint : m.joints) {
        if (joint.along) turn(*joint.along);
        if (joint.tangent) turn(*joint.tangent);
        if (joint.pushes) joint.pushes = map(*joint.pushes);
        for (auto& [body, profile] : joint.profiles)
            if (auto* line = std::get_if<LineProfile>(&profile)) turn(line->along);
    }
    for (Driver& driver : m.drivers) {
        auto& spin = std::get<SpinDriver>(driver);
        spin.omega *= map.sense();
        spin.alpha *= map.sense();
    }
    if (m.gravity) m.gravity = map(*m.gravity);
    for (Mass& mass : m.masses) mass.inertia *= square(k);
    for (Load& load : m.loads) {
        if (auto* force = std::get_if<ForceLoad>(&load)) {
            if (force->magnitude) {
                force->value =
                    force->magnitude->first * unit_along(direction_of(force->magnitude->second, pose), pose.bits);
                force->magnitude.reset();
            }
            force->value = map(*force->value);
        } else if (auto* couple = std::get_if<CoupleLoad>(&load)) {
            couple->value *= map.sense() * square(k);
        } else {
            std::get<SpringLoad>(load).magnitude *= k;
        }
    }
    m.precision = Exact(0);  // its coordinates have become long, and are exact
    for (Effort& effort : m.efforts)
        if (auto* force = std::get_if<ForceEffort>(&effort)) turn(force->along);
    return m;
}

void expect_moved(const std::string& name, const Similarity& map, const Exact& k) {
    SCOPED_TRACE(name);
    // First as it is, so that both have the very same drawing without a leftover.
    const Statics as_is(moved(Statics(example(name)).solution, {1, 0}, 1));
    const Statics there(moved(as_is.solution, map, k));
    ASSERT_TRUE(as_is.solution.pose.exact && there.solution.pose.exact);
    EXPECT_EQ(there.why(), "");
    EXPECT_EQ(there.order(), as_is.order());
    ASSERT_EQ(there.solution.forces.size(), as_is.solution.forces.size());
    for (std::size_t i = 0; i < as_is.solution.forces.size(); ++i) {
        const JointForce &before = as_is.solution.forces[i], &after = there.solution.forces[i];
        EXPECT_EQ(*after.force, map(*before.force)) << as_is.name(before);
        EXPECT_EQ(*after.couple, map.sense() * square(k) * *before.couple) << as_is.name(before);
    }
    for (std::size_t e = 0; e < as_is.solution.efforts.size(); ++e) {
        const bool couple = std::holds_alternative<CoupleEffort>(as_is.solution.mechanism.efforts[e]);
        const Exact expected = as_is.effort(e) * (couple ? map.sense() * square(k) : k);
        // A force's size is in units of a unit vector, whose length is a root.
        EXPECT_LE(std::abs((there.effort(e) - expected).to_double()),
                  couple ? 0 : 1e-28 * std::abs(expected.to_double()));
    }
    ASSERT_EQ(there.solution.free_bodies.size(), as_is.solution.free_bodies.size());
    for (std::size_t b = 0; b < as_is.solution.free_bodies.size(); ++b) {
        const auto &before = as_is.solution.free_bodies[b].meets, &after = there.solution.free_bodies[b].meets;
        ASSERT_EQ(after.size(), before.size());
        for (std::size_t i = 0; i < before.size(); ++i)
            EXPECT_EQ(after[i].place, map(before[i].place)) << before[i].name;
    }
}

const char* const loaded_examples[] = {"sluice_gate",     "tipper",        "exam_2001",        "rotating_body",
                                       "gas_force",       "cutting_force", "toggle_clamp",     "three_parallel_forces",
                                       "four_force_body", "beam",          "four_bar_weights", "four_bar_inertia"};

TEST(ForceLaws, MirroredMechanismHasTheMirroredForces) {
    for (const char* name : loaded_examples) expect_moved(name, {-1, 0, -1}, 1);
    expect_moved("pliers", {-1, 0, -1}, 1);
}
TEST(ForceLaws, TurnedMechanismHasTheTurnedForces) {
    for (const char* name : loaded_examples) expect_moved(name, {Exact::ratio(3, 5), Exact::ratio(4, 5)}, 1);
    expect_moved("pliers", {Exact::ratio(3, 5), Exact::ratio(4, 5)}, 1);
}
TEST(ForceLaws, LargerMechanismHasTheLargerForces) {
    for (const char* name : loaded_examples) expect_moved(name, {3, 0}, 3);
}
TEST(ForceLaws, MirroredExamplesAreTheMirrorImages) {
    for (const std::string name : {"sluice_gate", "tipper"}) {
        const Statics one(example(name)), other(example(name + "_mirrored"));
        ASSERT_FALSE(one.solution.forces.empty());
        ASSERT_EQ(one.solution.forces.size(), other.solution.forces.size());
        for (const JointForce& action : one.solution.forces) {
            const Vector& force = *action.force;
            EXPECT_EQ(other.force(one.name(action)), (Vector{-force.x, force.y})) << one.name(action);
            EXPECT_EQ(other.couple(one.name(action)), -*action.couple) << one.name(action);
        }
        EXPECT_EQ(one.order(), other.order());
    }
}

// --- pairs
// ---------------------------------------------------------------------------------------------------------------------

TEST(ForcePairs, PinOfThreeBodiesActsOnEach) {
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [0, 1], "C": [1, 0], "D": [2, 0]},
        "bodies": {"2": ["A", "C"], "3": ["B", "C"], "4": ["C", "D"]},
        "joints": [{"revolute": "A", "bodies": [1, 2]}, {"revolute": "B", "bodies": [1, 3]},
                   {"revolute": "C", "bodies": [2, 3, 4]}, {"contact": "D", "bodies": [4, 1], "tangent": 0}],
        "loads": [{"force": "F", "body": 4, "at": "D", "value": [500, -200]},
                  {"force": "P", "body": 4, "at": "C", "value": [0, -100]}]})");
    EXPECT_EQ(s.why(), "");
    // The load at C hangs on the bar 3 (1, −1)/√2 and on 2.
    EXPECT_EQ(s.force("C: pin on 4"), (Vector{-500, 100}));
    EXPECT_EQ(s.force("C: pin on 3"), (Vector{100, -100}));
    EXPECT_EQ(s.force("C: pin on 2"), (Vector{400, 0}));
    EXPECT_EQ(s.force("C: pin on 2") + s.force("C: pin on 3") + s.force("C: pin on 4"), Vector{});
    EXPECT_EQ(s.force("D: 1 on 4"), (Vector{0, 200}));
}

TEST(ForcePairs, TeethPushApart) {
    for (const char* couple : {"3", "-3"}) {
        const Statics s(
            R"({"kinegraph": 1, "frame": 1, "points": {"C": [0, 0], "P": [0.02, 0], "D": [0.08, 0]}, "bodies":
            {"2": {"points": ["C"], "circle": {"centre": "C", "radius": 0.02}}, "3": {"points": ["D"],
            "circle": {"centre": "D",
            "radius": 0.06}}}, "joints": [{"revolute": "C", "bodies": [1, 2]}, {"revolute": "D", "bodies": [1, 3]},
            {"gear": "P", "bodies": [2, 3], "pressure angle": 20}], "loads": [{"couple": "M", "body": 2, "value": )" +
            std::string(couple) + R"(}], "effort": {"couple": "E", "body": 3}})");
        EXPECT_EQ(s.why(), "");
        const double tangential = std::stod(couple) / 0.02;
        expect_near(s.force("P: 3 on 2"), -std::abs(tangential) * std::tan(std::acos(-1) / 9), -tangential);
        EXPECT_EQ(s.effort(), Exact(std::stod(couple) > 0 ? 9 : -9)) << "the wheel's couple, radii 1 : 3";
    }
}

// One of the two senses is found on the flanks that were assumed first, the other on those turned round; of the attempt
// before nothing is said.
TEST(ForcePairs, TeethTurnedToTheirOtherFlankLeaveNoSentenceBehind) {
    std::vector<std::vector<Key>> said;
    for (const char* couple : {"60", "-60"}) {
        const Statics s(
            R"({"kinegraph": 1, "units": {"length": "mm"}, "frame": 1, "points": {"O": [0, 0], "Q": {"from": "O",
            "distance": 75, "angle": 50}, "P1": {"from": "O", "to": "Q", "distance": 40}, "P2": {"from": "O", "to": "Q",
            "distance": 110}}, "bodies": {"1": {"points": ["O"], "circle": {"centre": "O", "radius": 110}},
            "2": {"points": ["O",
            "P1"], "circle": {"centre": "O", "radius": 40}}, "3": {"points": ["Q"], "circle": {"centre": "Q",
            "radius": 35}},
            "4": ["O", "Q"]}, "joints": [{"revolute": "O", "bodies": [1, 2, 4]}, {"revolute": "Q", "bodies": [3, 4]},
            {"gear": "P1", "bodies": [2, 3], "arm": 4, "profiles": {}, "pressure angle": 20},
            {"gear": "P2", "bodies": [3, 1], "arm": 4, "profiles": {}, "pressure angle": 20}],
            "loads": [{"couple": "Mr", "body": 4, "value": )" +
            std::string(couple) + R"(}], "effort": {"couple": "Mm", "body": 2}})");
        EXPECT_EQ(s.why(), "");
        EXPECT_NEAR(s.effort().to_double(), -std::stod(couple) * 40 / 150, 1e-9) << "Willis: the sun's share";
        said.emplace_back();
        for (const Statement& statement : s.solution.protocol.statements)
            if (statement.section == Topic::forces) said.back().push_back(statement.message.sentence);
    }
    EXPECT_EQ(said.front(), said.back());
    const auto parallel = std::count(said.front().begin(), said.front().end(), lang::sentences::three_parallel_lines);
    EXPECT_EQ(parallel, 0) << "slanting lines of action meet";
}

TEST(ForcePairs, ContactThatWouldPullIsSaidToLiftOff) {
    const auto beam = [](const char* load) {
        return Statics(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [4, 0], "P": [1, 0]},
            "bodies": {"2": ["A", "B", "P"]}, "joints": [{"revolute": "A", "bodies": [1, 2]},
            {"contact": "B", "bodies": [2, 1], "tangent": 0, "pushes": [0, 1]}],
            "loads": [{"force": "F", "body": 2, "at": "P", "value": [0, )" +
                       std::string(load) + "]}]}");
    };
    EXPECT_TRUE(beam("-100").solution.remarks.empty());
    const Statics lifting = beam("100");
    ASSERT_EQ(lifting.solution.remarks.size(), 1u);
    expect_has(english(lifting.solution.remarks.front()), "The contact at B would have to pull");
    EXPECT_EQ(lifting.force("B: 1 on 2"), (Vector{0, -25})) << "what it would have to do";
    EXPECT_TRUE(lifting.solution.unsolved.empty());
}

TEST(ForcePairs, ClampTakesForceAndCouple) {
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "P": [2, 0]}, "bodies": {"2": ["A", "P"]},
        "joints": [{"weld": "A", "bodies": [1, 2]}], "loads": [{"force": "F", "body": 2, "at": "P", "value": [30,
        -100]}]})");
    EXPECT_EQ(s.why(), "");
    EXPECT_EQ(s.force("A: 1 on 2"), (Vector{-30, 100}));
    EXPECT_EQ(s.couple("A: 1 on 2"), Exact(200));
}

// --- what cannot be resolved
// ---------------------------------------------------------------------------------------------------

TEST(ForceRefusals, BeamOnThreeSupports) {
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [4, 0], "C": [2, 0], "P": [1, 0]},
        "bodies": {"2": ["A", "B", "C", "P"]}, "joints": [{"revolute": "A", "bodies": [1, 2]},
        {"contact": "B", "bodies": [2, 1], "tangent": 0}, {"contact": "C", "bodies": [2, 1], "tangent": 0}],
        "loads": [{"force": "F", "body": 2, "at": "P", "value": [0, -100]}]})");
    expect_has(s.why(), "statically indeterminate, 1 time");
    expect_has(s.why(), "joint C");
    EXPECT_FALSE(s.action("B: 1 on 2").force) << "no number where equilibrium gives none";
    EXPECT_FALSE(s.action("A: 1 on 2").force);
}

TEST(ForceRefusals, FourBarWithAParallelBarTooMany) {
    const Statics s(R"({"kinegraph": 1, "frame": 1,
        "points": {"O": [0, 0], "A": [0, 1], "Q": [2, 0], "B": [2, 1], "R": [4, 0], "C": [4, 1], "P": [3, 1]},
        "bodies": {"2": ["O", "A"], "3": ["A", "B", "C", "P"], "4": ["Q", "B"], "5": ["R", "C"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "Q",
        "bodies": [1, 4]},
                   {"revolute": "B", "bodies": [3, 4]}, {"revolute": "R", "bodies": [1, 5]}, {"revolute": "C",
                   "bodies": [3, 5]}],
        "loads": [{"force": "F", "body": 3, "at": "P", "value": [10, -100]}], "effort": {"couple": "M", "body": 2}})");
    EXPECT_EQ(s.solution.mobility.effective, 1);
    expect_has(s.why(), "statically indeterminate, 1 time");
    expect_has(s.why(), "joint C");
}

const std::string slider_crank =
    R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": [0.03, 0.04], "B": [0.16, 0]},
    "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
    "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
    "bodies": [3, 4]},
               {"prismatic": "B", "bodies": [4, 1], "along": 0, "name": "guide"}],
    "loads": [{"force": "F", "body": 4, "at": "B", "value": [-2000, 0]}])";

TEST(ForceRefusals, LoadsWithoutAnEffort) {
    const Statics s(slider_crank + "}");
    expect_has(s.why(), "not balanced");
    expect_has(s.why(), "1 freedom");
    expect_has(s.why(), "0 efforts");
}

TEST(ForceRefusals, TwoEffortsForOneFreedom) {
    const Statics s(slider_crank + R"(, "effort": [{"couple": "M", "body": 2}, {"force": "E", "joint": "guide"}]})");
    expect_has(s.why(), "2 efforts stand against 1 freedom");
}

TEST(ForceRefusals, EffortAtItsDeadPoint) {
    const std::string dead = R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": [0.05, 0], "B": [0.2, 0]},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
        "bodies": [3, 4]},
                   {"prismatic": "B", "bodies": [4, 1], "along": 0, "name": "guide"}], )";
    // The slider's force has no lever about the crank.
    const Statics locked(
        dead + R"("loads": [{"couple": "M", "body": 2, "value": 12}], "effort": {"force": "F", "joint": "guide"}})");
    expect_has(locked.why(), "grows without limit");
    expect_has(locked.why(), "dead point");
    EXPECT_FALSE(locked.solution.efforts.at(0).value);
    // The other way round the rods hold the load by themselves: a couple of nothing, exactly.
    const Statics held(
        dead +
        R"("loads": [{"force": "F", "body": 4, "at": "B", "value": [-2000, 0]}], "effort": {"couple": "M",
        "body": 2}})");
    EXPECT_EQ(held.why(), "");
    EXPECT_EQ(held.effort(), Exact(0));
    EXPECT_EQ(held.force("O: 1 on 2"), (Vector{2000, 0}));
}

TEST(ForceRefusals, SpringWithoutADirection) {
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "P": [1, 1], "B": [2, 0], "Q": [1, 1]},
        "bodies": {"2": ["A", "P"], "3": ["B", "Q"]},
        "joints": [{"revolute": "A", "bodies": [1, 2]}, {"revolute": "B", "bodies": [1, 3]}],
        "loads": [{"force": "S", "bodies": [2, 3], "between": ["P", "Q"], "magnitude": 50}],
        "effort": [{"couple": "M2", "body": 2}, {"couple": "M3", "body": 3}]})");
    expect_has(s.why(), "the ends of S coincide");
}

TEST(ForceRefusals, InertiaWithoutMotion) {
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "G": [1, 0]}, "bodies": {"2": ["O", "G"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}], "masses": {"2": {"mass": 3, "centre": "G"}},
        "inertia forces": true,
        "effort": {"couple": "M", "body": 2}})");
    expect_has(s.why(), "drivers");
}

TEST(ForceRefusals, WhatIsKnownBesideIsStillGiven) {
    // A beam on three supports, and beside it a lever that equilibrium determines.
    const Statics s(R"({"kinegraph": 1, "frame": 1,
        "points": {"A": [0, 0], "B": [4, 0], "C": [2, 0], "O": [0, 5], "P": [-1, 5], "Q": [2, 5]},
        "bodies": {"2": ["A", "B", "C"], "3": ["O", "P", "Q"]},
        "joints": [{"revolute": "A", "bodies": [1, 2]}, {"contact": "B", "bodies": [2, 1], "tangent": 0},
                   {"contact": "C", "bodies": [2, 1], "tangent": 0}, {"revolute": "O", "bodies": [1, 3]}],
        "loads": [{"force": "F", "body": 2, "at": "C", "value": [0, -100]}, {"force": "G", "body": 3, "at": "P",
        "value": [0, -60]}],
        "effort": {"force": "E", "body": 3, "at": "Q", "along": 90}})");
    expect_has(s.why(), "statically indeterminate");
    EXPECT_EQ(s.effort(), Exact(-30));
    EXPECT_EQ(s.force("O: 1 on 3"), (Vector{0, 90}));
}

// --- the results file
// ----------------------------------------------------------------------------------------------------------

TEST(ForceResultsFile, HasTheShapeOfTheFormat) {
    using Json = nlohmann::ordered_json;
    const Json tipper = Json::parse(results_json(Statics(example("tipper")).solution, false, english));
    const Json& sleeve = tipper["forces"]["D"]["2 on 3"];
    EXPECT_EQ(sleeve.dump(), R"({"force":[0,0],"at":[2.475,-0.4],"couple":0,"through":null})");
    EXPECT_TRUE(tipper["effort"]["F_p"].is_number());
    EXPECT_TRUE(tipper["unsolved"].empty());

    // A guide's couple is taken about `at`; `through` is the foot of the resultant's line.
    const Json exam = Json::parse(results_json(Statics(example("exam_2001")).solution, false, english));
    const Json& guide = exam["forces"]["M"]["0 on 5"];
    std::vector<std::string> keys;
    for (const auto& item : guide.items()) keys.push_back(item.key());
    EXPECT_EQ(keys, (Lines{"force", "at", "couple", "through"}));
    const auto number = [&](const char* key, std::size_t i) { return guide[key][i].get<double>(); };
    const double rx = number("through", 0) - number("at", 0), ry = number("through", 1) - number("at", 1);
    const double fx = number("force", 0), fy = number("force", 1);
    EXPECT_NEAR(rx * fy - ry * fx, guide["couple"].get<double>(), 1e-12) << "the force through there gives the couple";
    EXPECT_NEAR(rx * fx + ry * fy, 0, 1e-12) << "the foot";
    EXPECT_EQ(exam["forces"].size(), 7u);
    EXPECT_TRUE(exam["forces"]["O1"].contains("1 on 0"));

    const Json fractions = Json::parse(results_json(Statics(example("rotating_body")).solution, true, english));
    EXPECT_NE(fractions["forces"]["O"]["1 on 2"].dump().find("exact"), std::string::npos);

    // A loaded mechanism without answer: what it asks for is there, empty, and the reason.
    const Json refused = Json::parse(results_json(Statics(slider_crank + "}").solution, false, english));
    EXPECT_TRUE(refused["forces"].is_object());
    EXPECT_EQ(refused["unsolved"][0]["what"], "forces");
    EXPECT_TRUE(refused["effort"].empty());

    const Json pins = Json::parse(
        results_json(Statics(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "P": [1, 0], "Q": [-2, 0]},
        "bodies": {"2": ["O", "P"], "3": ["O", "Q"]}, "joints": [{"revolute": "O", "bodies": [1, 2, 3]}],
        "masses": {"2": {"mass": 1, "centre": "P"}, "3": {"mass": 2, "centre": "Q"}}, "gravity": [0, -10],
        "effort": [{"couple": "M2", "body": 2}, {"couple": "M3", "body": 3}]})")
                         .solution,
                     false, english));
    EXPECT_EQ(pins["forces"]["O"]["pin on 2"]["force"].dump(), "[0,10]");
    EXPECT_EQ(pins["forces"]["O"]["pin on 3"]["force"].dump(), "[0,20]");
    EXPECT_EQ(pins["forces"]["O"]["pin on 1"]["force"].dump(), "[0,-30]");
    EXPECT_EQ(pins["effort"].dump(), R"({"M2":10,"M3":-40})");
}

}  // namespace
}  // namespace kinegraph::forces_test
