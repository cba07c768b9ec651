// What a figure of a motion shows: positions at even steps from end to end, and paths without corners.
#include "constructions/positions/drawn_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "constructions/positions/cycle.hpp"
#include "engine/mechanism/drivers.hpp"
#include "tests/support/files.hpp"

namespace kinegraph::drawn_motion_test {
namespace {

constexpr double pi_ = std::numbers::pi;
using Spot = VectorOf<double>;

double length_of(const Spot& a) { return std::sqrt(squared_length(a)); }
Spot rough(const Vector& a) { return {a.x.to_double(), a.y.to_double()}; }

struct Moving {
    Mechanism mechanism;
    Pose pose;
    Positions positions;
    Travel travel;
};
/// Calls `see` for each example that has a travel of its own.
void for_each_moving(const std::function<void(Moving& moving)>& see) {
    for (const std::string& name : tests::example_names()) {
        auto mechanism = read_mechanism(tests::contents(tests::example_file(name)), name + ".json");
        if (!mechanism) continue;
        auto pose = draw_pose(*mechanism);
        if (!pose) continue;
        auto own = own_travel(*mechanism, *pose);
        if (!own) continue;
        Moving moving{*std::move(mechanism), *std::move(pose), std::move(own->first), own->second};
        SCOPED_TRACE(name);
        see(moving);
    }
}
Moving example(const std::string& name, std::optional<double> from, std::optional<double> to) {
    auto mechanism = *read_mechanism(tests::contents(tests::example_file(name)), name + ".json");
    auto pose = *draw_pose(mechanism);
    auto positions = *Positions::of(mechanism, pose, 0);
    const Travel travel = *travel_of(positions, turns(mechanism.drivers.front()), from, to);
    return {std::move(mechanism), std::move(pose), std::move(positions), travel};
}

TEST(DrawnMotion, PositionsStandAtEvenStepsFromLimitToLimit) {
    int all = 0, with_limits = 0;
    for_each_moving([&](Moving& moving) {
        const Travel& travel = moving.travel;
        constexpr int count = 7;
        const auto others = other_positions(moving.positions, travel, count);
        ASSERT_EQ(others.size(), static_cast<std::size_t>(count));
        const bool has_limits = travel.starts_at_limit || travel.ends_at_limit;
        // After a whole turn the last position would lie on the first.
        const double step = others[1].coordinate - others[0].coordinate, whole = travel.to - travel.from;
        EXPECT_NEAR(others.front().coordinate, travel.from, 1e-12);
        EXPECT_TRUE(!has_limits || std::abs(others.back().coordinate - travel.to) < 1e-9);
        EXPECT_TRUE(std::abs(count * step - whole) < 1e-9 || std::abs((count - 1) * step - whole) < 1e-9);
        for (std::size_t i = 1; i < others.size(); ++i)
            EXPECT_NEAR(others[i].coordinate - others[i - 1].coordinate, step, 1e-9);
        ++all;
        with_limits += has_limits ? 1 : 0;
    });
    EXPECT_GT(all, 40);
    EXPECT_GT(with_limits, 17);
}

TEST(DrawnMotion, TheDriverIsWhereItsCoordinateSaysAndHingesHold) {
    int turned = 0, hinges = 0;
    for_each_moving([&](Moving& moving) {
        const double size = moving.pose.size.to_double();
        const auto* spin = std::get_if<SpinDriver>(&moving.mechanism.drivers.front());
        for (const OtherPosition& other : other_positions(moving.positions, moving.travel, 6)) {
            if (spin != nullptr && spin->relative_to == frame) {
                const Spot& facing = other.bodies[at_index(spin->body)].facing;
                EXPECT_NEAR(std::remainder(std::atan2(facing.y, facing.x) - other.coordinate, 2 * pi_), 0, 1e-7);
                ++turned;
            }
            for (const Joint& joint : moving.mechanism.joints) {
                if (!joint.pair().is_hinge()) continue;
                const Spot drawn = rough(moving.pose.at(joint.point));
                const Spot first = other.bodies[at_index(joint.bodies[0])](drawn);
                for (const BodyIndex body : joint.bodies)
                    EXPECT_LT(length_of(other.bodies[at_index(body)](drawn) - first), 1e-6 * size) << joint.name;
                ++hinges;
            }
        }
    });
    EXPECT_GT(turned, 100);
    EXPECT_GT(hinges, 500);
}

TEST(DrawnMotion, AGivenRangeIsDrawnFromEndToEnd) {
    Moving moving = example("four_bar", 0, pi_ / 2);
    const auto others = other_positions(moving.positions, moving.travel, 4);
    ASSERT_EQ(others.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(others[i].coordinate, static_cast<double>(i) * pi_ / 6, 1e-12);
    // Two turns lead back; one and a half do not.
    Moving two = example("four_bar", 0, 4 * pi_);
    EXPECT_NEAR(other_positions(two.positions, two.travel, 4).back().coordinate, 3 * pi_, 1e-12);
    Moving more = example("four_bar", 0, 3 * pi_);
    EXPECT_NEAR(other_positions(more.positions, more.travel, 4).back().coordinate, 3 * pi_, 1e-12);
    EXPECT_EQ(other_positions(moving.positions, moving.travel, 1).size(), 1U);
    EXPECT_TRUE(other_positions(moving.positions, moving.travel, 0).empty());
}

TEST(DrawnMotion, PathsHaveNoCornersWhereTheyAreFast) {
    std::size_t paths = 0;
    for_each_moving([&](Moving& moving) {
        std::vector<TracedPoint> points;
        for (const Joint& joint : moving.mechanism.joints)
            if (joint.pair().is_hinge() && !joint.connects(frame)) points.push_back({joint.point});
        const double size = moving.pose.size.to_double();
        for (const auto& pieces : paths_of(moving.positions, moving.travel, points))
            for (const PathPlaces& path : pieces) {
                ++paths;
                for (std::size_t i = 1; i + 1 < path.size(); ++i) {
                    const Spot before = path[i] - path[i - 1], after = path[i + 1] - path[i];
                    EXPECT_LT(length_of(before), 0.03 * size);
                    const double turn = std::abs(std::atan2(cross(before, after), dot(before, after)));
                    // A turn is seen if both chords are: half a millimetre where the drawing has 100.
                    const double shorter = std::min(length_of(before), length_of(after));
                    EXPECT_LT(std::min(turn, pi_ - turn) * shorter, 1e-3 * size)
                        << "place " << i << " of " << path.size();
                }
            }
    });
    EXPECT_GT(paths, 80U);
}

TEST(DrawnMotion, APathEndsWhereTheDriverStops) {
    // A crank longer than the rod: the slider-crank stops where the rod is upright on the guide.
    Moving moving = example("slider_crank_long_crank", {}, {});
    ASSERT_TRUE(moving.travel.starts_at_limit && moving.travel.ends_at_limit);
    const PointIndex b = *moving.mechanism.point_named("B"), a = *moving.mechanism.point_named("A");
    const auto paths = paths_of(moving.positions, moving.travel, {{a}, {b}});
    ASSERT_EQ(paths.size(), 2U);
    ASSERT_EQ(paths[0].size(), 1U);
    const double size = moving.pose.size.to_double();
    for (const bool start : {true, false}) {
        const Spot at_a = start ? paths[0][0].front() : paths[0][0].back(),
                   at_b = start ? paths[1][0].front() : paths[1][0].back();
        EXPECT_NEAR(at_a.x, at_b.x, 1e-6 * size);
    }
}

}  // namespace
}  // namespace kinegraph::drawn_motion_test
