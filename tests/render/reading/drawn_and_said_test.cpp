// What a student reads is what acts: loads that act and no others, ropes as lines, numbers that keep apart, every value
// that a truss begins with, two drivers of one point as two.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>

#include "engine/solution/sliding.hpp"
#include "lang/keys/sentences.hpp"
#include "render/figures/figure.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/truss_table.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/solved.hpp"

namespace drawn_and_said_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::tests;

/// Two panels, the second with crossed bars.
Solution crossed_truss() {
    return solved(
        R"({"kinegraph": 1, "frame": 1, "units": {"force": "kN"}, "points": {"A": [0, 0], "B": [4, 0], "C": [8, 0],
        "D": [0, 3], "E": [4, 3], "F": [8, 3]}, "bodies": {"2": ["A", "B"], "3": ["B", "C"], "4": ["D", "E"],
        "5": ["E", "F"], "6": ["A", "D"], "7": ["C", "F"], "8": ["A", "E"], "9": ["B", "D"], "10": ["B", "F"]},
        "joints": [{"revolute": "A", "bodies": [1, 2, 6, 8]}, {"revolute": "B", "bodies": [2, 3, 9, 10]},
        {"revolute": "C", "bodies": [3, 7]}, {"revolute": "D", "bodies": [4, 6, 9]}, {"revolute": "E",
        "bodies": [4, 5, 8]}, {"revolute": "F", "bodies": [5, 7, 10]}, {"contact": "C", "bodies": [3, 1],
        "tangent": 0, "pushes": [0, 1]}], "loads": [{"force": "F1", "pin": "E", "value": [0, -20]},
        {"force": "F2", "pin": "D", "value": [8, 0]}], "find": ["forces"]})");
}

TEST(DrawnAndSaid, ATrussWithoutPlanNamesTheBarsThatCross) {
    const Solution solution = crossed_truss();
    ASSERT_TRUE(solution.truss);
    EXPECT_EQ(
        std::count_if(solution.remarks.begin(), solution.remarks.end(),
                      [](const Message& remark) { return remark.sentence == lang::sentences::truss_with_crossing; }),
        1);
}

TEST(DrawnAndSaid, TheTableOfATrussHasEveryExternalForce) {
    const Theme theme;
    int trusses = 0;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        if (!solution.truss) continue;
        SCOPED_TRACE(name);
        ++trusses;
        const DrawingContext context{solution, theme, fonts(), Language::en};
        const std::vector<ResultRow> rows = truss_rows(context, {});
        for (const Truss::External& external : solution.truss->externals)
            EXPECT_EQ(
                std::count_if(rows.begin(), rows.end(),
                              [&](const ResultRow& row) { return name_of(row.symbol) == name_of(external.symbol); }),
                1)
                << name_of(external.symbol);
    }
    EXPECT_GT(trusses, 0);
}

TEST(DrawnAndSaid, NumbersOfAScaleBarKeepApart) {
    const Theme theme;
    for (const double scale : {0.1, 5.0, 100.0, 250.0, 5000.0})
        for (const double target : {4.0, 8.0, 20.0}) {
            std::vector<Mark> marks;
            draw_scale_bar(marks, fonts(), theme, Spot{0, 0}, target, scale, 1, "N", Language::en);
            std::vector<Box> texts;
            for (const Mark& mark : marks)
                if (const auto* text = std::get_if<TextMark>(&mark)) texts.push_back(pages::ink_of(*text));
            ASSERT_EQ(texts.size(), 2U);
            EXPECT_LT(texts[0].max.x + 0.5, texts[1].min.x) << scale << " in " << target;
        }
}

// A scale that is read off a ruler: docs/drawing.md has the series.
TEST(DrawnAndSaid, ScalesAreThoseOfTheSeries) {
    const std::set<std::string> of_drawings{"mechanism", "centres", "truss"};
    const std::set<std::string> of_polygons{"velocity", "acceleration", "forces", "closure"};
    int drawings = 0, polygons = 0;
    for (const std::string& name : example_names()) {
        if (!example(name).mechanism.scales.empty()) continue;
        for (const Page& page : laid_out(name))
            for (const Mark& mark : page.marks) {
                const auto* group = std::get_if<GroupBegin>(&mark);
                if (group == nullptr || group->cls != "figure") continue;
                const std::string *kind = group->attribute("data-figure"), *said = group->attribute("data-scale");
                if (kind == nullptr || said == nullptr) continue;
                const bool is_drawing = of_drawings.contains(*kind);
                if (!is_drawing && !of_polygons.contains(*kind)) continue;
                ++(is_drawing ? drawings : polygons);
                const double scale = std::strtod(said->c_str(), nullptr);
                const double digits = scale / std::pow(10, std::floor(std::log10(scale) + 1e-9));
                const auto is_digits = [&](double each) { return std::abs(digits - each) < 1e-9; };
                constexpr double standard[]{1, 2, 2.5, 5}, between[]{1.25, 1.5, 3, 4, 6, 8};
                EXPECT_TRUE(std::ranges::any_of(standard, is_digits) ||
                            (!is_drawing && std::ranges::any_of(between, is_digits)))
                    << name << " " << group->id.text() << " " << scale;
            }
    }
    EXPECT_GT(drawings, 50);
    EXPECT_GT(polygons, 100);
}

TEST(DrawnAndSaid, TwoDriversOfOnePointHaveNamesOfTheirOwn) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1, "units": {"length": "mm"},
        "points": {"O": [0, 0], "A": [100, 100], "P": [200, 0]},
        "bodies": {"2": ["O", "A"], "3": ["A", "P"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]}],
        "drivers": [{"body": 3, "at": "P", "along": 0, "speed": 0.1},
                    {"body": 3, "at": "P", "along": 90, "speed": -0.05}]})");
    std::vector<Symbol> given;
    for (const Driver& driver : solution.mechanism.drivers)
        given.push_back(along_drive(Symbol::Letter::v, std::get<PointDriver>(driver), solution.mechanism));
    ASSERT_EQ(given.size(), 2U);
    EXPECT_NE(name_of(given[0]), name_of(given[1]));
}

}  // namespace
}  // namespace drawn_and_said_test
