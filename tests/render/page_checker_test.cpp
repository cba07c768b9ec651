// The page checker: what it calls a fault is one, and what is clear by a hair is none.
#include "tests/support/page_checker.hpp"

#include <gtest/gtest.h>

#include "render/page/shapes.hpp"
#include "tests/support/pages.hpp"

namespace kinegraph::render::page_checker_test {
namespace {

using tests::fonts;

/// A label and a link 2 mm wide that passes the box of its ink at the lower right corner, in the direction given.
std::vector<Fault> beside_a_corner(Spot along, double clear) {
    Page page;
    page.marks = {polyline({{0, 0}, {297, 0}, {297, 210}, {0, 210}}, {}, true),
                  GroupBegin{"", GroupId("mechanism"), "", {{"data-figure", ""}}}};
    set_text(page.marks, fonts().shape(one_piece("J", Face::italic), 11), {100, 100}, {}, "label");
    const Spot corner = pages::ink_of(std::get<TextMark>(page.marks.back())).max;
    const Spot on_axis = corner + (1 + clear) * turned(-1.0 * unit(along));
    page.marks.emplace_back(line(on_axis - 20 * unit(along), on_axis + 20 * unit(along), {2, {}, {}, false}));
    page.marks.emplace_back(GroupEnd{});
    return faults_of(page, fonts());
}

TEST(PageChecker, AStrokeIsAsWideAsItsPenInEveryDirection) {
    for (const Spot along : {Spot{-1, 1}, Spot{-1, 3}, Spot{-3, 1}, Spot{-1, 0.01}}) {
        EXPECT_TRUE(beside_a_corner(along, 0.02).empty()) << along.x << ' ' << along.y;
        const std::vector<Fault> covered = beside_a_corner(along, -0.02);
        ASSERT_EQ(covered.size(), 1U) << along.x << ' ' << along.y;
        EXPECT_EQ(covered.front().kind, Fault::Kind::label_on_mechanism);
    }
}

}  // namespace
}  // namespace kinegraph::render::page_checker_test
