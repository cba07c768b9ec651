// Polygon figures: what is measured on paper is the result.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <set>

#include "render/figure.hpp"
#include "tests/fonts.hpp"
#include "tests/solved.hpp"

namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::tests;

std::string attribute(const GroupBegin& group, const std::string& key) {
    for (const auto& [name, value] : group.attributes)
        if (name == key) return value;
    return {};
}

/// Every vector group of a figure with its axes.
struct Measured {
    GroupBegin group;
    std::vector<Axis> axes;
};
std::vector<Measured> vectors_of(const Figure& figure) {
    std::vector<Measured> result;
    for (const Mark& mark : figure.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark))
            if (group->cls == "vector") result.push_back({*group, {}});
        if (const auto* axis = std::get_if<Axis>(&mark)) result.back().axes.push_back(*axis);
    }
    return result;
}

void expect_measures(const Figure& figure) {
    std::set<std::string> names, ids;
    for (const Measured& each : vectors_of(figure)) {
        ASSERT_EQ(each.axes.size(), 1u) << each.group.id;
        const double value = std::strtod(attribute(each.group, "data-value").c_str(), nullptr);
        const Spot along{each.axes[0].tip.x - each.axes[0].tail.x, each.axes[0].tip.y - each.axes[0].tail.y};
        EXPECT_GT(value, 0);
        EXPECT_NEAR(std::hypot(along.x, along.y), value / figure.scale, 1e-6) << each.group.id;
        EXPECT_TRUE(names.insert(attribute(each.group, "data-name")).second) << "twice: " << each.group.id;
        EXPECT_TRUE(ids.insert(each.group.id).second);
        EXPECT_EQ(each.group.id.rfind(figure.id + "-", 0), 0u) << each.group.id;
    }
}

TEST(PolygonFigure, EveryAxisIsValueOverScaleOnEveryExample) {
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution solution = example(name);
        const Theme theme;
        const DrawingContext context{solution, theme, fonts(), Language::en};
        for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p)
            expect_measures(polygon_figure(context, static_cast<int>(p), 150, 130));
    }
}

TEST(PolygonFigure, OfTheFourBarShowsItsVectors) {
    const Solution solution = example("four_bar");
    const Theme theme;
    const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, 0, 150, 100);
    std::set<std::string> names;
    for (const Measured& each : vectors_of(figure)) names.insert(attribute(each.group, "data-name"));
    EXPECT_EQ(names, (std::set<std::string>{"v_A", "v_B", "v_BA"}));
    EXPECT_EQ(figure.kind, "velocity");
    EXPECT_EQ(figure.id, "velocity");
    EXPECT_EQ(figure.unit, "m/s");
    EXPECT_EQ(plain(figure.caption), "Velocity polygon");
    const auto* group = std::get_if<GroupBegin>(&figure.marks.front());
    ASSERT_NE(group, nullptr);
    EXPECT_EQ(attribute(*group, "data-figure"), "velocity");
    EXPECT_EQ(attribute(*group, "data-unit"), "m/s");
    EXPECT_TRUE(std::holds_alternative<GroupEnd>(figure.marks.back()));
}

TEST(PolygonFigure, KeepsToItsRoom) {
    const Solution solution = example("four_bar");
    const Theme theme;
    for (const double room : {60.0, 90.0, 140.0, 220.0})
        for (int p = 0; p < 2; ++p) {
            const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, p, room, 0.8 * room);
            EXPECT_LE(figure.box.width(), room) << room;
            EXPECT_LE(figure.box.height(), 0.8 * room) << room;
        }
}

TEST(PolygonFigure, TakesTheFilesUnitAndScale) {
    Solution solution = example("four_bar");
    solution.mechanism.units.velocity = {"mm/s", Exact::ratio(1, 1000)};
    solution.mechanism.scales.push_back({"velocity", Exact::ratio(1, 100), ""});  // 0.01 m/s = 10 mm/s
    const Theme theme;
    const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, 0, 200, 150);
    EXPECT_EQ(figure.unit, "mm/s");
    EXPECT_DOUBLE_EQ(figure.scale, 10);
    expect_measures(figure);
}

TEST(PolygonFigure, ImagesAtThePoleStandWithIt) {
    const Solution solution = example("four_bar");
    const Theme theme;
    const Figure figure = polygon_figure({solution, theme, fonts(), Language::en}, 0, 150, 100);
    bool found = false;
    for (const Mark& mark : figure.marks)
        if (const auto* text = std::get_if<TextMark>(&mark)) found = found || text->words == "o_v ≡ o_2 ≡ o_4";
    EXPECT_TRUE(found);
}

}  // namespace
