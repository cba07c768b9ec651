// Figures of a page move within their rooms, so that white stands in smaller pieces.
#include "render/layout/spread_figures.hpp"

#include <gtest/gtest.h>

#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

/// A page with a square of 60 mm in its left upper corner, and text along its right edge.
class SpreadFigures : public testing::Test {
protected:
    static constexpr double side = 60;
    Box content = rectangle(0, 0, 250, 180);
    std::vector<Mark> marks{outline(0, 0, side), outline(190, 0, side)};

    static Mark outline(double x, double y, double size) {
        return polyline({{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}, {0.3, {}, {}, false}, true);
    }
    Box figure() const { return box_of(std::span(marks).first(1)); }
};

TEST_F(SpreadFigures, AFigureMovesTowardsTheMiddleOfItsWhite) {
    const Box before = figure();
    spread(marks, {{0, 1, 0, 120, 0, 120}}, content, rectangle(190, 60, 250, 180));
    EXPECT_GT(figure().min.x, before.min.x + 10);
}

// However often it moves: rooms of many sizes, in which it moves once or several times.
TEST_F(SpreadFigures, ItStaysInItsRoom) {
    int moved = 0;
    for (double right = 0; right <= 120; right += 10)
        for (double down = 0; down <= 120; down += 10) {
            std::vector<Mark> own = marks;
            const Box before = figure();
            const std::vector<Spot> by = spread(own, {{0, 1, 0, right, 0, down}}, content, {});
            const Box after = box_of(std::span(own).first(1));
            EXPECT_GE(after.min.x, before.min.x);
            EXPECT_LE(after.max.x, before.max.x + right);
            EXPECT_GE(after.min.y, before.min.y);
            EXPECT_LE(after.max.y, before.max.y + down);
            EXPECT_NEAR(after.min.x - before.min.x, by.at(0).x, 1e-9);
            EXPECT_NEAR(after.min.y - before.min.y, by.at(0).y, 1e-9);
            moved += length(by.at(0)) > 0 ? 1 : 0;
        }
    EXPECT_GT(moved, 20) << "the test shows what it says";
}

TEST_F(SpreadFigures, NothingElseMoves) {
    const Box before = box_of(std::span(marks).last(1));
    spread(marks, {{0, 1, 0, 120, 0, 120}}, content, {});
    const Box after = box_of(std::span(marks).last(1));
    EXPECT_EQ(after.min.x, before.min.x);
    EXPECT_EQ(after.min.y, before.min.y);
}

TEST_F(SpreadFigures, AFullPageIsLeftAsItIs) {
    for (double y = 0; y < 180; y += 20)
        for (double x = 0; x < 250; x += 20) marks.push_back(outline(x, y, 15));
    const Box before = figure();
    spread(marks, {{0, 1, 0, 120, 0, 120}}, content, {});
    EXPECT_EQ(figure().min.x, before.min.x);
    EXPECT_EQ(figure().min.y, before.min.y);
}

}  // namespace
}  // namespace kinegraph::render
