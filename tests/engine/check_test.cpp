// The numeric check: closed forms, derivatives of drawn positions for every kind of pair, and what is not determined.
#include "engine/check/check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/support/sketch.hpp"

namespace kinegraph::check_test {
namespace {

using namespace sketch;
constexpr double degree = 3.14159265358979323846 / 180;

Pose drawn(const Sketch& sketch, int bits = 100) {
    auto pose = draw_pose(sketch.mechanism, bits);
    if (!pose) {
        ADD_FAILURE() << pose.error().front().where << ": " << pose.error().front().message.in(Language::en);
        return {};
    }
    return *std::move(pose);
}
NumericMotion motion_of(const Sketch& sketch) { return check_motion(sketch.mechanism, drawn(sketch)); }

void expect_near(const std::array<double, 2>& a, double x, double y, double tolerance, const std::string& what = {}) {
    EXPECT_NEAR(a[0], x, tolerance) << what;
    EXPECT_NEAR(a[1], y, tolerance) << what;
}

// --- derivatives of drawn positions
// --------------------------------------------------------------------------------------------

/// A mechanism drawn at any value of its driven coordinate, and the points to follow on their bodies.
struct Moving {
    std::function<Sketch(const Exact&)> at;
    std::vector<std::pair<std::string, std::string>> follow;  ///< body, point
};

/// Draws the mechanism a moment before and after, with q = q0 + speed·t + acceleration·t²/2, on 300 bits, so that the
/// differences lose nothing; what is left is their own error, of the order of the moment squared.
void expect_derivatives(const Moving& moving, const char* q0, const char* speed, const char* acceleration) {
    const Exact moment = Exact::ratio(1, 10'000'000);
    const auto at_time = [&](const Exact& t) {
        return drawn(moving.at(decimal(q0) + decimal(speed) * t + decimal(acceleration) * t * t / 2), 300);
    };
    Sketch now = moving.at(decimal(q0));
    const Pose pose = drawn(now);
    const Pose before = at_time(-moment);
    const Pose after = at_time(moment);
    const Pose here = at_time(0);
    const NumericMotion motion = check_motion(now.mechanism, pose);
    for (const auto& [body, point] : moving.follow) {
        const PointIndex p = now[point];
        const BodyIndex b = now.body(body);
        const Vector v = Exact::ratio(1, 2) / moment * (after.at(p) - before.at(p));
        const Vector a = 1 / square(moment) * (after.at(p) - 2 * here.at(p) + before.at(p));
        const std::string what = "point " + point + " of body " + body;
        EXPECT_TRUE(motion.bodies[at_index(b)].acceleration_known) << what;
        expect_near(motion.velocity(b, pose.at(p)), v.x.to_double(), v.y.to_double(), 1e-10, "velocity of " + what);
        expect_near(motion.acceleration(b, pose.at(p)), a.x.to_double(), a.y.to_double(), 1e-9,
                    "acceleration of " + what);
    }
}

void polar(Sketch& s, const std::string& name, const std::string& from, const char* distance,
           const Exact& angle_in_radians) {
    s.point(name, Polar{s[from], decimal(distance), Angle{angle_in_radians, false}, {}});
}
void polar_from_line(Sketch& s, const std::string& name, const std::string& from, const char* distance,
                     const char* angle, const std::string& p, const std::string& q) {
    s.point(name, Polar{s[from], decimal(distance), degrees(angle), Bearing::Between{s[p], s[q]}});
}

TEST(Derivative, FourBarWithCouplerPoint) {
    const auto four_bar = [](const Exact& q) {
        Sketch s;
        s.point("O2", "0", "0").point("O4", "0.15", "0.01");
        polar(s, "A", "O2", "0.04", q);
        s.meet("B", s.circle("A", "0.15"), s.circle("O4", "0.08"), Meet::Side::left);
        polar_from_line(s, "E", "A", "0.07", "33", "A", "B");
        s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
        return s.spin("2", "-3", "7");
    };
    expect_derivatives({four_bar, {{"2", "A"}, {"3", "A"}, {"3", "B"}, {"4", "B"}, {"3", "E"}}}, "0.9", "-3", "7");
}

TEST(Derivative, SliderCrankOnAnInclinedGuide) {
    const auto slider_crank = [](const Exact& q) {
        Sketch s;
        s.point("O", "0", "0").point("G", "0.02", "-0.03");
        polar(s, "A", "O", "0.1", q);
        s.meet("B", s.circle("A", "0.35"), s.line("G", "17"), Meet::Side::right);
        s.revolute("O", {"1", "2"})
            .revolute("A", {"2", "3"})
            .revolute("B", {"3", "4"})
            .prismatic("B", {"4", "1"}, at_angle("17"));
        return s.spin("2", "5", "-2");
    };
    expect_derivatives({slider_crank, {{"2", "A"}, {"3", "A"}, {"3", "B"}, {"4", "B"}}}, "2.1", "5", "-2");
}

/// Crank 2 about O2, its pin A; body 4 about O4 guides A along O4A, by a sleeve or by a slot. E marks body 4.
Sketch quick_return(const Exact& q, bool sleeve) {
    Sketch s;
    s.point("O2", "0", "0").point("O4", "0.02", "-0.2");
    polar(s, "A", "O2", "0.08", q);
    polar_from_line(s, "E", "O4", "0.3", "5", "O4", "A");
    s.revolute("O2", {"1", "2"}).revolute("O4", {"1", "4"});
    if (sleeve) {
        s.revolute("A", {"2", "3"}).prismatic("A", {"3", "4"}, s.between("O4", "A"));
    } else {
        s.pin_slot("A", {"2", "4"}, s.between("O4", "A"));
    }
    return s.spin("2", "4", "1");
}

TEST(Derivative, SleeveOnATurningGuide) {
    expect_derivatives({[](const Exact& q) { return quick_return(q, true); }, {{"2", "A"}, {"3", "A"}, {"4", "E"}}},
                       "0.4", "4", "1");
}
TEST(Derivative, PinInATurningSlot) {
    expect_derivatives({[](const Exact& q) { return quick_return(q, false); }, {{"2", "A"}, {"4", "E"}}}, "0.4", "4",
                       "1");
}

TEST(Derivative, PinInATurningCurvedSlot) {
    const auto curved = [](const Exact& q) {
        Sketch s;
        s.point("O2", "0", "0").point("O4", "0.2", "0.05");
        polar(s, "A", "O2", "0.06", q);
        s.meet("C", s.circle("A", "0.12"), s.circle("O4", "0.15"), Meet::Side::left);
        s.revolute("O2", {"1", "2"}).revolute("O4", {"1", "4"}).pin_arc("A", {"2", "4"}, "C");
        s.mechanism.bodies[2].points.push_back(s["C"]);
        return s.spin("2", "3", "2");
    };
    expect_derivatives({curved, {{"2", "A"}, {"4", "C"}}}, "0.7", "3", "2");
}

TEST(Derivative, DiscRollingOnALine) {
    const auto disc = [](const Exact& q) {  // q: the disc's turn, clockwise; x = R q
        Sketch s;
        s.point("C", Coordinates{{decimal("0.25") * q, decimal("0.25")}})
            .point("P", Coordinates{{decimal("0.25") * q, 0}});
        polar(s, "M", "C", "0.2", -q);
        s.touching(JointKind::rolling, "P", {"2", "1"}, {CircleProfile{s["C"]}, LineProfile{at_angle("0")}});
        s.mechanism.bodies[1].points.push_back(s["C"]);
        return s.spin("2", "-2", "-3");
    };
    expect_derivatives({disc, {{"2", "C"}, {"2", "M"}}}, "0.3", "2", "3");
}

/// A disc of radius 0.1 rolls on a fixed circle of radius 0.3, outside or inside, led by an arm.
Sketch planet(const Exact& q, bool outside) {
    Sketch s;
    s.point("O", "0", "0");
    polar(s, "C", "O", outside ? "0.4" : "0.2", q);
    s.point("P", Along{s["O"], s["C"], decimal("0.3"), false});
    polar(s, "M", "C", "0.05", (outside ? 4 : -2) * q);
    s.revolute("O", {"1", "2"}).revolute("C", {"2", "3"});
    s.touching(JointKind::rolling, "P", {"3", "1"}, {CircleProfile{s["C"]}, CircleProfile{s["O"]}});
    return s.spin("2", "1.5", "0.5");
}
TEST(Derivative, DiscRollingOutsideACircle) {
    expect_derivatives({[](const Exact& q) { return planet(q, true); }, {{"2", "C"}, {"3", "M"}}}, "0.3", "1.5", "0.5");
}
TEST(Derivative, DiscRollingInsideACircle) {
    expect_derivatives({[](const Exact& q) { return planet(q, false); }, {{"2", "C"}, {"3", "M"}}}, "0.3", "1.5",
                       "0.5");
}

TEST(Derivative, BarRollingOnACircle) {
    for (const bool bar_first : {true, false}) {
        const auto bar = [&](const Exact& q) {  // unwinds from a circle of radius 0.2, tangent to it at the angle q
            Sketch s;
            s.point("O", "0", "0");
            polar(s, "P", "O", "0.2", q);
            const Bearing::Between outwards{s["O"], s["P"]};
            s.point("M", Polar{s["P"], decimal("0.5") - decimal("0.2") * q, degrees("90"), outwards});
            s.point("N", Polar{s["M"], decimal("0.1"), degrees("0"), outwards});
            const Profile straight = LineProfile{s.between("P", "M")};
            const Profile round = CircleProfile{s["O"]};
            if (bar_first) {
                s.body("2");
                s.touching(JointKind::rolling, "P", {"2", "1"}, {straight, round});
            } else {
                s.touching(JointKind::rolling, "P", {"1", "2"}, {round, straight});
            }
            return s.spin("2", "2", "3");
        };
        expect_derivatives({bar, {{"2", "M"}, {"2", "N"}}}, "0.3", "2", "3");
    }
}

/// An eccentric turning about O under a follower that slides upwards: flat, or a knife edge.
Sketch cam(const Exact& q, bool flat, bool follower_first = true) {
    Sketch s;
    s.point("O", "0", "0");
    polar(s, "C", "O", "0.02", q);
    s.revolute("O", {"1", "2"});
    const LineCurve path{at("0.005", "0"), LineCurve::By::angle, degrees("90"), none, {}};
    if (flat) {
        s.polar("P", "C", "0.05", "90").meet("F", s.line("P", "0"), path);
    } else {
        s.meet("P", s.circle("C", "0.05"), path, Meet::Side::right).point("F", Along{s["P"], s["O"], 0, true});
    }
    s.prismatic("F", {"3", "1"}, at_angle("90"));
    const Profile follower = flat ? Profile(LineProfile{at_angle("0")}) : Profile(TipProfile{});
    if (follower_first) {
        s.touching(JointKind::contact, "P", {"3", "2"}, {follower, CircleProfile{s["C"]}});
    } else {
        s.touching(JointKind::contact, "P", {"2", "3"}, {CircleProfile{s["C"]}, follower});
    }
    return s.spin("2", "6", "3");
}
TEST(Derivative, EccentricUnderAFlatFollower) {
    for (const bool first : {true, false}) {
        expect_derivatives({[&](const Exact& q) { return cam(q, true, first); }, {{"2", "C"}, {"3", "F"}}}, "0.8", "6",
                           "3");
    }
}
TEST(Derivative, EccentricUnderAKnifeEdge) {
    for (const bool first : {true, false}) {
        expect_derivatives({[&](const Exact& q) { return cam(q, false, first); }, {{"2", "C"}, {"3", "F"}}}, "0.8", "6",
                           "3");
    }
}

TEST(Derivative, EccentricOnARoundedOscillatingFollower) {
    const auto rounded_follower = [](const Exact& q) {
        Sketch s;
        s.point("O", "0", "0").point("O3", "0.2", "0.02");
        polar(s, "C", "O", "0.02", q);
        s.meet("D", s.circle("C", "0.08"), s.circle("O3", "0.18"), Meet::Side::left)
            .point("P", Along{s["C"], s["D"], decimal("0.05"), false});
        s.revolute("O", {"1", "2"}).revolute("O3", {"1", "3"});
        s.touching(JointKind::contact, "P", {"2", "3"}, {CircleProfile{s["C"]}, CircleProfile{s["D"]}});
        return s.spin("2", "6", "3");
    };
    expect_derivatives({rounded_follower, {{"2", "C"}, {"3", "D"}}}, "0.8", "6", "3");
}

/// A turning flat on body 2 about O lifts a round-nosed follower: the straight profile turns.
TEST(Derivative, TurningFlatUnderARoundNose) {
    const auto flat = [](const Exact& q) {
        Sketch s;
        s.point("O", "0", "0");
        polar(s, "U", "O", "1", q);
        polar_from_line(s, "V", "O", "0.03", "90", "O", "U");  // the nose's centre runs 0.03 above the flat through O
        const LineCurve path{at("0.1", "0"), LineCurve::By::angle, degrees("90"), none, {}};
        s.meet("D", LineCurve{s["V"], LineCurve::By::parallel, {}, none, s.between("O", "U")}, path);
        s.meet("P", s.line_to("O", "U"),
               LineCurve{s["D"], LineCurve::By::perpendicular, {}, none, s.between("O", "U")});
        s.revolute("O", {"1", "2"}).prismatic("D", {"3", "1"}, at_angle("90"));
        s.touching(JointKind::contact, "P", {"3", "2"}, {CircleProfile{s["D"]}, LineProfile{s.between("O", "U")}});
        return s.spin("2", "2", "-1");
    };
    expect_derivatives({flat, {{"2", "U"}, {"3", "D"}}}, "0.4", "2", "-1");
}

/// Planet gear 3 on the arm 4 around the turning sun 2.
TEST(Derivative, PlanetaryGear) {
    const auto train =
        [](const Exact& q) {  // the arm turns by q, the sun by −2q: the planet by q − (−2q − q)·0.3/0.1 = 10q
            Sketch s;
            s.point("O", "0", "0");
            polar(s, "C", "O", "0.4", q);
            s.point("P", Along{s["O"], s["C"], Exact::ratio(3, 4), true});
            polar(s, "M", "C", "0.05", 10 * q);
            polar(s, "N", "O", "0.2", -2 * q);
            s.revolute("O", {"1", "2"}).revolute("O", {"1", "4"}).revolute("C", {"3", "4"});
            s.touching(JointKind::gear, "P", {"2", "3"}, {CircleProfile{s["O"]}, CircleProfile{s["C"]}});
            s.mechanism.joints.back().arm = s.body("4");
            return s.spin("4", "1.5", "0.5").spin("2", "-3", "-1");
        };
    expect_derivatives({train, {{"2", "N"}, {"4", "C"}, {"3", "M"}}}, "0.3", "1.5", "0.5");
}

TEST(Derivative, PinionOnARack) {
    const auto rack = [](const Exact& q) {
        Sketch s;
        s.point("C", "0", "0").point("P", "0", "-0.1").point("R", Coordinates{{decimal("0.1") * q, decimal("-0.2")}});
        polar(s, "M", "C", "0.05", q);
        s.revolute("C", {"1", "2"}).prismatic("R", {"3", "1"}, at_angle("0"));
        s.touching(JointKind::gear, "P", {"2", "3"}, {CircleProfile{s["C"]}, LineProfile{at_angle("0")}});
        return s.spin("2", "2", "5");
    };
    expect_derivatives({rack, {{"2", "M"}, {"3", "R"}}}, "0.3", "2", "5");
}

TEST(Derivative, CylinderBetweenTwoTurningBodies) {
    // A sleeve driven along its turning guide: piston 3 in cylinder 4 about O4, pushing the crank 2.
    const auto cylinder = [](const Exact& q) {
        Sketch s;
        s.point("O2", "0", "0").point("O4", "0.3", "0");
        s.meet("A", CircleCurve{s["O2"], decimal("0.1")}, CircleCurve{s["O4"], q}, Meet::Side::left);
        polar_from_line(s, "E", "O4", "0.1", "0", "O4", "A");
        s.revolute("O2", {"1", "2"}).revolute("O4", {"1", "4"}).revolute("A", {"2", "3"});
        s.prismatic("A", {"3", "4"}, s.between("O4", "A"));
        return s.slide(3, "0.2", "-0.4");
    };
    expect_derivatives({cylinder, {{"2", "A"}, {"3", "A"}, {"4", "E"}}}, "0.28", "0.2", "-0.4");
}

TEST(Derivative, PointDrivenAlongALine) {
    const auto trammel = [](const Exact& q) {  // a bar of length 1 whose end A runs along x, B along y
        Sketch s;
        s.point("A", Coordinates{{q, 0}});
        s.meet("B", CircleCurve{s["A"], 1}, LineCurve{at("0", "0"), LineCurve::By::angle, degrees("90"), none, {}},
               Meet::Side::right);
        s.pin_slot("A", {"2", "1"}, at_angle("0")).pin_slot("B", {"2", "1"}, at_angle("90"));
        s.mechanism.drivers.push_back(
            PointDriver{BodyIndex(1), s["A"], at_angle("180"), decimal("-0.5"), decimal("0.25"), "/drivers/0"});
        return s;
    };
    expect_derivatives({trammel, {{"2", "A"}, {"2", "B"}}}, "0.6", "0.5", "-0.25");
}

// --- closed forms
// --------------------------------------------------------------------------------------------------------------

TEST(ClosedForm, SliderCrank) {
    const double r = 0.1, l = 0.3, omega = 10;
    for (const char* angle : {"0", "60", "90"}) {
        Sketch s;
        s.point("O", "0", "0")
            .polar("A", "O", "0.1", angle)
            .meet("B", s.circle("A", "0.3"), s.line("O", "0"), Meet::Side::right);
        s.revolute("O", {"1", "2"})
            .revolute("A", {"2", "3"})
            .revolute("B", {"3", "4"})
            .prismatic("B", {"4", "1"}, at_angle("0"));
        s.spin("2", "10");
        const NumericMotion motion = motion_of(s);
        const double t = std::stod(angle) * degree;
        const double root = std::sqrt(l * l - r * r * std::sin(t) * std::sin(t));
        const double v = -omega * r * std::sin(t) * (1 + r * std::cos(t) / root);
        const double a =
            -omega * omega * r *
            (std::cos(t) + r * (std::cos(2 * t) * l * l + r * r * std::pow(std::sin(t), 4)) / std::pow(root, 3));
        expect_near(motion.bodies[3].velocity, v, 0, 1e-14, angle);
        expect_near(motion.bodies[3].acceleration, a, 0, 1e-12, angle);
    }
}

TEST(ClosedForm, ScotchYoke) {
    Sketch s;
    s.point("O", "0", "0").polar("A", "O", "0.2", "35");
    s.revolute("O", {"1", "2"})
        .pin_slot("A", {"2", "3"}, at_angle("90"))
        .prismatic("A", {"3", "1"}, at_angle("0"))
        .spin("2", "3", "4");
    const NumericMotion motion = motion_of(s);
    const double c = std::cos(35 * degree), n = std::sin(35 * degree);
    expect_near(motion.bodies[2].velocity, -0.2 * 3 * n, 0, 1e-14);
    expect_near(motion.bodies[2].acceleration, -0.2 * (9 * c + 4 * n), 0, 1e-13);
}

TEST(ClosedForm, RollingDiscsLowestPointAcceleratesUpwards) {
    Sketch s;
    s.point("C", "0", "0.5").point("P", "0", "0");
    s.touching(JointKind::rolling, "P", {"2", "1"}, {CircleProfile{PointIndex(0)}, LineProfile{at_angle("0")}})
        .spin("2", "-4");
    const NumericMotion motion = motion_of(s);
    expect_near(motion.velocity(BodyIndex(1), {0, decimal("0.5")}), 2, 0, 1e-14);
    expect_near(motion.acceleration(BodyIndex(1), {0, 0}), 0, 16 * 0.5, 1e-13);
    expect_near(motion.acceleration(BodyIndex(1), {0, decimal("0.5")}), 0, 0, 1e-13);
}

TEST(ClosedForm, InstantaneousMotion) {
    Sketch s;
    s.point("A", "0", "0").point("B", "2", "0");
    s.body("2");
    s.mechanism.bodies[1].points = {PointIndex(0), PointIndex(1)};
    InstantaneousMotion act;
    act.body = BodyIndex(1);
    act.velocities = {{PointIndex(0), Vector{1, 1}}, {PointIndex(1), at_angle("0")}};
    act.accelerations = {{PointIndex(0), Vector{0, 0}}, {PointIndex(1), at_angle("90")}};
    s.mechanism.motion = act;
    const NumericMotion motion = motion_of(s);
    EXPECT_TRUE(motion.bodies[1].velocity_known);
    EXPECT_NEAR(motion.bodies[1].omega, -0.5, 1e-14);
    EXPECT_FALSE(
        motion.bodies[1].acceleration_known);  // ω² ≠ 0 gives a_B a part along x, so the two contradict each other
    s.mechanism.motion->accelerations[1].value = at_angle("0");
    EXPECT_TRUE(motion_of(s).bodies[1].acceleration_known);
    EXPECT_NEAR(motion_of(s).bodies[1].alpha, 0, 1e-14);
}

// --- what is known
// -------------------------------------------------------------------------------------------------------------

TEST(Known, AFreeBodyLeavesTheOthersKnown) {
    Sketch s;
    s.point("O", "0", "0").point("A", "1", "0").point("B", "2", "1");
    s.revolute("O", {"1", "2"}).revolute("A", {"2", "3"}).spin("2", "1", "1");
    s.mechanism.bodies[2].points.push_back(s["B"]);
    const NumericMotion motion = motion_of(s);
    EXPECT_TRUE(motion.bodies[1].velocity_known);
    EXPECT_TRUE(motion.bodies[1].acceleration_known);
    EXPECT_FALSE(motion.bodies[2].velocity_known);
    expect_near(motion.acceleration(BodyIndex(1), {1, 0}), -1, 1, 1e-14);
}

/// A parallelogram with a middle crank: one constraint too many, and consistent.
Sketch parallelogram(const char* angle) {
    Sketch s;
    s.point("O2", "0", "0").point("O4", "0.2", "0").point("O5", "0.1", "0").polar("A", "O2", "0.1", angle);
    s.meet("B", s.circle("A", "0.2"), s.circle("O4", "0.1"), Meet::Side::left);
    s.point("M", Along{s["A"], s["B"], Exact::ratio(1, 2), true});
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    s.revolute("O5", {"1", "5"}).revolute("M", {"3", "5"});
    return s.spin("2", "2", "1");
}

TEST(Known, RedundantConstraintsThatAgree) {
    const NumericMotion motion = motion_of(parallelogram("60"));
    for (const auto& body : motion.bodies) EXPECT_TRUE(body.velocity_known && body.acceleration_known);
    EXPECT_NEAR(motion.bodies[2].omega, 0, 1e-14);
    EXPECT_NEAR(motion.bodies[4].omega, 2, 1e-13);
    EXPECT_NEAR(motion.bodies[4].alpha, 1, 1e-13);
}

TEST(Known, ADriverAgainstADeadPointDeterminesNothing) {
    Sketch s;
    s.point("O", "0", "0")
        .polar("A", "O", "0.1", "0")
        .meet("B", s.circle("A", "0.3"), s.line("O", "0"), Meet::Side::right);
    s.revolute("O", {"1", "2"})
        .revolute("A", {"2", "3"})
        .revolute("B", {"3", "4"})
        .prismatic("B", {"4", "1"}, at_angle("0"))
        .slide(3, "1");
    const NumericMotion motion = motion_of(s);
    EXPECT_FALSE(motion.bodies[1].velocity_known);
}

TEST(Known, WithoutCurvatureVelocitiesOnly) {
    Sketch s;
    s.point("O", "0", "0").point("P", "0.02", "0.05").point("F", "0.02", "0.2");
    s.revolute("O", {"1", "2"}).prismatic("F", {"3", "1"}, at_angle("90"));
    s.joint(JointKind::contact, "P", {"3", "2"}).tangent = at_angle("0");
    s.spin("2", "1");
    const NumericMotion motion = motion_of(s);
    EXPECT_TRUE(motion.bodies[2].velocity_known);
    expect_near(motion.bodies[2].velocity, 0, 0.02, 1e-15);
    EXPECT_TRUE(motion.bodies[1].acceleration_known);
    EXPECT_FALSE(motion.bodies[2].acceleration_known);
}

}  // namespace
}  // namespace kinegraph::check_test
