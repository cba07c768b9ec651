// The ink map: how far an upright box must go until it has left the ink under it.
#include <gtest/gtest.h>

#include <random>

#include "render/page/ink_map.hpp"

namespace kinegraph::render::ink_map_test {
namespace {

class Random {
public:
    double between(double from, double to) { return std::uniform_real_distribution(from, to)(engine_); }
    Spot spot() { return {between(0, 60), between(0, 40)}; }
    InkBox upright() { return {spot(), {between(0.3, 8), between(0.3, 4)}}; }

private:
    std::mt19937 engine_{7};
};

InkBox moved(InkBox box, Spot by) {
    box.centre = box.centre + by;
    return box;
}

constexpr Box sheet{{0, 0}, {60, 40}};

TEST(InkMap, ABoxOnItsWayOutOfInkTouchesItAllTheWay) {
    Random random;
    int met = 0;
    for (int map_number = 0; map_number < 20; ++map_number) {
        InkMap map(sheet);
        for (int i = 0; i < 6; ++i) map.stroke(random.spot(), random.spot(), 0.2);
        for (int i = 0; i < 200; ++i) {
            const InkBox box = random.upright();
            const auto right = map.way_right(box), down = map.way_down(box);
            ASSERT_EQ(right.has_value(), map.touches(box));
            ASSERT_EQ(down.has_value(), map.touches(box));
            if (!right) continue;
            ++met;
            for (const double share : {0.25, 0.5, 0.999}) {
                EXPECT_TRUE(map.touches(moved(box, {share * *right, 0})));
                EXPECT_TRUE(map.touches(moved(box, {0, share * *down})));
            }
        }
    }
    EXPECT_GT(met, 1000);
}

TEST(InkMap, ABoxThatHasLeftADotIsFree) {
    Random random;
    int met = 0;
    for (int i = 0; i < 500; ++i) {
        InkMap map(sheet);
        const InkBox box = random.upright().grown(1);
        // All of the dot lies in the box: what sticks out would be met on the way.
        const Spot room = box.half - Spot{0.6, 0.6};
        const Spot dot = box.centre + Spot{random.between(-1, 1) * room.x, random.between(-1, 1) * room.y};
        map.stroke(dot, dot, 0.2);
        const auto right = map.way_right(box), down = map.way_down(box);
        if (!right || !down) continue;
        ++met;
        EXPECT_FALSE(map.touches(moved(box, {*right + 1e-6, 0})));
        EXPECT_FALSE(map.touches(moved(box, {0, *down + 1e-6})));
    }
    EXPECT_GT(met, 300);
}

}  // namespace
}  // namespace kinegraph::render::ink_map_test
