// The table of figures: what a row says of its kind holds for all that is drawn by it.
#include "render/figures/figure_table.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/support/pages.hpp"

namespace figure_table_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

/// The attribute of the outermost groups of class "figure".
std::set<std::string> data_of(const Figure& figure) {
    std::set<std::string> found;
    int depth = 0;
    for (const Mark& mark : figure.marks) {
        if (std::holds_alternative<GroupEnd>(mark)) --depth;
        const auto* group = std::get_if<GroupBegin>(&mark);
        if (group != nullptr && depth++ == 0 && group->cls == "figure") found.insert(*group->attribute("data-figure"));
    }
    return found;
}

std::string unit_of(const FigureTraits& traits, const Units& units) {
    switch (*traits.measured) {
        case QuantityKind::velocity: return units.velocity.symbol;
        case QuantityKind::acceleration: return units.acceleration.symbol;
        case QuantityKind::force: return units.force.symbol;
        default: return "m";
    }
}

void expect_as_its_row_says(const Shown& shown, FigureId id) {
    const FigureRow& row = row_of(id.kind);
    const Figure blank = begun(shown.context, id);
    const Figure figure = draw_figure(shown, id, {180, 130}, {0, size_of(shown, id).asked});
    EXPECT_EQ(figure.id, blank.id);
    EXPECT_EQ(legal_id(figure.id), figure.id);
    EXPECT_EQ(figure.data_figure, blank.data_figure);
    // The details of a polygon stand beside it.
    std::set<std::string> data = data_of(figure);
    data.erase("detail");
    EXPECT_EQ(data, std::set{blank.data_figure});
    EXPECT_EQ(figure.traits.measured, row.traits.measured);
    if (row.traits.measured) {
        EXPECT_EQ(figure.unit, unit_of(row.traits, shown.solution().mechanism.units));
    }
    EXPECT_FALSE(plain(figure.caption).empty());
    if (row.caption && !shown.solution().instantaneous_motion && id.part == all_loads) {
        EXPECT_TRUE(plain(figure.caption).starts_with(word(*row.caption, shown.context.language)))
            << plain(figure.caption);
    }
}

TEST(FigureTable, RowsSayWhatIsDrawn) {
    const Theme theme;
    std::set<FigureKind> seen;
    for (const char* name :
         {"four_bar", "exam_2001", "coupler_curve", "truss_roof_wind", "four_bar_inertia", "virtual_work",
          "three_hinged_arch", "slider_crank_long_crank", "moving_frame", "pliers"}) {
        SCOPED_TRACE(name);
        const Solution& solution = example(name);
        const DrawingContext context{solution, theme, fonts(), Language::en};
        const Shown shown(context, false, true);
        std::set<std::string> found;
        for (const FigureId id : all_figures(shown)) {
            SCOPED_TRACE(name_of(solution, id));
            EXPECT_TRUE(found.insert(name_of(solution, id)).second);
            expect_as_its_row_says(shown, id);
            seen.insert(id.kind);
        }
    }
    // Every kind that can stand in a list was seen.
    for (const FigureRow& row : figure_table) EXPECT_EQ(seen.contains(row.kind), row.by != nullptr) << row.key;
}

TEST(FigureTable, ABriefSolutionShowsNoMoreThanTheWholeOne) {
    const Theme theme;
    const Solution& solution = example("exam_2001");
    const DrawingContext context{solution, theme, fonts(), Language::en};
    const std::vector<FigureId> whole = all_figures(Shown(context)), brief = all_figures(Shown(context, true));
    const auto names = [&](const std::vector<FigureId>& all) {
        std::set<std::string> found;
        // The mechanism has its centres only if the file asks for them.
        for (const FigureId id : all)
            if (id.kind != FigureKind::mechanism && id.kind != FigureKind::centres) found.insert(name_of(solution, id));
        return found;
    };
    ASSERT_GT(brief.size(), 3U);
    EXPECT_LT(names(brief).size(), names(whole).size());
    for (const std::string& each : names(brief)) EXPECT_TRUE(names(whole).contains(each)) << each;
}

TEST(FigureTable, ALoadCaseHasItsOwnFigures) {
    const Solution& solution = example("four_bar_inertia");
    ASSERT_GT(parts_of(solution), 1);
    for (int part = 0; part < parts_of(solution); ++part) {
        const LoadCase loads(solution, part);
        EXPECT_EQ(name_of(solution, {FigureKind::lines_of_action, -1, part}), "lines-load-" + loads.load());
        EXPECT_EQ(name_of(solution, {FigureKind::forces, -1, part}), "forces-load-" + loads.load());
        EXPECT_EQ(loads.bodies().data(), solution.superposition->parts[static_cast<std::size_t>(part)].bodies.data());
    }
    EXPECT_EQ(LoadCase(solution).bodies().data(), solution.free_bodies.data());
}

}  // namespace
}  // namespace figure_table_test
