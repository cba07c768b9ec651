// The numeric check of the forces: closed forms for every kind of pair and load, the worked problems of the notes, what
// equilibrium does not determine, and the power that must close on every mechanism that moves.
#include "engine/check/check_forces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace kinegraph::check_forces_test {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

/// A file's text, drawn and checked; read by the file's names.
struct Statics {
    Mechanism mechanism;
    Pose pose;
    NumericMotion motion;
    NumericForces forces;

    explicit Statics(Mechanism given) : mechanism(std::move(given)) {
        auto drawn = draw_pose(mechanism);
        if (!drawn) {
            ADD_FAILURE() << drawn.error().front().where << ": " << drawn.error().front().message.in(Language::en);
            motion.bodies.resize(mechanism.bodies.size());
            return;
        }
        pose = *std::move(drawn);
        motion = check_motion(mechanism, pose);
        forces = check_forces(mechanism, pose, motion);
    }
    explicit Statics(const std::string& text) : Statics(read(text)) {}

    static Mechanism read(const std::string& text) {
        auto mechanism = read_mechanism(text, "test.json");
        if (mechanism) return *std::move(mechanism);
        ADD_FAILURE() << mechanism.error().front().where << ": " << mechanism.error().front().message.in(Language::en);
        return {};
    }

    /// The action at the joint on one body; of the pin where the joint has more than two.
    NumericForces::Action on(const std::string& joint, const std::string& body) const {
        for (const auto& action : forces.actions) {
            const bool here = mechanism.joints[at_index(action.joint)].name == joint;
            if (here && mechanism.bodies[at_index(action.on)].name == body) return action;
        }
        ADD_FAILURE() << "nothing acts on " << body << " at " << joint;
        return {};
    }
    double size(const std::string& joint, const std::string& body) const {
        const auto action = on(joint, body);
        return std::hypot(action.force[0], action.force[1]);
    }
    double effort(std::size_t index = 0) const { return forces.efforts.at(index); }

    bool all_known() const {
        const auto known = [](const NumericForces::Action& action) { return action.known; };
        return std::all_of(forces.actions.begin(), forces.actions.end(), known) &&
               std::find(forces.effort_known.begin(), forces.effort_known.end(), false) == forces.effort_known.end();
    }
};

void expect_determined(const Statics& statics) {
    EXPECT_TRUE(statics.forces.balanced);
    EXPECT_EQ(statics.forces.indeterminacy, 0);
    EXPECT_LE(statics.forces.residual, 1e-13);
    EXPECT_TRUE(statics.all_known());
}
void expect_force(const NumericForces::Action& action, double x, double y, double couple = 0) {
    const double tolerance = 1e-12 * std::max({std::abs(x), std::abs(y), std::abs(couple), 0.1});
    EXPECT_TRUE(action.known);
    EXPECT_NEAR(action.force[0], x, tolerance);
    EXPECT_NEAR(action.force[1], y, tolerance);
    EXPECT_NEAR(action.couple, couple, tolerance);
}

// --- power
// -------------------------------------------------------------------------------------------------------------------

double dot(const std::array<double, 2>& a, const std::array<double, 2>& b) { return a[0] * b[0] + a[1] * b[1]; }
std::array<double, 2> numbers(const Vector& a) { return {a.x.to_double(), a.y.to_double()}; }

/// Power of loads, weights, inertia and efforts in the motion of the drivers: zero, as ideal pairs do no work. The
/// largest term is what the sum is small against.
void expect_power_closes(const Statics& s) {
    double sum = 0;
    double largest = 0;
    const auto add = [&](double power) {
        sum += power;
        largest = std::max(largest, std::abs(power));
    };
    const auto state = [&](BodyIndex body) { return s.motion.bodies[at_index(body)]; };
    const auto force = [&](BodyIndex body, PointIndex at, const Vector& direction, double size) {
        const auto d = numbers(unit_along(direction, 100));
        add(size * dot(d, s.motion.velocity(body, s.pose.at(at))));
    };
    for (const Load& load : s.mechanism.loads) {
        if (const auto* one = std::get_if<ForceLoad>(&load)) {
            if (one->value) add(dot(numbers(*one->value), s.motion.velocity(one->body, s.pose.at(one->at))));
            if (one->magnitude) {
                force(one->body, one->at, direction_of(one->magnitude->second, s.pose),
                      one->magnitude->first.to_double());
            }
        } else if (const auto* couple = std::get_if<CoupleLoad>(&load)) {
            add(couple->value.to_double() * state(couple->body).omega);
        } else {
            const auto& spring = std::get<SpringLoad>(load);
            const Vector join = s.pose.at(spring.between[1]) - s.pose.at(spring.between[0]);
            force(spring.bodies[0], spring.between[0], join, spring.magnitude.to_double());
            force(spring.bodies[1], spring.between[1], -join, spring.magnitude.to_double());
        }
    }
    for (const Mass& mass : s.mechanism.masses) {
        const Vector& centre = s.pose.at(mass.centre);
        const auto v = s.motion.velocity(mass.body, centre);
        if (s.mechanism.gravity) add(mass.mass.to_double() * dot(numbers(*s.mechanism.gravity), v));
        if (!s.mechanism.inertia_forces) continue;
        add(-mass.mass.to_double() * dot(s.motion.acceleration(mass.body, centre), v));
        add(-mass.inertia.to_double() * state(mass.body).alpha * state(mass.body).omega);
    }
    for (std::size_t i = 0; i < s.mechanism.efforts.size(); ++i) {
        const Effort& effort = s.mechanism.efforts[i];
        if (const auto* couple = std::get_if<CoupleEffort>(&effort)) {
            add(s.effort(i) * (state(couple->body).omega - state(couple->from).omega));
        } else if (const auto* one = std::get_if<ForceEffort>(&effort)) {
            force(one->body, one->at, direction_of(one->along, s.pose), s.effort(i));
        } else {
            const JointIndex index = std::get<ActuatorEffort>(effort).joint;
            const Joint& joint = s.mechanism.joints[at_index(index)];
            const Vector& guide = s.pose.guides[at_index(index)];
            force(joint.bodies[0], joint.point, guide, s.effort(i));
            force(joint.bodies[1], joint.point, -guide, s.effort(i));
        }
    }
    EXPECT_GT(largest, 0);
    EXPECT_LE(std::abs(sum), 1e-12 * largest);
}

// --- one body
// ----------------------------------------------------------------------------------------------------------------

std::string beam(const std::string& support) {
    return R"({"kinegraph": 1, "frame": 1,
        "points": {"A": [0, 0], "P": [1, 0], "Q": [3, 0], "B": [4, 0]},
        "bodies": {"2": ["A", "P", "Q", "B"]},
        "joints": [{"revolute": "A", "bodies": [1, 2]}, )" +
           support + R"(],
        "loads": [{"force": "P", "body": 2, "at": "P", "value": [0, -3000]},
                  {"force": "Q", "body": 2, "at": "Q", "magnitude": 2000, "along": -60}]})";
}

TEST(Forces, BeamOnAHingeAndARoller) {
    // Moments about A: 4 R_B = 3000·1 + 2000 sin 60°·3.
    const Statics s(beam(R"({"contact": "B", "bodies": [2, 1], "tangent": 0})"));
    expect_determined(s);
    const double q = 2000 * std::sin(60 * degree);
    const double r = (3000 + 3 * q) / 4;
    expect_force(s.on("B", "2"), 0, r);
    expect_force(s.on("B", "1"), 0, -r);
    expect_force(s.on("A", "2"), -1000, 3000 + q - r);
    EXPECT_EQ(s.forces.actions.size(), 4U);
    EXPECT_EQ(s.forces.actions[0].on, frame);
    EXPECT_EQ(s.forces.actions[0].from, BodyIndex(1));
}

TEST(Forces, BeamOnAHingeAndAnInclinedRoller) {
    const Statics s(beam(R"({"contact": "B", "bodies": [2, 1], "tangent": 30})"));
    expect_determined(s);
    const double q = 2000 * std::sin(60 * degree);
    const double r = (3000 + 3 * q) / 4;
    expect_force(s.on("B", "2"), -r * std::tan(30 * degree), r);
}

TEST(Forces, BeamOnTwoHingesIsOnceIndeterminate) {
    const Statics s(beam(R"({"revolute": "B", "bodies": [1, 2]})"));
    EXPECT_TRUE(s.forces.balanced);
    EXPECT_EQ(s.forces.indeterminacy, 1);
    for (const auto& action : s.forces.actions) EXPECT_FALSE(action.known);
}

TEST(Forces, CantileverIsClamped) {
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [2, 1]}, "bodies": {"2": ["A", "B"]},
        "joints": [{"weld": "A", "bodies": [2, 1]}],
        "loads": [{"force": "P", "body": 2, "at": "B", "value": [300, -500]}, {"couple": "M", "body": 2,
        "value": 70}]})");
    expect_determined(s);
    expect_force(s.on("A", "2"), -300, 500, 1300 - 70);
    expect_force(s.on("A", "1"), 300, -500, 70 - 1300);
}

TEST(Forces, LeverAndItsThreeParallelForces) {
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "P": [-0.2, 0.03], "Q": [0.5, -0.02]},
        "bodies": {"2": ["P", "O", "Q"]}, "joints": [{"revolute": "O", "bodies": [1, 2]}],
        "drivers": [{"body": 2, "omega": 1}],
        "loads": [{"force": "P", "body": 2, "at": "P", "value": [0, -600]}],
        "effort": {"force": "Q", "body": 2, "at": "Q", "along": -90}})");
    expect_determined(s);
    EXPECT_NEAR(s.effort(), 600 * 0.2 / 0.5, 1e-10);
    expect_force(s.on("O", "2"), 0, 840);
    expect_power_closes(s);
}

TEST(Forces, RotatingBodyOfTheNotes) {
    // 2.3-1: F_1 + R_12 + F_c = 0, and the couple that the moments about O still need.
    const Statics s(
        R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "G": [0.0983, 0.0688], "X": [-0.0434, 0.2462]},
        "bodies": {"2": ["O", "G", "X"]}, "joints": [{"revolute": "O", "bodies": [1, 2]}],
        "drivers": [{"body": 2, "omega": 12}], "masses": {"2": {"mass": 3, "centre": "G", "inertia": 0.1}},
        "inertia forces": true, "loads": [{"force": "F", "body": 2, "at": "X", "value": [40, 0]}],
        "effort": {"couple": "M", "body": 2}})");
    expect_determined(s);
    expect_force(s.on("O", "2"), -40 - 3 * 144 * 0.0983, -3 * 144 * 0.0688);
    EXPECT_NEAR(s.effort(), 40 * 0.2462, 1e-12);
    expect_power_closes(s);
}

TEST(Forces, InertiaCoupleOfASpinningUpDisc) {
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "G": [0.3, 0]}, "bodies": {"2": ["O", "G"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}], "drivers": [{"body": 2, "omega": 2, "alpha": 5}],
        "masses": {"2": {"mass": 4, "centre": "G", "inertia": 0.5}}, "inertia forces": true,
        "effort": {"couple": "M", "body": 2}})");
    expect_determined(s);
    EXPECT_NEAR(s.effort(), (0.5 + 4 * 0.09) * 5, 1e-12);
    expect_force(s.on("O", "2"), -4 * 4 * 0.3, 4 * 5 * 0.3);
    expect_power_closes(s);
}

TEST(Forces, PairOfARollingWheel) {
    // A wheel on level ground pushed at its axle by a force and held by a couple: friction and normal at the contact.
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"C": [0, 0.5], "P": [0, 0]},
        "bodies": {"2": {"points": ["C"], "circle": {"centre": "C", "radius": 0.5}}},
        "joints": [{"rolling": "P", "bodies": [2, 1], "profiles": {"1": {"line": 0}}}],
        "drivers": [{"body": 2, "omega": -2}],
        "masses": {"2": {"mass": 10, "centre": "C"}}, "gravity": [0, -10],
        "loads": [{"force": "F", "body": 2, "at": "C", "value": [30, 0]}], "effort": {"couple": "M", "body": 2}})");
    expect_determined(s);
    expect_force(s.on("P", "2"), -30, 100);
    EXPECT_NEAR(s.effort(), 15, 1e-12);
    expect_power_closes(s);
}

// --- several bodies
// ----------------------------------------------------------------------------------------------------------

std::string slider_crank(const std::string& tail) {
    return R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
        "points": {"O": [0, 0], "A": {"from": "O", "distance": 50, "angle": 60},
                   "B": {"meet": [{"circle": "A", "radius": 150}, {"line": "O", "angle": 0}], "near": [170, 0]}},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
                   {"revolute": "B", "bodies": [3, 4]},
                   {"prismatic": "B", "bodies": [4, 1], "along": 0, "name": "guide"}], )" +
           tail + "}";
}

TEST(Forces, SliderCrankWithGasForce) {
    // v_B = Λ ω, so the crank's couple is M = −F Λ; the connecting rod carries F / cos β, the guide F tan β.
    const Statics s(slider_crank(R"("drivers": [{"body": 2, "omega": 10}],
        "loads": [{"force": "F", "body": 4, "at": "B", "value": [-2000, 0]}], "effort": {"couple": "M", "body": 2})"));
    expect_determined(s);
    const double alpha = 60 * degree;
    const double beta = std::asin(-0.05 * std::sin(alpha) / 0.15);
    const double lambda = -0.05 * (std::sin(alpha) - std::cos(alpha) * std::tan(beta));
    EXPECT_NEAR(s.effort(), 2000 * lambda, 1e-10);
    expect_force(s.on("guide", "4"), 0, -2000 * std::tan(beta));
    EXPECT_NEAR(s.size("A", "3"), 2000 / std::cos(beta), 1e-9);
    expect_power_closes(s);
}

TEST(Forces, ActuatorDrivesTheSlider) {
    // The same mechanism the other way round: a load on the crank, an actuator in the guide (+X on the slider).
    const Statics s(slider_crank(R"("drivers": [{"body": 2, "omega": 10}],
        "loads": [{"couple": "M", "body": 2, "value": 12}], "effort": {"force": "F", "joint": "guide"})"));
    expect_determined(s);
    expect_power_closes(s);
    EXPECT_GT(s.effort(), 0);
}

TEST(Forces, CoupleBetweenTwoMovingBodies) {
    // Knee driven by a couple of 2 on 3: what it gives to 3 it takes from 2.
    const Statics s(slider_crank(R"("drivers": [{"body": 2, "omega": 10}],
        "loads": [{"force": "F", "body": 4, "at": "B", "value": [-2000, 0]}],
        "effort": {"couple": "M", "body": 3, "from": 2})"));
    expect_determined(s);
    expect_power_closes(s);
}

TEST(Forces, CrankWithoutEffortIsNotBalanced) {
    const Statics s(slider_crank(R"("loads": [{"force": "F", "body": 4, "at": "B", "value": [-2000, 0]}])"));
    EXPECT_FALSE(s.forces.balanced);
    EXPECT_GT(s.forces.residual, 1e-3);
    EXPECT_EQ(s.forces.indeterminacy, 0);
}

TEST(Forces, LockedPositionHoldsNothing) {
    // At the dead point the rods hold the gas force by themselves: the crank's couple is zero, and determined.
    const Statics held(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": [0.05, 0], "B": [0.2, 0]},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
        "bodies": [3, 4]},
                   {"prismatic": "B", "bodies": [4, 1], "along": 0, "name": "guide"}],
        "loads": [{"force": "F", "body": 4, "at": "B", "value": [-2000, 0]}], "effort": {"couple": "M", "body": 2}})");
    expect_determined(held);
    EXPECT_NEAR(held.effort(), 0, 1e-10);
    // The other way, no force on the slider balances a couple on the crank.
    const Statics locked(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": [0.05, 0], "B": [0.2, 0]},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
        "bodies": [3, 4]},
                   {"prismatic": "B", "bodies": [4, 1], "along": 0, "name": "guide"}],
        "loads": [{"couple": "M", "body": 2, "value": 12}], "effort": {"force": "F", "joint": "guide"}})");
    EXPECT_FALSE(locked.forces.balanced);
    EXPECT_FALSE(locked.forces.effort_known.at(0));
}

TEST(Forces, SpringPullsTogether) {
    // Two cranks held by one spring and two couples.
    const Statics s(
        R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "P": [0, 0.1], "B": [0.4, 0], "Q": [0.4, 0.4]},
        "bodies": {"2": ["A", "P"], "3": ["B", "Q"]},
        "joints": [{"revolute": "A", "bodies": [1, 2]}, {"revolute": "B", "bodies": [1, 3]}],
        "drivers": [{"body": 2, "omega": 3}, {"body": 3, "omega": 2}],
        "loads": [{"force": "S", "bodies": [2, 3], "between": ["P", "Q"], "magnitude": 50}],
        "effort": [{"couple": "M2", "body": 2}, {"couple": "M3", "body": 3}]})");
    expect_determined(s);
    expect_force(s.on("A", "2"), -40, -30);
    expect_force(s.on("B", "3"), 40, 30);
    EXPECT_NEAR(s.effort(0), 0.1 * 40, 1e-12);
    EXPECT_NEAR(s.effort(1), -0.4 * 40, 1e-12);
    expect_power_closes(s);
}

TEST(Forces, PinOfThreeBodiesIsInEquilibrium) {
    // A triangle truss on the frame: bars 2 and 3 meet the bar 4 at one pin, whose other end carries a load.
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [0, 1], "C": [1, 0], "D": [2, 0]},
        "bodies": {"2": ["A", "C"], "3": ["B", "C"], "4": ["C", "D"]},
        "joints": [{"revolute": "A", "bodies": [1, 2]}, {"revolute": "B", "bodies": [1, 3]},
                   {"revolute": "C", "bodies": [2, 3, 4]}, {"contact": "D", "bodies": [4, 1], "tangent": 0}],
        "loads": [{"force": "F", "body": 4, "at": "D", "value": [500, -200]}]})");
    expect_determined(s);
    expect_force(s.on("C", "4"), -500, 0);
    expect_force(s.on("C", "3"), 0, 0);
    expect_force(s.on("C", "2"), 500, 0);
    expect_force(s.on("D", "4"), 0, 200);
    EXPECT_EQ(s.on("C", "4").from, none);
}

TEST(Forces, FrameCountsAtAPinOfThree) {
    // Two arms hang on one pin of the frame; each brings its weight, the pin gives both to the frame.
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "P": [1, 0], "Q": [-2, 0]},
        "bodies": {"2": ["O", "P"], "3": ["O", "Q"]}, "joints": [{"revolute": "O", "bodies": [1, 2, 3]}],
        "masses": {"2": {"mass": 1, "centre": "P"}, "3": {"mass": 2, "centre": "Q"}}, "gravity": [0, -10],
        "effort": [{"couple": "M2", "body": 2}, {"couple": "M3", "body": 3}]})");
    expect_determined(s);
    expect_force(s.on("O", "1"), 0, -30);
    expect_force(s.on("O", "2"), 0, 10);
    expect_force(s.on("O", "3"), 0, 20);
    EXPECT_NEAR(s.effort(0), 10, 1e-12);
    EXPECT_NEAR(s.effort(1), -40, 1e-12);
}

TEST(Forces, KnownBesideAnIndeterminatePart) {
    // Bar 3 hangs on body 2, which is clamped twice over: what 3 gives to 2 is known, how the clamps share it is not.
    const Statics s(
        R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [4, 0], "C": [2, 1], "D": [2, 3], "E": [3, 3]},
        "bodies": {"2": ["A", "B", "C", "D"], "3": ["C", "D", "E"]},
        "joints": [{"revolute": "A", "bodies": [1, 2]}, {"revolute": "B", "bodies": [1, 2]}, {"revolute": "C",
        "bodies": [2, 3]},
                   {"contact": "D", "bodies": [3, 2], "tangent": 90}],
        "loads": [{"force": "F", "body": 3, "at": "E", "value": [0, -100]}]})");
    EXPECT_TRUE(s.forces.balanced);
    EXPECT_EQ(s.forces.indeterminacy, 1);
    expect_force(s.on("D", "3"), -50, 0);
    expect_force(s.on("C", "3"), 50, 100);
    EXPECT_FALSE(s.on("A", "2").known);
    EXPECT_FALSE(s.on("B", "1").known);
}

TEST(Forces, KnownBesideAnUnbalancedPart) {
    // A loaded crank that nothing holds says nothing of the beam beside it, which is at rest.
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"A": [0, 0], "B": [4, 0], "P": [1, 0], "O": [6, 0]},
        "bodies": {"2": ["A", "P", "B"], "3": ["O"]},
        "joints": [{"revolute": "A", "bodies": [1, 2]}, {"contact": "B", "bodies": [2, 1], "tangent": 0},
                   {"revolute": "O", "bodies": [1, 3]}],
        "loads": [{"force": "F", "body": 2, "at": "P", "value": [0, -100]}, {"couple": "M", "body": 3, "value": 5}]})");
    EXPECT_FALSE(s.forces.balanced);
    expect_force(s.on("B", "2"), 0, 25);
    expect_force(s.on("A", "2"), 0, 75);
    EXPECT_FALSE(s.on("O", "3").known);
}

TEST(Forces, InertiaOfAMotionThatNobodyKnows) {
    const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "G": [0.3, 0]}, "bodies": {"2": ["O", "G"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}], "masses": {"2": {"mass": 4, "centre": "G"}},
        "inertia forces": true,
        "effort": {"couple": "M", "body": 2}})");
    EXPECT_FALSE(s.on("O", "2").known);
    EXPECT_FALSE(s.forces.effort_known.at(0));
}

TEST(Forces, NothingLoadsTheMechanism) {
    const Statics s(slider_crank(R"("effort": {"couple": "M", "body": 2})"));
    expect_determined(s);
    for (const auto& action : s.forces.actions) EXPECT_EQ(action.force, (std::array<double, 2>{}));
    EXPECT_EQ(s.effort(), 0);
}

TEST(Forces, PinInASlotIsPushedAcrossIt) {
    const Statics s(R"({"kinegraph": 1, "frame": 1,
        "points": {"O2": [0, 0], "O4": [0, -0.15], "A": {"from": "O2", "distance": 0.06, "angle": 30}},
        "bodies": {"2": ["O2", "A"], "4": ["O4", "A"]},
        "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "O4", "bodies": [1, 4]},
                   {"pin-slot": "A", "bodies": [2, 4], "along": ["O4", "A"]}],
        "drivers": [{"body": 2, "omega": 5}], "loads": [{"couple": "L", "body": 4, "value": -20}],
        "effort": {"couple": "M", "body": 2}})");
    expect_determined(s);
    const auto action = s.on("A", "4");
    const double x = 0.06 * std::cos(30 * degree);
    const double y = 0.06 * std::sin(30 * degree) + 0.15;
    EXPECT_NEAR(action.force[0] * x + action.force[1] * y, 0, 1e-12);
    EXPECT_NEAR(std::hypot(action.force[0], action.force[1]), 20 / std::hypot(x, y), 1e-10);
    expect_power_closes(s);
}

TEST(Forces, FourBarWithWeightsAndInertia) {
    const std::string text = R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
        "points": {"O2": [0, 0], "A": {"from": "O2", "distance": 40, "angle": 60}, "O4": [150, 0],
                   "B": {"meet": [{"circle": "A", "radius": 150}, {"circle": "O4", "radius": 80}], "side": "left"},
                   "G2": {"from": "O2", "to": "A", "ratio": 0.5}, "G4": {"from": "O4", "to": "B", "ratio": 0.5},
                   "G3": {"from": "A", "distance": 70, "angle": 10, "relative to": ["A", "B"]}},
        "bodies": {"2": ["O2", "A", "G2"], "3": ["A", "B", "G3"], "4": ["O4", "B", "G4"]},
        "joints": [{"revolute": "O2", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
                   {"revolute": "B", "bodies": [3, 4]}, {"revolute": "O4", "bodies": [1, 4]}],
        "drivers": [{"body": 2, "omega": -10, "alpha": 30}],
        "masses": {"2": {"mass": 0.8, "centre": "G2", "inertia": 0.00012}, "3": {"mass": 2, "centre": "G3",
        "inertia": 0.004},
                   "4": {"mass": 1.5, "centre": "G4", "inertia": 0.0009}},
        "gravity": [0, -9.81], "effort": {"couple": "M", "body": 2})";
    for (const char* tail : {"}", R"(, "inertia forces": true})"}) {
        const Statics s(text + tail);
        expect_determined(s);
        expect_power_closes(s);
        // The weights (and inertia) pass to the frame whole.
        double down = 4.3 * 9.81;
        for (const Mass& mass : s.mechanism.masses) {
            if (!s.mechanism.inertia_forces) continue;
            down += mass.mass.to_double() * s.motion.acceleration(mass.body, s.pose.at(mass.centre))[1];
        }
        EXPECT_NEAR(s.on("O2", "1").force[1] + s.on("O4", "1").force[1], -down, 1e-11);
    }
}

// --- gears
// -------------------------------------------------------------------------------------------------------------------

/// Pinion 2 turned by a couple M; body 3 holds. The tangential force on the pinion is −M/r, the radial one tan 20° of
/// it and away from the mate, whichever way M turns and in whatever order the bodies are named.
void expect_teeth_push(const std::string& points, const std::string& mate, const std::string& joints,
                       const std::string& effort, std::array<double, 2> tangential, std::array<double, 2> into_pinion) {
    for (const char* couple : {"3", "-3"}) {
        for (const char* order : {"[2, 3]", "[3, 2]"}) {
            const Statics s(R"({"kinegraph": 1, "frame": 1, "points": {)" + points + R"(}, "bodies":
                {"2": {"points": ["C"], "circle": {"centre": "C", "radius": 0.02}}, "3": )" +
                            mate + R"(}, "joints": [{"revolute": "C", "bodies": [1, 2]}, )" + joints + R"("bodies": )" +
                            order +
                            R"(, "pressure angle": 20}], "drivers": [{"body": 2, "omega": 7}],
                "loads": [{"couple": "M", "body": 2, "value": )" +
                            couple + R"(}], "effort": )" + effort + "}");
            expect_determined(s);
            expect_power_closes(s);
            const double t = std::stod(couple) / 0.02;
            const double r = std::abs(t) * std::tan(20 * degree);
            expect_force(s.on("P", "2"), t * tangential[0] + r * into_pinion[0],
                         t * tangential[1] + r * into_pinion[1]);
        }
    }
}

TEST(ForcesOfGears, TwoWheelsPushEachOtherApart) {
    expect_teeth_push(R"("C": [0, 0], "P": [0.02, 0], "D": [0.08, 0])",
                      R"({"points": ["D"], "circle": {"centre": "D", "radius": 0.06}})",
                      R"({"revolute": "D", "bodies": [1, 3]}, {"gear": "P", )", R"({"couple": "E", "body": 3})",
                      {0, -1}, {-1, 0});
}
TEST(ForcesOfGears, RingPushesThePinionInwards) {
    expect_teeth_push(R"("C": [0.04, 0], "P": [0.06, 0], "D": [0, 0])",
                      R"({"points": ["D"], "circle": {"centre": "D", "radius": 0.06}})",
                      R"({"revolute": "D", "bodies": [1, 3]}, {"gear": "P", )", R"({"couple": "E", "body": 3})",
                      {0, -1}, {-1, 0});
}
TEST(ForcesOfGears, RackPushesThePinionOff) {
    expect_teeth_push(
        R"("C": [0, 0.02], "P": [0, 0], "Q": [0.1, -0.01])", R"(["Q"])",
        R"({"prismatic": "Q", "bodies": [3, 1], "along": 0}, {"gear": "P", "profiles": {"3": {"line": 0}}, )",
        R"({"force": "E", "joint": "Q"})", {-1, 0}, {0, 1});
}

TEST(ForcesOfGears, PlanetaryGear) {
    // Sun 2 (r = 20), planet 3 (r = 10) on the arm 4, ring = frame (r = 40): ω_4 = ω_2 / 3, so M_2 = −M_4 / 3. The
    // planet's tooth forces are equal along the tangent and add up to the pin's.
    const Statics s(R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
        "points": {"O": [0, 0], "C": [30, 0], "P": [20, 0], "R": [40, 0]},
        "bodies": {"1": {"points": [], "circle": {"centre": "O", "radius": 40}},
                   "2": {"points": ["O"], "circle": {"centre": "O", "radius": 20}},
                   "3": {"points": ["C"], "circle": {"centre": "C", "radius": 10}}, "4": ["O", "C"]},
        "joints": [{"revolute": "O", "bodies": [1, 2], "name": "sun"}, {"revolute": "O", "bodies": [1, 4],
        "name": "arm"},
                   {"revolute": "C", "bodies": [3, 4]}, {"gear": "P", "bodies": [2, 3], "pressure angle": 20, "arm": 4},
                   {"gear": "R", "bodies": [3, 1], "pressure angle": 20, "arm": 4}],
        "drivers": [{"body": 2, "omega": 30}], "loads": [{"couple": "L", "body": 4, "value": -90}],
        "effort": {"couple": "M", "body": 2}})");
    expect_determined(s);
    expect_power_closes(s);
    EXPECT_NEAR(s.effort(), 30, 1e-11);
    const double t = 30 / 0.02;
    expect_force(s.on("P", "2"), -t * std::tan(20 * degree), -t);
    expect_force(s.on("R", "3"), -t * std::tan(20 * degree), t);
    expect_force(s.on("C", "4"), 0, 2 * t);
}

// --- the notes
// ---------------------------------------------------------------------------------------------------------------

/// Mirrored x → −x: points given by coordinates, directions by vectors or points, loads by components.
Mechanism mirrored(Mechanism m) {
    const auto turn = [](Vector& v) { v.x = -v.x; };
    for (NamedPoint& point : m.points) {
        if (auto* at = std::get_if<Coordinates>(&point.placement)) turn(at->at);
    }
    for (Joint& joint : m.joints) {
        if (!joint.along) continue;
        if (auto* v = std::get_if<Vector>(&joint.along->form)) turn(*v);
    }
    for (Load& load : m.loads) {
        if (auto* force = std::get_if<ForceLoad>(&load); force != nullptr && force->value) turn(*force->value);
    }
    return m;
}
void expect_mirrored(const Statics& s) {
    const Statics m(mirrored(s.mechanism));
    expect_determined(m);
    double largest = 0;
    for (const auto& action : s.forces.actions)
        largest = std::max({largest, std::abs(action.force[0]), std::abs(action.force[1])});
    ASSERT_EQ(m.forces.actions.size(), s.forces.actions.size());
    for (std::size_t i = 0; i < s.forces.actions.size(); ++i) {
        EXPECT_NEAR(m.forces.actions[i].force[0], -s.forces.actions[i].force[0], 1e-13 * largest);
        EXPECT_NEAR(m.forces.actions[i].force[1], s.forces.actions[i].force[1], 1e-13 * largest);
        EXPECT_NEAR(m.forces.actions[i].couple, -s.forces.actions[i].couple, 1e-13 * largest);
    }
    for (std::size_t i = 0; i < s.forces.efforts.size(); ++i)
        EXPECT_NEAR(m.effort(i), s.effort(i), 1e-13 * largest);  // actuators: along their guide
}

TEST(ForcesOfTheNotes, SluiceGate) {
    const Statics s(
        R"({"kinegraph": 1, "points": {"A": [0, 0], "O": [-10, -1], "C": [-12.1296, 1.6254], "D": [-7.4445, 11.5778],
            "E": [-5.9445, 16.0778], "B": [1.5512, 7.3510], "F": [2.2649, 12.3892]},
        "bodies": {"1": ["A", "C", "O"], "2": ["C", "D"], "3": ["B", "D", "E"], "4": ["E", "F"], "5": ["F"]},
        "joints": [{"revolute": "A", "bodies": [0, 1]}, {"revolute": "C", "bodies": [1, 2]}, {"revolute": "D",
        "bodies": [2, 3]},
                   {"revolute": "B", "bodies": [0, 3]}, {"revolute": "E", "bodies": [3, 4]}, {"revolute": "F",
                   "bodies": [4, 5]},
                   {"prismatic": "F", "bodies": [5, 0], "along": [-0.38212, 0.92411], "name": "G"}],
        "drivers": [{"joint": "G", "speed": 0.01}],
        "masses": {"1": {"mass": 1.66e6, "centre": "O"}}, "gravity": [0, -9.81], "effort": {"force": "F_G",
        "joint": "G"}})");
    expect_determined(s);
    expect_power_closes(s);
    const double millimetre = 1.66e6 * 9.81 / 14;
    struct Row {
        const char* joint;
        const char* on;
        double notes, geometry, digit;
    };
    for (const Row& row : {Row{"A", "1", 6, 6.0, 0.05}, Row{"C", "1", 12, 12.0, 0.05}, Row{"D", "2", 12, 12.0, 0.05},
                           Row{"E", "3", 24, 24.4, 0.05}, Row{"F", "4", 24, 24.4, 0.05}, Row{"B", "3", 27, 27.0, 0.05},
                           Row{"G", "5", 17, 16.75, 0.005}}) {
        EXPECT_NEAR(s.size(row.joint, row.on) / millimetre, row.notes, 0.5) << row.joint;
        EXPECT_NEAR(s.size(row.joint, row.on) / millimetre, row.geometry, row.digit) << row.joint;
    }
    EXPECT_NEAR(-s.effort() / millimetre, 17.75, 0.005);  // down along the guide
    EXPECT_NEAR(s.on("G", "5").couple, 0, 1e-6);          // all forces on the piston pass through F
    expect_mirrored(s);
}

TEST(ForcesOfTheNotes, Tipper) {
    const Statics s(
        R"({"kinegraph": 1, "points": {"A": [0, 0], "F": [2.4432, 0.88925], "O": [1.8794, 1.4840], "B": [1.1, -0.55],
            "E": [1.75, -0.05], "C": [3.2, -0.75], "D": {"from": "C", "to": "E", "ratio": 0.5}},
        "bodies": {"1": ["A", "F", "O"], "2": ["C", "D"], "3": ["D", "E"], "4": ["B", "E", "F"]},
        "joints": [{"revolute": "A", "bodies": [0, 1]}, {"revolute": "B", "bodies": [0, 4]}, {"revolute": "E",
        "bodies": [3, 4]},
                   {"contact": "F", "bodies": [1, 4], "profiles": {"1": {"line": ["A", "F"]}, "4": {"tip": true}},
                    "pushes": [0, 1]},
                   {"prismatic": "D", "bodies": [3, 2], "along": ["C", "E"]}, {"revolute": "C", "bodies": [0, 2]}],
        "drivers": [{"joint": "D", "speed": 0.1}],
        "masses": {"1": {"mass": 9000, "centre": "O"}}, "gravity": [0, -9.81], "effort": {"force": "F_p",
        "joint": "D"}})");
    expect_determined(s);
    expect_power_closes(s);
    const double weight = 9000 * 9.81;
    // Box: moments about A give R_41; 2 and 3 together carry two forces, so the sleeve carries nothing.
    EXPECT_NEAR(s.size("F", "1"), weight * 1.8794 / std::hypot(2.4432, 0.88925), 1e-9 * weight);
    EXPECT_NEAR(s.size("D", "3"), 0, 1e-12 * weight);
    EXPECT_NEAR(s.on("D", "3").couple, 0, 1e-12 * weight);
    EXPECT_NEAR(s.effort(), s.size("E", "3"), 1e-12 * weight);
    EXPECT_NEAR(s.effort(), 152783.08341, 1e-3);
    EXPECT_GT(s.on("F", "1").force[1], 0);
    expect_mirrored(s);
}

TEST(ForcesOfTheNotes, ExamOf2001) {
    const Statics s(R"({"kinegraph": 1, "points": {"O2": [0, 0], "B": [0, 0.15],
            "C": {"from": "B", "distance": 0.75, "angle": 210}, "A": {"from": "B", "to": "C", "distance": 0.4632647},
            "O1": {"from": "A", "distance": 0.318, "angle": 0}, "D": {"from": "B", "to": "C", "distance": 0.58},
            "M": {"from": "C", "distance": 0.12, "angle": 180}},
        "bodies": {"1": ["O1", "A"], "2": ["A", "D"], "3": ["O2", "B"], "4": ["B", "C", "A", "D"], "5": ["C", "M"]},
        "joints": [{"revolute": "O1", "bodies": [0, 1]}, {"revolute": "A", "bodies": [1, 2]},
                   {"prismatic": "D", "bodies": [2, 4], "along": ["B", "C"]}, {"revolute": "O2", "bodies": [0, 3]},
                   {"revolute": "B", "bodies": [3, 4]}, {"revolute": "C", "bodies": [4, 5]},
                   {"prismatic": "M", "bodies": [5, 0], "along": 0}],
        "drivers": [{"body": 1, "omega": -1}], "masses": {"5": {"mass": 10, "centre": "M"}}, "gravity": [0, -9.81],
        "inertia forces": true, "effort": {"couple": "C", "body": 1}})");
    expect_determined(s);
    expect_power_closes(s);
    EXPECT_NEAR(s.size("A", "1"), 29.3536, 5e-5);
    EXPECT_NEAR(s.size("D", "2"), 29.3536, 5e-5);
    EXPECT_NEAR(s.effort(), -8.0839, 5e-5);
    // Body 3 carries two forces, along BO2; body 2 two, ⟂ BC through A.
    EXPECT_NEAR(s.on("B", "3").force[0], 0, 1e-12);
    const auto action = s.on("A", "2");
    EXPECT_NEAR(action.force[0] * std::cos(30 * degree) + action.force[1] * std::sin(30 * degree), 0, 1e-12);
    EXPECT_NEAR(std::abs(s.on("D", "2").couple), 29.3536 * (0.58 - 0.4632647), 1e-4);
}

}  // namespace
}  // namespace kinegraph::check_forces_test
