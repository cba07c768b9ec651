// Figures alone: every figure of every example stands on a page of its own that holds all of it.
#include "render/sheet/figure_alone.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/pages.hpp"

namespace figure_alone_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;

using namespace kinegraph::pages;

class FigureAlone : public testing::TestWithParam<std::string> {};

TEST_P(FigureAlone, IsWholeAndOnAPageOfItsSize) {
    const Solution& solution = example(GetParam());
    SheetOptions options;
    options.joukowsky = true;
    const std::vector<std::string> names = figure_names(solution, options, fonts());
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    for (const std::string& name : names) {
        SCOPED_TRACE(name);
        const auto page = lay_out_alone(solution, options, name, fonts());
        ASSERT_TRUE(page);
        const Box box = box_of(page->marks);
        EXPECT_NEAR(box.min.x, 4, 1e-6);
        EXPECT_NEAR(box.min.y, 4, 1e-6);
        EXPECT_NEAR(box.max.x, page->width - 4, 1e-6);
        EXPECT_NEAR(box.max.y, page->height - 4, 1e-6);
        expect_sound_groups(*page);
        const auto figures = std::count_if(page->marks.begin(), page->marks.end(), [](const Mark& mark) {
            const auto* group = std::get_if<GroupBegin>(&mark);
            return group && group->cls == "figure";
        });
        EXPECT_GE(figures, 1);
    }
}
INSTANTIATE_TEST_SUITE_P(Examples, FigureAlone, testing::ValuesIn(example_names()),
                         [](const testing::TestParamInfo<std::string>& each) { return each.param; });

TEST(FigureAloneNames, AreThoseOfTheSolution) {
    const Solution& solution = example("four_bar_weights");
    const std::vector<std::string> names = figure_names(solution, {}, fonts());
    for (const char* name :
         {"mechanism", "centres", "velocity", "acceleration", "lines-of-action", "forces", "closure", "body-3"})
        EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
    EXPECT_FALSE(lay_out_alone(solution, {}, "Velocity", fonts()));
    EXPECT_FALSE(lay_out_alone(solution, {}, "", fonts()));
}

TEST(FigureAloneNames, MechanismIsDrawnWithoutItsCentres) {
    const Solution& solution = example("four_bar");
    const auto centres = [](const Page& page) {
        return std::count_if(page.marks.begin(), page.marks.end(), [](const Mark& mark) {
            const auto* group = std::get_if<GroupBegin>(&mark);
            return group && group->cls == "centre";
        });
    };
    EXPECT_EQ(centres(*lay_out_alone(solution, {}, "mechanism", fonts())), 0);
    EXPECT_EQ(centres(*lay_out_alone(solution, {}, "centres", fonts())), 6);
}

}  // namespace
}  // namespace figure_alone_test
