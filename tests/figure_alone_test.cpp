// Figures alone: every figure of every example stands on a page of its own that holds all of it.
#include "render/figure_alone.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "constructions/solve.hpp"
#include "render/shapes.hpp"

namespace {

using namespace kinegraph;
using namespace kinegraph::render;

const Fonts& fonts() {
    static const Fonts opened = std::move(*Fonts::open());
    return opened;
}

Solution example(const std::string& name) {
    std::ifstream file(std::filesystem::path(KINEGRAPH_EXAMPLES_DIR) / name);
    std::stringstream text;
    text << file.rdbuf();
    auto solution = solve(*read_mechanism(text.str(), name));
    return *std::move(solution);
}

std::vector<std::string> example_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(KINEGRAPH_EXAMPLES_DIR))
        if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

class FigureAlone : public testing::TestWithParam<std::string> {};

TEST_P(FigureAlone, IsWholeAndOnAPageOfItsSize) {
    const Solution solution = example(GetParam() + ".json");
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
        int depth = 0, figures = 0;
        std::set<std::string> ids;
        for (const Mark& mark : page->marks) {
            if (const auto* group = std::get_if<GroupBegin>(&mark)) {
                ++depth;
                figures += group->cls == "figure" ? 1 : 0;
                EXPECT_TRUE(group->id.empty() || ids.insert(group->id).second) << group->id;
            }
            if (std::holds_alternative<GroupEnd>(mark)) --depth;
        }
        EXPECT_EQ(depth, 0);
        EXPECT_GE(figures, 1);
    }
}
INSTANTIATE_TEST_SUITE_P(Examples, FigureAlone, testing::ValuesIn(example_names()),
                         [](const testing::TestParamInfo<std::string>& each) { return each.param; });

TEST(FigureAloneNames, AreThoseOfTheSolution) {
    const Solution solution = example("four_bar_weights.json");
    const std::vector<std::string> names = figure_names(solution, {}, fonts());
    for (const char* name :
         {"mechanism", "centres", "velocity", "acceleration", "lines-of-action", "forces", "closure", "body-3"})
        EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
    EXPECT_FALSE(lay_out_alone(solution, {}, "Velocity", fonts()));
    EXPECT_FALSE(lay_out_alone(solution, {}, "", fonts()));
}

TEST(FigureAloneNames, MechanismIsDrawnWithoutItsCentres) {
    const Solution solution = example("four_bar.json");
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
