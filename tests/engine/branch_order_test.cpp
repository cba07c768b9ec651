// Numbers of the branches of a change point: the same however the file is turned, mirrored, scaled or ordered; and
// positions on a change point that the motion reaches.
#include "engine/motion/branch_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "engine/file/units.hpp"
#include "engine/motion/branches.hpp"
#include "engine/motion/repositioned.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/sketch.hpp"

namespace kinegraph::branch_order_test {
namespace {

using sketch::Sketch;

/// A mechanism at a change point, to be written in any order.
struct Folded {
    struct Hinge {
        std::string point;
        std::vector<std::string> bodies;
    };
    std::map<std::string, Vector> points;
    std::vector<std::string> bodies;
    std::vector<Hinge> hinges;
    std::string slide;  ///< the point of a guide along +x, of body 4 on the frame; empty: none
    std::string driven;
};

/// Crank, coupler and rocker on one line; b, c and d may have any sign.
Folded folded_four_bar(int a, int b, int d, const std::string& driven) {
    return {{{"O2", {0, 0}}, {"A", {a, 0}}, {"B", {a + b, 0}}, {"O4", {d, 0}}},
            {"2", "3", "4"},
            {{"O2", {"1", "2"}}, {"A", {"2", "3"}}, {"B", {"3", "4"}}, {"O4", {"1", "4"}}},
            "",
            driven};
}
/// A slider-crank with links alike, its pin B on the crank's pivot.
Folded folded_slider_crank(int a, const std::string& driven) {
    return {{{"O2", {0, 0}}, {"A", {0, a}}, {"B", {0, 0}}, {"C", {0, 0}}},
            {"2", "3", "4"},
            {{"O2", {"1", "2"}}, {"A", {"2", "3"}}, {"B", {"3", "4"}}},
            "C",
            driven};
}

/// A file: the plane turned by (cos, sin), mirrored, scaled; in an order by the random numbers.
struct Writing {
    Vector turn{1, 0};
    bool mirrored = false;
    Exact scale = 1;
    Random* shuffled = nullptr;

    Sketch written(Folded of) const {
        Sketch file;
        std::vector<std::string> names;
        for (const auto& each : of.points) names.push_back(each.first);
        const auto shuffle = [&](auto& list) {
            for (std::size_t i = list.size(); shuffled != nullptr && i > 1; --i)
                std::swap(list[i - 1], list[static_cast<std::size_t>(shuffled->whole(0, static_cast<int>(i) - 1))]);
        };
        shuffle(names);
        shuffle(of.bodies);
        shuffle(of.hinges);
        const auto moved = [&](Vector place) {
            if (mirrored) place.y = -place.y;
            return scale * Vector{turn.x * place.x - turn.y * place.y, turn.y * place.x + turn.x * place.y};
        };
        for (const std::string& name : names) file.point(name, Coordinates{moved(of.points.at(name))});
        for (const std::string& name : of.bodies) file.body(name);
        for (Folded::Hinge& hinge : of.hinges) {
            shuffle(hinge.bodies);
            file.revolute(hinge.point, hinge.bodies);
        }
        if (!of.slide.empty()) file.prismatic(of.slide, {"4", "1"}, Bearing{turn});
        file.spin(of.driven, "1");
        return file;
    }
};

/// By branch: ω of each body over that of the driven one, or of the reference where the driven body rests.
std::vector<std::map<std::string, double>> branches_of(const Mechanism& mechanism, const Pose& pose) {
    std::vector<std::map<std::string, double>> found;
    for (const Branch& branch : instant_motion_of(mechanism, pose, mobility_of(mechanism, pose)).branches) {
        auto& ratios = found.emplace_back();
        for (const BodyIndex body : mechanism.moving_bodies())
            ratios[mechanism.body(body).name] = branch.ratios.empty() ? 0 : branch.ratios[at_index(body)];
    }
    return found;
}
/// The branch that a motion takes by itself, from 0; −1: none.
int taken(const Mechanism& mechanism, const Pose& pose) {
    const auto positions = Positions::of(mechanism, pose, 0);
    return positions && positions->branch() ? static_cast<int>(positions->branch()->index) : -1;
}

void expect_same_numbers(const Folded& folded, Random& random) {
    const Mechanism plain = Writing{}.written(folded).mechanism;
    const Pose pose = *draw_pose(plain);
    const auto expected = branches_of(plain, pose);
    const int expected_taken = taken(plain, pose);
    const std::vector<Vector> turns{{1, 0},
                                    {0, 1},
                                    {-1, 0},
                                    {Exact::ratio(4, 5), Exact::ratio(3, 5)},
                                    {Exact::ratio(-12, 13), Exact::ratio(-5, 13)}};
    for (const Vector& turn : turns)
        for (const bool mirrored : {false, true})
            for (int order = 0; order < 3; ++order) {
                const Writing writing{turn, mirrored, Exact::ratio(1 + order, 7), order == 0 ? nullptr : &random};
                const Mechanism other = writing.written(folded).mechanism;
                const Pose drawn = *draw_pose(other);
                const auto found = branches_of(other, drawn);
                ASSERT_EQ(found.size(), expected.size());
                for (std::size_t i = 0; i < found.size(); ++i)
                    for (const auto& [body, ratio] : expected[i])
                        EXPECT_NEAR(found[i].at(body), ratio, 1e-9 * std::max(1.0, std::abs(ratio)))
                            << "branch " << i + 1 << ", body " << body;
                EXPECT_EQ(taken(other, drawn), expected_taken)
                    << turn.x.to_double() << ", " << turn.y.to_double() << (mirrored ? " mirrored " : " ") << order;
            }
}

TEST(BranchOrder, NumbersDoNotDependOnHowTheFileIsTurnedOrOrdered) {
    Random random(11);
    int with_two = 0;
    for (int i = 0; i < 80; ++i) {
        const int a = random.whole(1, 9), b = random.whole(-9, 9), d = random.whole(-9, 9);
        if (b == 0 || d == 0 || a + b == d) continue;  // a link of no length
        const Folded folded = folded_four_bar(a, b, d, std::to_string(random.whole(2, 4)));
        const Mechanism plain = Writing{}.written(folded).mechanism;
        if (branches_of(plain, *draw_pose(plain)).size() != 2) continue;
        SCOPED_TRACE(std::to_string(a) + ", " + std::to_string(b) + ", " + std::to_string(d) + ", driver " +
                     folded.driven);
        expect_same_numbers(folded, random);
        ++with_two;
        if (HasFailure()) return;
    }
    EXPECT_GT(with_two, 20);
    for (const char* driven : {"2", "3"}) {
        SCOPED_TRACE(std::string("slider-crank, driver ") + driven);
        expect_same_numbers(folded_slider_crank(3, driven), random);
    }
}

TEST(BranchOrder, TheFirstBranchIsTheOneOnWhichTheBodiesMoveLeast) {
    // a = 1, b = 2: the parallelogram, not the crossed one with ω4/ω2 = −3.
    const Mechanism parallelogram = Writing{}.written(folded_four_bar(1, 2, 2, "2")).mechanism;
    const auto branches = branches_of(parallelogram, *draw_pose(parallelogram));
    ASSERT_EQ(branches.size(), 2U);
    EXPECT_NEAR(branches[0].at("4"), 1, 1e-12);
    EXPECT_NEAR(branches[1].at("4"), -3, 1e-12);
    // A rhombus: the crank rests on the second branch.
    const Mechanism rhombus = Writing{}.written(folded_four_bar(1, 1, 1, "2")).mechanism;
    const auto of_rhombus = branches_of(rhombus, *draw_pose(rhombus));
    ASSERT_EQ(of_rhombus.size(), 2U);
    EXPECT_NEAR(of_rhombus[0].at("2"), 1, 1e-12);
    EXPECT_NEAR(of_rhombus[1].at("2"), 0, 1e-12);
    EXPECT_EQ(taken(rhombus, *draw_pose(rhombus)), 0);
}

TEST(BranchOrder, MotionThatIsAlikeIsOrderedByProducts) {
    const BranchRank same{2, {0.25, 0.5}}, opposite{2, {0.25, -0.5}}, more{3, {0.25, 0.5}};
    EXPECT_TRUE(comes_before(same, opposite));
    EXPECT_FALSE(comes_before(opposite, same));
    EXPECT_TRUE(comes_before(opposite, more));
    EXPECT_FALSE(comes_before(same, same));
    EXPECT_TRUE(name_comes_before("9", "10"));
    EXPECT_TRUE(name_comes_before("a", "b"));
}

TEST(BranchOrder, APositionOnAChangePointIsTheOneDrawnThere) {
    // a + d = b + c: with the crank at 180° all links lie on one line. The crank is drawn at 180° − 60°.
    struct Lengths {
        int a, b, c, d;
    };
    for (const auto& [a, b, c, d] : {Lengths{2, 5, 4, 7}, Lengths{3, 3, 6, 6}, Lengths{4, 5, 3, 4}}) {
        SCOPED_TRACE(std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c));
        const auto text = [](int value) { return std::to_string(value); };
        Sketch s;
        s.point("O2", "0", "0").point("O4", text(d).c_str(), "0").polar("A", "O2", text(a).c_str(), "120");
        s.meet("B", s.circle("A", text(b).c_str()), s.circle("O4", text(c).c_str()), Meet::Side::left);
        s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
        s.spin("2", "1");
        const Pose pose = *draw_pose(s.mechanism);
        auto positions = *Positions::of(s.mechanism, pose, 0);
        const Exact coordinate = pi() / 3;
        ASSERT_TRUE(positions.move_to(coordinate.to_double()));
        ASSERT_TRUE(positions.is_singular());
        const auto moved = Mover(s.mechanism, pose).moved_across(positions, coordinate);
        ASSERT_TRUE(moved);
        for (const auto& [drawn, bits] : {std::pair(moved->pose, 100), std::pair(moved->finer, 200)}) {
            const Exact most = pose.size * Exact::power_of_two(-bits + 8);
            const Vector place = drawn.at(s["B"]) - Vector{b - a, 0};
            EXPECT_LT(abs(place.x) + abs(place.y), most) << bits << " bits";
        }
        const Mechanism there = Writing{}.written(folded_four_bar(-a, b, d, "2")).mechanism;
        const auto expected = branches_of(there, *draw_pose(there)), found = branches_of(moved->mechanism, moved->pose);
        ASSERT_EQ(expected.size(), 2U);
        ASSERT_EQ(found.size(), 2U);
        for (std::size_t i = 0; i < 2; ++i)
            for (const auto& [body, ratio] : expected[i]) EXPECT_NEAR(found[i].at(body), ratio, 1e-9);
    }
}

TEST(BranchOrder, ADeadPointHasNoPositionAcrossIt) {
    // a = 2, b = c = 1.2, d = 1: the crank stops where b and c lie on one line.
    Sketch s;
    s.point("O2", "0", "0").point("O4", "1", "0").polar("A", "O2", "2", "20");
    s.meet("B", s.circle("A", "1.2"), s.circle("O4", "1.2"), Meet::Side::left);
    s.revolute("O2", {"1", "2"}).revolute("A", {"2", "3"}).revolute("B", {"3", "4"}).revolute("O4", {"1", "4"});
    s.spin("2", "1");
    const Pose pose = *draw_pose(s.mechanism);
    auto positions = *Positions::of(s.mechanism, pose, 0);
    ASSERT_FALSE(positions.move_to(3));
    ASSERT_TRUE(positions.limit());
    const double limit = *positions.limit();
    ASSERT_TRUE(positions.move_to(limit - 1e-8));
    EXPECT_FALSE(Mover(s.mechanism, pose).moved_across(positions, Exact::from_double(limit - 1e-8)));
}

}  // namespace
}  // namespace kinegraph::branch_order_test
