// Verdicts of the rank, and the branches that leave a change point, against closed forms.
#include "engine/motion/branches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "constructions/kinematics/degeneracy.hpp"
#include "tests/support/sketch.hpp"
#include "tests/support/told.hpp"

namespace kinegraph::branches_test {
namespace {

using namespace sketch;
using SecondOrder = InstantMotion::SecondOrder;
using Verdict = Mobility::Verdict;

struct Seen {
    Pose pose;
    Mobility mobility;
    InstantMotion motion;
    std::string remarks;
};
Seen look(const Sketch& s) {
    Seen seen;
    auto pose = draw_pose(s.mechanism);
    if (!pose) {
        ADD_FAILURE() << pose.error().front().message.in(Language::en);
        return seen;
    }
    seen.pose = std::move(*pose);
    seen.mobility = mobility_of(s.mechanism, seen.pose);
    seen.motion = instant_motion_of(s.mechanism, seen.pose, seen.mobility);
    for (const Message& remark : remarks_on_mobility(s.mechanism, seen.mobility, seen.motion))
        seen.remarks += english(remark) + "\n";
    return seen;
}

/// Crank a, coupler b, rocker a, frame b, all on one line.
Sketch folded(const char* a, const char* a_and_b, const char* b) {
    Sketch s;
    s.point("O2", "0", "0").point("A", a, "0").point("B", a_and_b, "0").point("O4", b, "0");
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    return s;
}

TEST(Branches, OfAFoldedParallelogramAreItselfAndTheCrossedOne) {
    // x″ of the loop: a(ω₄² − ω₂²) = b ω₃², with b ω₃ = a(ω₄ − ω₂): ω₄/ω₂ = 1 or −(b + a)/(b − a)
    const Seen seen = look(folded("0.1", "0.3", "0.2").spin("2", "1"));
    EXPECT_EQ(seen.mobility.gruebler, 1);
    EXPECT_EQ(seen.mobility.effective, 2);
    EXPECT_EQ(seen.mobility.verdict(), Verdict::mechanism);
    ASSERT_EQ(seen.motion.second_order, SecondOrder::branches);
    ASSERT_EQ(seen.motion.branches.size(), 2u);
    std::vector<Exact> rocker;
    for (const Branch& branch : seen.motion.branches) {
        EXPECT_EQ(branch.reference, BodyIndex(1)) << "the driven crank";
        ASSERT_EQ(branch.exact.size(), 4u);
        EXPECT_EQ(branch.exact[1], 1);
        EXPECT_EQ(2 * branch.exact[2], branch.exact[3] - 1) << "b ω₃ = a(ω₄ − ω₂)";
        rocker.push_back(branch.exact[3]);
    }
    EXPECT_TRUE((rocker == std::vector<Exact>{1, -3}) || (rocker == std::vector<Exact>{-3, 1}));
    EXPECT_NE(seen.remarks.find("2 branches leave it"), std::string::npos) << seen.remarks;
    EXPECT_NE(seen.remarks.find("omega_4/omega_2 = −3.0000"), std::string::npos) << seen.remarks;
}

TEST(Branches, AreTheSameOnAPoseWithALeftover) {
    Sketch s;  // the same, turned by 20°
    s.point("O2", "0", "0").polar("A", "O2", "0.1", "20").polar("B", "O2", "0.3", "20").polar("O4", "O2", "0.2", "20");
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    const Seen seen = look(s.spin("2", "1"));
    EXPECT_FALSE(seen.pose.exact);
    ASSERT_EQ(seen.motion.second_order, SecondOrder::branches);
    ASSERT_EQ(seen.motion.branches.size(), 2u);
    double sum = 0, product = 1;
    for (const Branch& branch : seen.motion.branches) {
        EXPECT_TRUE(branch.exact.empty());
        sum += branch.ratios.at(3);
        product *= branch.ratios.at(3);
    }
    EXPECT_NEAR(sum, -2, 1e-14);
    EXPECT_NEAR(product, -3, 1e-14);
}

TEST(Branches, OfARhombusAreATurnAsAWholeAndItsCrankAlone) {
    // All links alike: A falls on O4.
    Sketch s;
    s.point("O2", "0", "0").point("A", "1", "0").point("O4", "1", "0").point("B", "2", "0");
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    const Seen seen = look(s.spin("2", "1"));
    ASSERT_EQ(seen.motion.second_order, SecondOrder::branches);
    ASSERT_EQ(seen.motion.branches.size(), 2u);
    for (const Branch& branch : seen.motion.branches) {
        // a(ω₄² − ω₂²) = a(ω₄ − ω₂)²: ω₄ = ω₂, or ω₂ = 0 and body 3 turns as 4 does
        if (branch.reference == BodyIndex(1))
            EXPECT_EQ(branch.exact.at(3), 1);
        else
            EXPECT_TRUE(branch.exact.at(1).is_zero() && branch.exact.at(2) == branch.exact.at(3));
    }
    EXPECT_NE(seen.motion.branches[0].reference, seen.motion.branches[1].reference);
}

TEST(Branches, WithIrrationalRatiosAreGivenAsDoubles) {
    // Links 3, 2, 1 on a frame of 4, all on one line: 3 + 2 = 4 + 1.
    Sketch s;
    s.point("O2", "0", "0").point("A", "3", "0").point("B", "5", "0").point("O4", "4", "0");
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    const Seen seen = look(s.spin("2", "1"));
    ASSERT_EQ(seen.motion.branches.size(), 2u);
    for (const Branch& branch : seen.motion.branches) {
        // 3ω₂ + 2ω₃ = ω₄ and 3ω₂² + 2ω₃² = ω₄², ω₂ = 1: 2ω₃² + 12ω₃ + 6 = 0, ω₃ = −3 ± √6
        EXPECT_TRUE(branch.exact.empty());
        EXPECT_NEAR(std::abs(branch.ratios.at(2) + 3), std::sqrt(6), 1e-14);
        EXPECT_NEAR(branch.ratios.at(3), 3 + 2 * branch.ratios.at(2), 1e-14);
    }
}

/// Three cranks of one length carry one coupler.
Sketch parallel_cranks(const char* third_top, const char* third_foot) {
    Sketch s;
    s.point("O2", "0", "0").point("O4", "2", "0").point("O5", third_foot, "0");
    s.point("A", "0", "1").point("B", "2", "1").point("M", third_foot, third_top);
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    s.revolute("O5", {"1", "5"}).revolute("M", {"3", "5"});
    return s;
}

TEST(Verdicts, ThreeEqualParallelCranksMoveInSpiteOfTheCount) {
    const Seen seen = look(parallel_cranks("1", "1"));
    EXPECT_EQ(seen.mobility.gruebler, 0);
    EXPECT_EQ(seen.mobility.verdict(), Verdict::labile);
    EXPECT_EQ(seen.mobility.repeated(), 1);
    EXPECT_EQ(seen.motion.second_order, SecondOrder::free) << "it goes on moving";
}

TEST(Verdicts, ThreeParallelCranksOfTwoLengthsMoveForAnInstantOnly) {
    const Seen seen = look(parallel_cranks("1.5", "1"));
    EXPECT_EQ(seen.mobility.effective, 1);
    EXPECT_EQ(seen.mobility.verdict(), Verdict::labile);
    EXPECT_EQ(seen.motion.second_order, SecondOrder::impossible);
    EXPECT_NE(seen.remarks.find("for an instant only"), std::string::npos) << seen.remarks;
}

TEST(Verdicts, ATrussIsIsostaticAndWithABarMoreHyperstatic) {
    Sketch s;
    s.point("A", "0", "0").point("B", "2", "0").point("C", "1", "1").point("D", "1", "0");
    s.revolute("A", {"1", "2"}).revolute("C", {"2", "3"}).revolute("B", {"1", "3"});
    EXPECT_EQ(look(s).mobility.verdict(), Verdict::isostatic);
    Sketch more;
    more.mechanism.points = s.mechanism.points;
    more.revolute("A", {"1", "2"}).revolute("C", {"2", "3", "4"}).revolute("B", {"1", "3"}).revolute("D", {"1", "4"});
    const Seen seen = look(more);
    EXPECT_EQ(seen.mobility.verdict(), Verdict::hyperstatic);
    EXPECT_EQ(seen.mobility.repeated(), 1);
    EXPECT_EQ(seen.motion.still.size(), 3u) << "all bodies stand";
}

TEST(Verdicts, TwoBarsInOneLineAreShaky) {
    Sketch s;
    s.point("A", "0", "0").point("B", "2", "0").point("C", "1", "0");
    s.revolute("A", {"1", "2"}).revolute("C", {"2", "3"}).revolute("B", {"1", "3"});
    const Seen seen = look(s);
    EXPECT_EQ(seen.mobility.gruebler, 0);
    EXPECT_EQ(seen.mobility.verdict(), Verdict::labile);
    EXPECT_EQ(seen.motion.second_order, SecondOrder::impossible);
}

TEST(SecondOrderConditions, OfASlotCurvedAsThePinMovesAreFree) {
    // A pin on a crank in a slot about the crank's own pivot: one freedom, whatever the file's count says.
    Sketch s;
    s.point("O", "0", "0").point("P", "1", "0").point("C", "0.5", "0");
    s.revolute("O", {"1", "2"}).pin_arc("P", {"2", "1"}, "O");
    const Seen concentric = look(s);
    EXPECT_EQ(concentric.mobility.gruebler, 0);
    EXPECT_EQ(concentric.motion.second_order, SecondOrder::free);
    Sketch t;
    t.mechanism.points = s.mechanism.points;
    t.revolute("O", {"1", "2"}).pin_arc("P", {"2", "1"}, "C");
    EXPECT_EQ(look(t).motion.second_order, SecondOrder::impossible) << "a slot of another radius";
}

TEST(SecondOrderConditions, OfADiscRollingRoundAFixedOneOnItsArmAreFree) {
    Sketch s;
    s.point("O", "0", "0").point("C", "3", "0").point("P", "2", "0");
    s.revolute("O", {"1", "2"}).revolute("C", {"2", "3"});
    s.touching(JointKind::rolling, "P", {"3", "1"}, {CircleProfile{s["C"]}, CircleProfile{s["O"]}});
    const Seen seen = look(s);
    EXPECT_EQ(seen.mobility.gruebler, 0) << "the arm already keeps the distance";
    EXPECT_EQ(seen.mobility.effective, 1);
    EXPECT_EQ(seen.motion.second_order, SecondOrder::free);
    // An arm about another pivot does not.
    Sketch t;
    t.mechanism.points = s.mechanism.points;
    t.point("Q", "1", "0");
    t.revolute("Q", {"1", "2"}).revolute("C", {"2", "3"});
    t.touching(JointKind::rolling, "P", {"3", "1"}, {CircleProfile{t["C"]}, CircleProfile{t["O"]}});
    EXPECT_EQ(look(t).motion.second_order, SecondOrder::impossible);
}

TEST(SecondOrderConditions, OfADiscOnAStraightTrackHeldByAParallelGuideAreFree) {
    Sketch s;
    s.point("C", "0", "1").point("P", "0", "0");
    s.prismatic("C", {"2", "1"}, at_angle("0")).revolute("C", {"2", "3"});
    s.touching(JointKind::rolling, "P", {"3", "1"}, {CircleProfile{s["C"]}, LineProfile{at_angle("0")}});
    const Seen seen = look(s);
    EXPECT_EQ(seen.mobility.effective, 1);
    EXPECT_EQ(seen.mobility.repeated(), 1);
    EXPECT_EQ(seen.motion.second_order, SecondOrder::free);
}

TEST(DeadPoint, NamesTheBodyThatCannotBeDriven) {
    Sketch s;
    s.point("O", "0", "0").point("A", "1", "0").point("B", "4", "0");
    s.revolute("O", {"1", "2"})
        .revolute("A", {"2", "3"})
        .revolute("B", {"3", "4"})
        .prismatic("B", {"4", "1"}, at_angle("0"));
    const Seen seen = look(s.slide(3, "1"));
    EXPECT_EQ(seen.motion.still, std::vector<BodyIndex>{BodyIndex(3)});
    EXPECT_TRUE(seen.motion.unturning.empty());
    EXPECT_NE(seen.remarks.find("Body 4 stands still in every motion"), std::string::npos) << seen.remarks;
}

TEST(DeadPoint, OfACouplerThatTranslatesIsSaidSo) {
    Sketch s;  // a parallelogram: its coupler never turns
    s.point("O2", "0", "0").point("A", "0", "1").point("B", "2", "1").point("O4", "2", "0");
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    const Seen seen = look(s.spin("3", "1"));
    EXPECT_EQ(seen.motion.unturning, std::vector<BodyIndex>{BodyIndex(2)});
    EXPECT_NE(seen.remarks.find("Body 3 does not turn in any motion"), std::string::npos) << seen.remarks;
}

}  // namespace
}  // namespace kinegraph::branches_test
