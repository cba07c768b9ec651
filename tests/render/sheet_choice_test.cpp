// Sheet choice: fuller pages and fewer of them are taken, but not for figures that are much smaller.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "render/layout/sheet_choice.hpp"
#include "render/page/shapes.hpp"

namespace {

using namespace kinegraph;
using namespace kinegraph::render;

const Box frame = rectangle(0, 0, 102.5, 102.5);  // with what is off its line ten squares each way

/// Inked from the top down to a share of the frame.
Page page_filled_to(double share) {
    Page page;
    const double low = 1 + share * 100;
    if (share > 0)
        page.marks.emplace_back(tinted(filled({{1, 1}, {101, 1}, {101, low - 0.5}, {1, low - 0.5}}, {200, 220, 240})));
    return page;
}

Figure figure(const std::string& id, const std::string& kind, double size) {
    Figure figure;
    figure.id = id;
    figure.kind = kind;
    figure.box = rectangle(0, 0, size, 0.5 * size);
    return figure;
}

DrawnSheet sheet(const std::vector<double>& fills, double mechanism, double polygon) {
    DrawnSheet sheet;
    for (const double fill : fills) sheet.pages.push_back(page_filled_to(fill));
    sheet.figures = {figure("mechanism", "mechanism", mechanism), figure("velocity", "velocity", polygon)};
    return sheet;
}

/// How many pages the better of two has, and how large its polygon is.
std::pair<std::size_t, double> better(DrawnSheet one, DrawnSheet other) {
    SheetChoice choice(frame);
    choice.offer(std::move(one));
    choice.offer(std::move(other));
    const DrawnSheet best = std::move(choice).best();
    return {best.pages.size(), best.figures[1].box.width()};
}

TEST(SheetChoice, MeasuresTheShareOfSquaresWithInk) {
    for (const double share : {0.0, 0.3, 0.5, 1.0}) EXPECT_DOUBLE_EQ(fill_of(page_filled_to(share), frame), share);
    EXPECT_EQ(fill_of(page_filled_to(0), rectangle(0, 0, 5, 5)), 1);
}

TEST(SheetChoice, IsContentWithFullPagesButTheLast) {
    const auto is_settled = [](const std::vector<double>& fills) {
        SheetChoice choice(frame);
        choice.offer(sheet(fills, 80, 80));
        return choice.is_settled();
    };
    EXPECT_TRUE(is_settled({0.1}));
    EXPECT_TRUE(is_settled({0.8, 0.9, 0.1}));
    EXPECT_FALSE(is_settled({0.8, 0.5, 0.9}));
}

TEST(SheetChoice, TakesFewerPagesAndFullerOnes) {
    EXPECT_EQ(better(sheet({0.7, 0.3}, 80, 80), sheet({0.9}, 75, 75)), std::pair(std::size_t{1}, 75.0));
    EXPECT_EQ(better(sheet({0.5, 0.8}, 80, 80), sheet({0.7, 0.6}, 78, 78)), std::pair(std::size_t{2}, 78.0));
}

TEST(SheetChoice, TakesLargerFiguresOnAsFullPages) {
    EXPECT_EQ(better(sheet({0.7, 0.3}, 60, 60), sheet({0.7, 0.3}, 60, 75)).second, 75);
    EXPECT_EQ(better(sheet({0.7, 0.3}, 60, 75), sheet({0.7, 0.3}, 60, 60)).second, 75);
}

TEST(SheetChoice, TakesNoPageMoreAndNoFiguresThatAreMuchSmaller) {
    EXPECT_EQ(better(sheet({0.5, 0.3}, 60, 60), sheet({0.9, 0.9, 0.3}, 80, 80)).first, 2U);
    EXPECT_EQ(better(sheet({0.4, 0.3}, 80, 80), sheet({0.9}, 44, 44)).first, 2U) << "both";
    EXPECT_EQ(better(sheet({0.4, 0.3}, 80, 80), sheet({0.9}, 100, 30)).first, 2U) << "a polygon";
    EXPECT_EQ(better(sheet({0.4, 0.3}, 80, 80), sheet({0.9}, 30, 100)).first, 1U)
        << "a mechanism, and the polygon is larger";
}

TEST(SheetChoice, TakesNoneWhoseFiguresLeaveTheirRooms) {
    DrawnSheet fuller = sheet({0.9}, 80, 80);
    fuller.keeps_to_rooms = false;
    EXPECT_EQ(better(sheet({0.4, 0.3}, 80, 80), fuller).first, 2U);
    SheetChoice choice(frame);
    choice.offer(std::move(fuller));
    EXPECT_TRUE(choice.is_settled()) << "another would be no better";
}

/// The mechanism and, on a page of its own, the mechanism with its lines of action.
TEST(SheetChoice, LooksAtBothFiguresOfOneName) {
    const auto with_lines_of_action = [](DrawnSheet sheet, double mechanism, double polygon) {
        sheet.figures.insert(sheet.figures.begin(),
                             {figure("mechanism", "mechanism", mechanism), figure("velocity", "velocity", polygon)});
        return sheet;
    };
    EXPECT_EQ(better(with_lines_of_action(sheet({0.4, 0.3}, 80, 80), 80, 80),
                     with_lines_of_action(sheet({0.9}, 80, 80), 80, 30))
                  .first,
              2U);
}

}  // namespace
