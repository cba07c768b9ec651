// The pose: directions of angles, points by compass and ruler, which of two intersections, contacts that fit or do not.
#include "engine/drawing/pose.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sketch.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::pose_test {
namespace {

using namespace sketch;

Vector direction(const char* angle) { return direction_of(degrees(angle), 100); }

/// The pose of a sketch that is meant to be drawable.
Pose drawn(const Sketch& sketch, int bits = 100) {
    auto pose = draw_pose(sketch.mechanism, bits);
    if (!pose) {
        ADD_FAILURE() << pose.error().front().where << ": " << pose.error().front().message.in(Language::en);
        return {};
    }
    return *std::move(pose);
}
Error refused(const Sketch& sketch) {
    auto pose = draw_pose(sketch.mechanism);
    if (!pose) return pose.error().front();
    ADD_FAILURE() << "was drawn";
    return {};
}
double far(const Vector& a, const Vector& b) { return length(a - b); }

TEST(Angle, MultiplesOf45DegreesAreExact) {
    EXPECT_EQ(direction("0"), (Vector{1, 0}));
    EXPECT_EQ(direction("45"), (Vector{1, 1}));
    EXPECT_EQ(direction("90"), (Vector{0, 1}));
    EXPECT_EQ(direction("135"), (Vector{-1, 1}));
    EXPECT_EQ(direction("180"), (Vector{-1, 0}));
    EXPECT_EQ(direction("-90"), (Vector{0, -1}));
    EXPECT_EQ(direction("720"), (Vector{1, 0}));
    EXPECT_EQ(direction_of(radians("0"), 100), (Vector{1, 0}));
}

TEST(Angle, QuarterTurnsArePerpendicularOppositesOppositeMirroredMirrored) {
    for (const char* text : {"30", "12.5", "44.999", "60", "89.9", "0.001", "271.3"}) {
        const Exact angle = decimal(text);
        const auto turned_by = [&](int by) { return direction_of(Angle{angle + by, true}, 100); };
        const Vector d = turned_by(0);
        EXPECT_EQ(turned_by(90), quarter_turn(d)) << text;
        EXPECT_EQ(turned_by(180), -d) << text;
        EXPECT_EQ(turned_by(-360), d) << text;
        EXPECT_EQ(direction_of(Angle{-angle, true}, 100), (Vector{d.x, -d.y})) << text;
        EXPECT_EQ(direction_of(Angle{180 - angle, true}, 100), (Vector{-d.x, d.y})) << text;
        EXPECT_EQ(direction_of(Angle{90 - angle, true}, 100), (Vector{d.y, d.x})) << text;
    }
}

TEST(Angle, TangentIsWithinItsBits) {
    const Vector d = direction("30");  // 3·tan²30° = 1
    EXPECT_LT(abs(3 * square(d.y) - 1), Exact::power_of_two(-97));
    EXPECT_NEAR(direction_of(radians("1"), 100).x.to_double(), 1 / std::tan(1.0), 1e-15);
    EXPECT_EQ(direction_of(radians("1"), 100).y, 1);
}

TEST(Unit, IsExactWhereTheLengthIsRational) {
    EXPECT_EQ(unit_along({3, -4}, 100), (Vector{Exact::ratio(3, 5), Exact::ratio(-4, 5)}));
    const Vector u = unit_along({1, 1}, 100);
    EXPECT_EQ(u.x, u.y);
    EXPECT_LT(abs(squared_length(u) - 1), Exact::power_of_two(-98));
}

TEST(Pose, PolarPointsOfOneAngleLieOnOneRay) {
    Sketch s;
    s.point("O", "0.1", "0.2")
        .polar("A", "O", "1", "30")
        .polar("B", "O", "2.5", "30")
        .polar("C", "O", "-1", "30")
        .polar("D", "O", "1", "120");
    const Pose pose = drawn(s);
    const auto arm = [&](const char* name) { return pose.at(s[name]) - pose.at(s["O"]); };
    EXPECT_TRUE(cross(arm("A"), arm("B")).is_zero());
    EXPECT_EQ(arm("C"), -arm("A"));
    EXPECT_EQ(arm("D"), quarter_turn(arm("A")));
    EXPECT_FALSE(pose.exact);
    EXPECT_NEAR(length(arm("B")), 2.5, 1e-15);
    EXPECT_LT(abs(squared_length(arm("B")) - square(decimal("2.5"))), Exact::power_of_two(-95));
}

TEST(Pose, PolarRelativeToALine) {
    Sketch s;
    s.point("P", "0", "0").point("Q", "3", "4");
    s.point("R", Polar{PointIndex(0), 10, degrees("90"), Bearing::Between{PointIndex(0), PointIndex(1)}});
    s.point("T", Polar{PointIndex(0), 2, degrees("45"), Bearing::Between{PointIndex(0), PointIndex(1)}});
    const Pose pose = drawn(s);
    EXPECT_EQ(pose.at(PointIndex(2)), (Vector{-8, 6}));
    EXPECT_TRUE(pose.leftover[2].is_zero());
    EXPECT_NEAR(pose.at(PointIndex(3)).x.to_double(), 2 * std::cos(std::atan2(4, 3) + std::atan(1.0)), 1e-15);
    EXPECT_LT(pose.at(PointIndex(3)).x.bits(), 240U);
}

TEST(Pose, AlongByDistanceAndByRatio) {
    Sketch s;
    s.point("P", "1", "1").point("Q", "4", "5");
    s.point("by_distance", Along{PointIndex(0), PointIndex(1), decimal("-2.5"), false})
        .point("by_ratio", Along{PointIndex(0), PointIndex(1), Exact::ratio(1, 3), true});
    const Pose pose = drawn(s);
    EXPECT_EQ(pose.at(PointIndex(2)), (Vector{Exact::ratio(-1, 2), -1}));
    EXPECT_EQ(pose.at(PointIndex(3)), (Vector{2, Exact::ratio(7, 3)}));
    EXPECT_TRUE(pose.exact);
}

TEST(Pose, PointsMayBeUsedBeforeTheyAreDefined) {
    Sketch s;
    s.point("M", Along{PointIndex(1), PointIndex(2), Exact::ratio(1, 2), true})
        .point("A", "0", "0")
        .point("B", "2", "0");
    EXPECT_EQ(drawn(s).at(PointIndex(0)), (Vector{1, 0}));
}

TEST(Pose, RationalParallelogramIsExact) {
    Sketch s;
    s.point("O2", "0", "0").point("A", "0.03", "0.04").point("O4", "0.1", "0");
    s.meet("B", s.circle("A", "0.1"), s.circle("O4", "0.05"), Meet::Side::left);
    const Pose pose = drawn(s);
    EXPECT_EQ(pose.at(PointIndex(3)), at("0.13", "0.04"));
    EXPECT_TRUE(pose.exact);
}

TEST(Pose, IrrationalParallelogramHasParallelSides) {
    Sketch s;
    s.point("O2", "0", "0").point("O4", "0.1", "0").polar("A", "O2", "0.05", "60");
    s.meet("B", s.circle("A", "0.1"), s.circle("O4", "0.05"), Meet::Side::left);
    const Pose pose = drawn(s);
    EXPECT_EQ(pose.at(PointIndex(3)) - pose.at(PointIndex(2)), at("0.1", "0"));
    EXPECT_FALSE(pose.exact);
}

TEST(Pose, SideOfTwoCirclesIsSeenFromFirstToSecondCentre) {
    for (const bool left : {true, false}) {
        Sketch s;
        s.point("C", "0", "0").point("D", "6", "0");
        s.meet("P", s.circle("C", "5"), s.circle("D", "5"), left ? Meet::Side::left : Meet::Side::right);
        s.meet("Q", s.circle("D", "5"), s.circle("C", "5"), left ? Meet::Side::left : Meet::Side::right);
        EXPECT_EQ(drawn(s).at(PointIndex(2)), (Vector{3, left ? 4 : -4}));
        EXPECT_EQ(drawn(s).at(PointIndex(3)), (Vector{3, left ? -4 : 4}));
    }
}

TEST(Pose, SideOnALineIsAlongItsDirectionWhereverTheCentreLies) {
    for (const char* y : {"3", "-3", "0"}) {
        Sketch s;
        s.point("C", "0", y).point("O", "0", "0");
        s.meet("P", s.circle("C", "5"), s.line("O", "0"), Meet::Side::right);
        s.meet("Q", s.line("O", "0"), s.circle("C", "5"), Meet::Side::left);
        s.meet("R", s.line("O", "180"), s.circle("C", "5"), Meet::Side::right);
        const Pose pose = drawn(s);
        EXPECT_EQ(pose.at(PointIndex(2)).x.sign(), 1);
        EXPECT_EQ(pose.at(PointIndex(3)), -pose.at(PointIndex(2)));
        EXPECT_EQ(pose.at(PointIndex(4)), -pose.at(PointIndex(2)));
    }
}

TEST(Pose, NearTakesTheNearerAndRefusesATie) {
    Sketch s;
    s.point("C", "0", "0").point("D", "6", "0");
    s.point("P", Meet{s.circle("C", "5"), s.circle("D", "5"), at("0", "1"), Meet::Side::either});
    EXPECT_EQ(drawn(s).at(PointIndex(2)), (Vector{3, 4}));
    s.point("Q", Meet{s.circle("C", "5"), s.circle("D", "5"), at("1", "0"), Meet::Side::either});
    EXPECT_EQ(refused(s).where, "/points/Q");
    EXPECT_NE(refused(s).message.in(Language::en).find("equally far"), std::string::npos);
}

TEST(Pose, TwoIntersectionsNeedAChoice) {
    Sketch s;
    s.point("C", "0", "0").point("D", "6", "0").meet("P", s.circle("C", "5"), s.circle("D", "5"));
    EXPECT_NE(refused(s).message.in(Language::en).find("meet twice; choose"), std::string::npos);
    EXPECT_EQ(refused(s).code, ErrorCode::bad_input);
}

TEST(Pose, TangentCirclesNeedNone) {
    Sketch s;
    s.point("C", "0", "0").point("D", "6", "8").meet("P", s.circle("C", "4"), s.circle("D", "6"));
    s.meet("Q", s.circle("C", "13"), s.circle("D", "3"));
    s.point("S", "7", "2").meet("R", s.circle("C", "2"), s.line("S", "0"));
    const Pose pose = drawn(s);
    EXPECT_EQ(pose.at(PointIndex(2)), (Vector{Exact::ratio(12, 5), Exact::ratio(16, 5)}));
    EXPECT_EQ(pose.at(PointIndex(3)), (Vector{Exact::ratio(39, 5), Exact::ratio(52, 5)}));
    EXPECT_EQ(pose.at(PointIndex(5)), (Vector{0, 2}));
}

TEST(Pose, TangencyThroughARootIsTangency) {
    Sketch s;  // stretched out at 20°: the circle about A touches the one about O
    s.point("O", "0", "0").polar("A", "O", "1", "20").meet("B", s.circle("A", "2"), s.circle("O", "3"));
    const Pose pose = drawn(s);
    EXPECT_TRUE(cross(pose.at(PointIndex(1)), pose.at(PointIndex(2))).is_zero());
    EXPECT_NEAR(length(pose.at(PointIndex(2))), 3, 1e-14);
}

TEST(Pose, CurvesThatDoNotMeetSayByHowMuch) {
    Sketch s;
    s.mechanism.units.length = {"mm", Exact::ratio(1, 1000)};
    s.point("A", "0", "0").point("O4", "0.1", "0").meet("B", s.circle("A", "0.05"), s.circle("O4", "0.03"));
    EXPECT_EQ(refused(s).code, ErrorCode::cannot_meet);
    EXPECT_EQ(refused(s).where, "/points/B");
    EXPECT_EQ(refused(s).message.in(Language::en),
              "the circles about A (radius 50 mm) and O4 (radius 30 mm) do not meet: their centres are 100 mm apart, "
              "20 mm too far");
    Sketch inside = s;
    inside.mechanism.points.pop_back();
    inside.meet("B", s.circle("A", "0.25"), s.circle("O4", "0.03"));
    EXPECT_NE(refused(inside).message.in(Language::en).find("100 mm apart, 120 mm too near"), std::string::npos);
    Sketch line = s;
    line.mechanism.points.pop_back();
    line.meet("B", s.circle("A", "0.05"), s.line("O4", "90"));
    EXPECT_NE(refused(line).message.in(Language::en).find("passes 100 mm from the centre, 50 mm too far"),
              std::string::npos);
    Sketch parallel = s;
    parallel.mechanism.points.pop_back();
    parallel.meet("B", s.line("A", "30"), LineCurve{at("0", "0.01"), LineCurve::By::angle, degrees("210"), none, {}});
    EXPECT_NE(refused(parallel).message.in(Language::en).find("they are parallel"), std::string::npos);
}

TEST(Pose, AMeetStaysOnItsLineExactly) {
    Sketch s;
    s.point("O", "0", "0").polar("A", "O", "0.05", "50").polar("G", "O", "1", "10");
    s.meet("B", s.circle("A", "0.2"), s.line("O", "10"), Meet::Side::right);
    const Pose pose = drawn(s);
    EXPECT_TRUE(cross(pose.at(PointIndex(2)), pose.at(PointIndex(3))).is_zero());
    EXPECT_NEAR(far(pose.at(PointIndex(3)), pose.at(PointIndex(1))), 0.2, 1e-15);
}

TEST(Pose, AFinerPoseConvergesOnTheSameBranch) {
    Sketch s;
    s.point("O2", "0", "0").point("O4", "0.15", "0").polar("A", "O2", "0.04", "61");
    s.meet("B", s.circle("A", "0.15"), s.circle("O4", "0.08"), Meet::Side::left);
    const Vector coarse = drawn(s).at(PointIndex(3));
    const Vector fine = drawn(s, 200).at(PointIndex(3));
    const Vector finest = drawn(s, 400).at(PointIndex(3));
    EXPECT_LT(squared_length(coarse - fine), Exact::power_of_two(-180));
    EXPECT_GT(squared_length(coarse - fine), Exact::power_of_two(-300));
    EXPECT_LT(squared_length(finest - fine), Exact::power_of_two(-380));
    EXPECT_LT(coarse.x.bits(), 260U);
}

TEST(Pose, ASmallDrawingOnALongRadiusKeepsItsBits) {
    Sketch s;  // drawn within a millimetre, on a circle of a thousand kilometres
    s.point("A", "0", "0")
        .meet("B", CircleCurve{at("0", "-1e6"), decimal("1000000.0003")}, s.line("A", "77"), Meet::Side::right);
    const auto miss = [&](int bits) {
        return length(drawn(s, bits).at(PointIndex(1)) - drawn(s, 400).at(PointIndex(1))) / drawn(s).size.to_double();
    };
    EXPECT_LT(miss(100), std::ldexp(1, -98));
    EXPECT_LT(miss(200), std::ldexp(1, -198));
}

TEST(Pose, FaultsAreToldAtOnceInTheOrderOfTheFile) {
    Sketch s;
    s.point("M", Along{PointIndex(2), PointIndex(3), Exact::ratio(1, 2), true}).point("A", "0", "0");
    s.meet("X", CircleCurve{PointIndex(1), 1}, CircleCurve{at("5", "0"), 1})
        .meet("Y", CircleCurve{PointIndex(1), 1}, CircleCurve{at("7", "0"), 1});
    const auto pose = draw_pose(s.mechanism);
    ASSERT_FALSE(pose);
    ASSERT_EQ(pose.error().size(), 2U);
    EXPECT_EQ(pose.error()[0].where, "/points/X");
    EXPECT_EQ(pose.error()[1].where, "/points/Y");
}

Sketch disc_on_ground(const char* x_of_contact, const char* radius) {
    Sketch s;
    s.point("C", "0", "0.5").point("P", x_of_contact, "0");
    s.touching(JointKind::rolling, "P", {"2", "1"}, {CircleProfile{s["C"], true}, LineProfile{at_angle("0")}});
    s.mechanism.bodies[1].circle = Circle{s["C"], decimal(radius)};
    return s;
}

TEST(Contact, ThatFitsHasItsNormalThroughTheCentre) {
    const Pose pose = drawn(disc_on_ground("0", "0.5"));
    EXPECT_TRUE(pose.normals[0].x.is_zero());
    EXPECT_TRUE(pose.remarks.empty());
    EXPECT_TRUE(pose.exact);
}

TEST(Contact, WithinItsFitIsMovedOntoTheCurveAndSaysSo) {
    const Pose pose = drawn(disc_on_ground("1e-11", "0.5"));
    EXPECT_TRUE(pose.at(PointIndex(1)).x.is_zero());
    ASSERT_EQ(pose.remarks.size(), 1U);
    EXPECT_EQ(english(pose.remarks[0]), "P was moved by 1.00 × 10⁻¹¹ m to the foot of C on the line.");
}

TEST(Contact, OffItsCurveIsRefusedWithTheMisfit) {
    EXPECT_EQ(refused(disc_on_ground("0.001", "0.5")).where, "/joints/0");
    EXPECT_NE(refused(disc_on_ground("0.001", "0.5")).message.in(Language::en).find("P is 0.001 m off"),
              std::string::npos);
    EXPECT_NE(refused(disc_on_ground("0", "0.51")).message.in(Language::en).find("0.01 m off"), std::string::npos);
}

TEST(Contact, GearsTouchOnTheLineOfCentres) {
    Sketch s;
    s.point("O1", "0", "0")
        .point("O2", "0.3", "0.4")
        .point("P", Along{PointIndex(0), PointIndex(1), Exact::ratio(2, 5), true});
    s.touching(JointKind::gear, "P", {"2", "3"}, {CircleProfile{PointIndex(0)}, CircleProfile{PointIndex(1)}});
    s.mechanism.joints[0].pressure_angle = degrees("45");
    const Pose pose = drawn(s);
    EXPECT_TRUE(dot(pose.tangents[0], pose.at(PointIndex(1))).is_zero());
    EXPECT_EQ(cross(pose.tangents[0], pose.normals[0]), dot(pose.tangents[0], pose.normals[0]));
}

TEST(Contact, ClaimedByTwoJointsKeepsItsPointAndSaysSo) {
    Sketch s = disc_on_ground("1e-11", "0.5");
    s.point("D", "1e-11", "-2");
    s.touching(JointKind::rolling, "P", {"3", "1"}, {CircleProfile{s["D"]}, LineProfile{at_angle("0")}});
    const Pose pose = drawn(s);
    EXPECT_EQ(pose.at(PointIndex(1)), at("1e-11", "0"));
    ASSERT_FALSE(pose.remarks.empty());
    EXPECT_NE(english(pose.remarks[0]).find("several joints claim it"), std::string::npos);
}

TEST(Contact, CompassNoiseIsRemovedWithoutAWord) {
    Sketch s;  // the contact found by radii, not on the line of centres by construction
    s.point("O", "0", "0").polar("C", "O", "0.3", "20").polar("P", "O", "0.1", "20").polar("K", "P", "0.05", "77");
    s.meet("Q", s.circle("K", "0.05"), s.circle("O", "0.1"));
    std::get<Meet>(s.mechanism.points.back().placement).near = at("0.0939", "0.0342");
    s.touching(JointKind::rolling, "Q", {"2", "3"}, {CircleProfile{s["O"]}, CircleProfile{s["C"]}});
    const Pose pose = drawn(s);
    EXPECT_TRUE(cross(pose.at(s["Q"]), pose.at(s["C"])).is_zero());
    EXPECT_TRUE(pose.remarks.empty());
}

TEST(Guide, KeepsItsSenseAndNeedsTwoPlaces) {
    Sketch s;
    s.point("A", "0", "0").point("B", "-3", "-4").point("C", "0", "0");
    s.prismatic("A", {"2", "1"}, s.between("A", "B")).prismatic("C", {"3", "1"}, {Vector{0, -2}});
    const Pose pose = drawn(s);
    EXPECT_EQ(pose.guide_units[0], (Vector{Exact::ratio(-3, 5), Exact::ratio(-4, 5)}));
    EXPECT_EQ(pose.guide_units[1], (Vector{0, -1}));
    s.prismatic("B", {"4", "1"}, s.between("A", "C"));
    EXPECT_EQ(refused(s).where, "/joints/2/along");
}

}  // namespace
}  // namespace kinegraph::pose_test
