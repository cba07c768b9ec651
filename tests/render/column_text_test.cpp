// Text in columns, and equations in a corner of a figure: what stands where in a given room.
#include "render/layout/column_text.hpp"

#include <gtest/gtest.h>

#include "render/layout/free_corner.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double wide = 50;

Block bar(double height) {
    Block block;
    block.width = wide;
    block.height = height;
    block.marks.emplace_back(line({0, 0}, {wide, 0}, {0.2, {}, {}, false}));
    return block;
}
/// Passages of three rows of 5 mm.
ColumnText text_of(int passages) {
    std::vector<Passage> all;
    for (int i = 0; i < passages; ++i) all.emplace_back().take_rows({bar(5), bar(5), bar(5)});
    return {std::move(all), wide, 1, false};
}
std::vector<double> tops(const ColumnText& text, double room) {
    std::vector<Mark> marks;
    text.set(marks, {0, 0}, 1, 0, 0, room);
    std::vector<double> all;
    for (const Mark& mark : marks) all.push_back(box_of(std::span(&mark, 1)).min.y);
    return all;
}

TEST(ColumnText, WhiteSpacesItsPassagesNotTheirRows) {
    const ColumnText text = text_of(3);
    const std::vector<double> close = tops(text, text.height(1)), spaced = tops(text, text.height(1) + 30);
    ASSERT_EQ(close.size(), 9U);
    ASSERT_EQ(spaced.size(), 9U);
    for (std::size_t i = 0; i < close.size(); ++i)
        EXPECT_NEAR(spaced[i] - close[i], 10.0 * static_cast<double>(i / 3), 1e-9) << "a third of the white, row " << i;
}

TEST(ColumnText, StaysInItsRoom) {
    const ColumnText text = text_of(4);
    for (double more = 0; more < 200; more += 7) {
        const std::vector<double> all = tops(text, text.height(1) + more);
        EXPECT_LE(all.back() + 5, text.height(1) + more + 1e-9);
        EXPECT_EQ(all.front(), tops(text, text.height(1)).front());
    }
}

/// What is said to have room has it, also where the edge of a stroke is outside of the figure's box.
TEST(FreeCorner, IsAsWideAsItIsSaidToBe) {
    for (const double outside : {0.0, 0.2, 0.45})
        for (const double height : {20.0, 38.0}) {
            Figure figure;
            figure.box = rectangle(0, 0, 70, 40);
            const Pen pen{0.2, {}, {}, false};
            figure.marks.emplace_back(line({-outside, 0}, {70 + outside, 40}, pen));
            figure.marks.emplace_back(line({-outside, 40}, {70 + outside, 0}, pen));
            const Block block = bar(height);
            const double wider = width_beside(figure, block);
            const Box room = rectangle(0, 0, figure.box.width() + wider, figure.box.height());
            std::vector<Mark> marks;
            EXPECT_TRUE(set_beside(marks, figure, block, room)) << outside << " outside, " << height << " high";
        }
}

}  // namespace
}  // namespace kinegraph::render
