// Mobility: Grübler's count, the rank at the pose, what is redundant, what the drivers determine.
#include "engine/motion/mobility.hpp"

#include <gtest/gtest.h>

#include "engine/check/check.hpp"
#include "tests/support/sketch.hpp"

namespace kinegraph::mobility_test {
namespace {

using namespace sketch;

Mobility mobility(const Sketch& sketch) {
    const auto pose = draw_pose(sketch.mechanism);
    if (!pose) {
        ADD_FAILURE() << pose.error().front().where << ": " << pose.error().front().message.in(Language::en);
        return {};
    }
    const Mobility result = mobility_of(sketch.mechanism, *pose);
    if (result.driven < result.effective || !result.idle_drivers.empty()) return result;
    // The check finds the same bodies known, by numbers of its own.
    const NumericMotion motion = check_motion(sketch.mechanism, *pose);
    for (std::size_t i = 0; i < motion.bodies.size(); ++i) {
        EXPECT_EQ(result.determined[i], motion.bodies[i].velocity_known) << "body " << i;
    }
    return result;
}

Sketch four_bar(bool rational) {
    Sketch s;
    s.point("O2", "0", "0").point("O4", "0.15", "0");
    if (rational) {
        s.point("A", "0.02", "0.03").point("B", "0.14", "0.08");
    } else {
        s.polar("A", "O2", "0.04", "60").meet("B", s.circle("A", "0.15"), s.circle("O4", "0.08"), Meet::Side::left);
    }
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    return s;
}

TEST(Mobility, OfTheFourBarIsOne) {
    for (const bool rational : {true, false}) {
        Sketch s = four_bar(rational);
        const Mobility free = mobility(s);
        EXPECT_EQ(free.bodies, 4);
        EXPECT_EQ(free.class_1, 4);
        EXPECT_EQ(free.gruebler, 1);
        EXPECT_EQ(free.effective, 1);
        EXPECT_EQ(free.driven, 0);
        EXPECT_TRUE(free.redundant.empty());
        EXPECT_EQ(free.determined, (std::vector<bool>{true, false, false, false}));
        const Mobility driven = mobility(s.spin("2", "1"));
        EXPECT_EQ(driven.driven, 1);
        EXPECT_EQ(driven.determined, (std::vector<bool>(4, true)));
        EXPECT_FALSE(driven.decided_by_finer_pose);
    }
}

Sketch double_crank(const char* angle, const char* shift) {
    Sketch s;
    s.point("O2", "0", "0").point("O4", "0.2", "0").point("O5", shift, "0").polar("A", "O2", "0.1", angle);
    s.meet("B", s.circle("A", "0.2"), s.circle("O4", "0.1"), Meet::Side::left);
    s.point("M", Along{s["A"], s["B"], Exact::ratio(1, 2), true});
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    s.revolute("O5", {"1", "5"}).revolute("M", {"3", "5"});
    return s;
}

TEST(Mobility, ParallelCrankMoreMovesInSpiteOfTheCount) {
    for (const char* angle : {"90", "60", "33.3"}) {
        const Mobility found = mobility(double_crank(angle, "0.1").spin("2", "1"));
        EXPECT_EQ(found.gruebler, 0) << angle;
        EXPECT_EQ(found.effective, 1) << angle;
        ASSERT_EQ(found.redundant.size(), 1U) << angle;
        EXPECT_EQ(found.redundant[0].joint, JointIndex(5)) << angle;
        EXPECT_EQ(found.redundant[0].rows, 1) << angle;
        EXPECT_EQ(found.determined, (std::vector<bool>(5, true))) << angle;
    }
}

TEST(Mobility, ACrankThatIsNotParallelLocks) {
    for (const char* angle : {"90", "60"}) {
        const Mobility found = mobility(double_crank(angle, "0.10001"));
        EXPECT_EQ(found.effective, 0) << angle;
        EXPECT_TRUE(found.redundant.empty()) << angle;
        EXPECT_EQ(found.determined, (std::vector<bool>(5, true))) << angle;
    }
}

/// A slider-crank stretched out at 25°: on the compass's own numbers only a finer pose can tell.
Sketch stretched() {
    Sketch s;
    s.point("O", "0", "0")
        .polar("A", "O", "0.1", "25")
        .meet("B", s.circle("A", "0.3"), s.line("O", "25"), Meet::Side::right);
    s.revolute("O", {"1", "2"})
        .revolute("A", {"2", "3"})
        .revolute("B", {"3", "4"})
        .prismatic("B", {"4", "1"}, at_angle("25"));
    return s;
}

TEST(Mobility, ADriverOfTheSliderIsIdleAtItsDeadPoint) {
    const Mobility by_slider = mobility(stretched().slide(3, "1"));
    EXPECT_EQ(by_slider.effective, 1);
    EXPECT_EQ(by_slider.driven, 0);
    EXPECT_EQ(by_slider.idle_drivers, std::vector<int>{0});
    EXPECT_EQ(by_slider.determined, (std::vector<bool>{true, false, false, true}));  // the slider can't move here
    const Mobility by_crank = mobility(stretched().spin("2", "1"));
    EXPECT_EQ(by_crank.driven, 1);
    EXPECT_EQ(by_crank.determined, (std::vector<bool>(4, true)));
}

TEST(Mobility, ACoincidenceThroughRootsIsDecidedOnAFinerPose) {
    // Folded triangle: |O2A| + |AB| = |O2B| by three irrational lengths along different constructions.
    Sketch s;
    s.point("O2", "0", "0").polar("A", "O2", "0.1", "20").polar("K", "A", "0.25", "50").polar("B0", "A", "0.2", "20");
    s.meet("B", s.circle("K", "0.15"), s.circle("O2", "0.3"), Meet::Side::left);  // some place, irrational
    s.point("C", Polar{s["O2"], decimal("0.1"), degrees("40"), Bearing::Between{s["O2"], s["B"]}});
    s.point("D", Polar{s["O2"], decimal("0.2"), degrees("40"), Bearing::Between{s["O2"], s["B"]}});
    // O2, C, D lie on one line, but only up to the grid on which C and D were rounded: two bars stretched out and
    // pinned.
    s.revolute("O2", {"1", "2"}).revolute("C", {"2", "3"}).revolute("D", {"3", "1"});
    const Mobility found = mobility(s);
    EXPECT_EQ(found.gruebler, 0);
    EXPECT_EQ(found.effective, 1);
    EXPECT_TRUE(found.decided_by_finer_pose);
    ASSERT_EQ(found.redundant.size(), 1U);
    EXPECT_EQ(found.redundant[0].joint, JointIndex(2));
}

TEST(Mobility, ANearCoincidenceThatStaysIsNone) {
    Sketch s;  // the same two bars, truly 1e-20 m off the line
    s.point("O2", "0", "0")
        .polar("C", "O2", "0.1", "20")
        .polar("D0", "O2", "0.2", "20")
        .polar("D", "D0", "1e-20", "110");
    s.revolute("O2", {"1", "2"}).revolute("C", {"2", "3"}).revolute("D", {"3", "1"});
    const auto pose = draw_pose(s.mechanism);
    ASSERT_TRUE(pose);
    EXPECT_EQ(mobility_of(s.mechanism, *pose).effective, 0);
}

TEST(Mobility, TwoDriversOfOneFreedomLeaveOneIdle) {
    const Mobility found = mobility(four_bar(true).spin("2", "1").spin("4", "1"));
    EXPECT_EQ(found.driven, 1);
    EXPECT_EQ(found.idle_drivers, std::vector<int>{1});
}

TEST(Mobility, CountsEveryKindOfPair) {
    Sketch s;
    s.point("O", "0", "0")
        .point("A", "1", "0")
        .point("P", "2", "0")
        .point("Q", "3", "1")
        .point("R", "4", "0")
        .point("C", "2", "1");
    s.revolute("O", {"1", "2", "3"})
        .prismatic("A", {"2", "4"}, at_angle("10"))
        .pin_slot("Q", {"4", "5"}, at_angle("30"));
    s.touching(JointKind::rolling, "P", {"5", "1"}, {CircleProfile{s["C"]}, LineProfile{at_angle("0")}});
    s.joint(JointKind::contact, "R", {"6", "1"}).tangent = at_angle("0");
    s.joint(JointKind::gear, "A", {"6", "3"}).tangent = at_angle("90");
    s.joint(JointKind::weld, "C", {"7", "6"});
    const Mobility found = mobility(s);
    EXPECT_EQ(found.class_1, 2 + 1 + 1);
    EXPECT_EQ(found.class_2, 3);
    EXPECT_EQ(found.welds, 1);
    EXPECT_EQ(found.gruebler, 18 - 8 - 3 - 3);
    EXPECT_EQ(found.effective, found.gruebler);
}

TEST(Mobility, ABodyMayBeDeterminedWhileAnotherIsFree) {
    Sketch s = four_bar(true);
    s.point("X", "0.3", "0.1").revolute("B", {"4", "9"});
    s.mechanism.bodies.back().points.push_back(s["X"]);
    const Mobility found = mobility(s.spin("2", "1"));
    EXPECT_EQ(found.effective, 2);
    EXPECT_EQ(found.determined, (std::vector<bool>{true, true, true, true, false}));
    const auto pose = draw_pose(s.mechanism);
    const NumericMotion motion = check_motion(s.mechanism, *pose);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(motion.bodies[i].velocity_known, found.determined[i]);
}

TEST(Mobility, OfAnInstantaneousMotionIsThree) {
    Sketch s;
    s.point("A", "0", "0").point("B", "2", "0");
    s.body("2");
    s.mechanism.bodies[1].points = {PointIndex(0), PointIndex(1)};
    s.mechanism.motion = InstantaneousMotion{
        BodyIndex(1), {{PointIndex(0), Vector{1, 1}}, {PointIndex(1), at_angle("0")}}, {}, "/motion"};
    const Mobility found = mobility(s);
    EXPECT_EQ(found.effective, 3);
    EXPECT_EQ(found.driven, 3);
    EXPECT_TRUE(found.determined[1]);
}

}  // namespace
}  // namespace kinegraph::mobility_test
