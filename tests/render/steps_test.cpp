// Steps: every page adds to the one before, and moves nothing.
#include "render/sheet/steps.hpp"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>

#include "render/backends/backends.hpp"
#include "render/tables/tables.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/random_mechanism.hpp"

namespace steps_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

SheetOptions in(Language language, Orientation orientation = Orientation::landscape) {
    SheetOptions options;
    options.language = language;
    options.orientation = orientation;
    return options;
}

/// Places of the labels of a page's large figure, by what they say; and the ids of its groups of a class.
struct Shown {
    std::string figure;
    std::multiset<std::string> labels;
    std::set<GroupId> vectors, centres;
};
/// Polygons of bodies are one figure; those under the loads of one body alone another, and so are the sums.
std::string forces_of(const std::string& id) {
    if (id.starts_with("sum-")) return "sums";
    const std::size_t alone = id.find("-load-");
    return alone == std::string::npos ? "forces" : "forces" + id.substr(alone);
}
Shown shown_on(const Page& page) {
    Shown shown;
    bool large =
        true;  // the first figure of the page with its details, or several of one kind: the polygons of the bodies
    std::string kind;
    for (const Mark& mark : page.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark)) {
            if (group->cls == "figure") {
                const std::string of = *group->attribute("data-figure");
                if (kind.empty())
                    kind = of, shown.figure = kind == "forces"                    ? forces_of(group->id.text())
                                              : group->id == GroupId("mechanism") ? group->title
                                                                                  : group->id.text();
                large = of == kind || (large && of == "detail");
            }
            if (large && group->cls == "vector") shown.vectors.insert(group->id);
            if (large && group->cls == "centre") shown.centres.insert(group->id);
        }
        const auto* text = std::get_if<TextMark>(&mark);
        if (large && text && text->cls == "label")
            shown.labels.insert(text->words + " at " + std::to_string(text->pivot.x) + ", " +
                                std::to_string(text->pivot.y));
    }
    return shown;
}

class Steps : public testing::TestWithParam<std::string> {};

void expect_clean_steps(const std::vector<Page>& pages) {
    expect_clean(pages);
    for (const Page& page : pages) expect_sound_groups(page);
}

void expect_nothing_moves_nor_goes(const std::vector<Page>& pages) {
    std::map<std::string, Shown> before;
    for (const Page& page : pages) {
        Shown now = shown_on(page);
        const Shown& then = before[now.figure];
        const auto within = [](const auto& a, const auto& b) {
            return std::includes(b.begin(), b.end(), a.begin(), a.end());
        };
        EXPECT_TRUE(within(then.labels, now.labels)) << now.figure;
        EXPECT_TRUE(within(then.vectors, now.vectors)) << now.figure;
        EXPECT_TRUE(within(then.centres, now.centres)) << now.figure;
        before[now.figure] = std::move(now);
    }
}

void expect_the_finished_figures_at_last(const Solution& solution, const std::vector<Page>& pages) {
    std::map<std::string, Shown> last;
    for (const Page& page : pages) {
        Shown now = shown_on(page);
        last[now.figure] = std::move(now);
    }
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p) {
        const Polygon& polygon = solution.protocol.polygons[p];
        if (polygon.plane == Plane::force || !last.contains(legal_id(polygon.id))) continue;
        const Figure figure = polygon_figure(context, static_cast<int>(p), 171, 140);
        std::set<GroupId> vectors;
        for (const Mark& mark : figure.marks)
            if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->cls == "vector")
                vectors.insert(group->id);
        // Which details there are depends on the room.
        const auto in_detail = [](const GroupId& id) { return !id.detail.empty(); };
        std::set<GroupId>& drawn = last.at(legal_id(polygon.id)).vectors;
        std::erase_if(vectors, in_detail);
        std::erase_if(drawn, in_detail);
        EXPECT_EQ(drawn, vectors) << polygon.id;
    }
}
/// Strokes and letters of a colour.
std::size_t count_of(const Page& page, Colour colour) {
    std::size_t count = 0;
    for (const Mark& mark : page.marks) {
        if (const auto* path = std::get_if<Path>(&mark)) count += path->stroked && path->pen.colour == colour;
        if (const auto* text = std::get_if<TextMark>(&mark)) count += text->colour == colour;
    }
    return count;
}

void expect_always_something_in_the_accent(const Solution& solution, const std::vector<Page>& pages) {
    const Theme theme;
    if (solution.protocol.statements.empty()) return;
    for (std::size_t p = 0; p < pages.size(); ++p) {
        if (shown_on(pages[p]).figure.starts_with("closure")) continue;  // all of it is new
        EXPECT_GT(count_of(pages[p], theme.accent), 0u) << "page " << p + 1;
    }
}

TEST_P(Steps, AreCleanAddToOneAnotherAndEndWithTheFinishedFigures) {
    const Solution& solution = example(GetParam());
    const auto pages = lay_out_steps(solution, {}, fonts());
    expect_clean_steps(pages);
    expect_nothing_moves_nor_goes(pages);
    expect_the_finished_figures_at_last(solution, pages);
    expect_always_something_in_the_accent(solution, pages);
}

TEST_P(Steps, AreCleanInItalianAndUprightToo) {
    const Solution& solution = example(GetParam());
    expect_clean_steps(lay_out_steps(solution, in(Language::it), fonts()));
    // What both ways of the paper share need not be seen twice under sanitizers.
    if (unless_sanitized(1, 0) != 0)
        expect_clean_steps(lay_out_steps(solution, in(Language::it, Orientation::portrait), fonts()));
}

INSTANTIATE_TEST_SUITE_P(Examples, Steps, testing::ValuesIn(example_names()),
                         [](const testing::TestParamInfo<std::string>& each) { return each.param; });

TEST(StepsOfDetails, ComeWithTheFirstVectorInThem) {
    std::size_t most = 0;
    for (const Page& page : lay_out_steps(example("stephenson_3_driver_6"), {}, fonts())) {
        std::set<GroupId> details, used;
        for (const Mark& mark : page.marks) {
            const auto* group = std::get_if<GroupBegin>(&mark);
            if (!group) continue;
            if (group->id.detail.empty()) continue;
            const GroupId detail(group->id.figure, {}, group->id.detail);
            if (group->cls == "figure") details.insert(detail);
            if (group->cls == "vector") used.insert(detail);
        }
        EXPECT_EQ(details, used);
        most = std::max(most, details.size());
    }
    EXPECT_EQ(most, 3u);
}

TEST(StepsOfTheFourBar, BeginWithoutAPolygonAndDrawItLineByLine) {
    const auto pages = lay_out_steps(example("four_bar"), {}, fonts());
    std::vector<std::size_t> vectors;
    for (const Page& page : pages)
        if (const Shown shown = shown_on(page); shown.figure == "velocity") vectors.push_back(shown.vectors.size());
    ASSERT_GE(vectors.size(), 2u);
    EXPECT_EQ(vectors.front(), 1u) << "v_A alone";
    EXPECT_EQ(vectors.back(), 3u);
    EXPECT_TRUE(says(pages, "closes the polygon") || says(pages, "close the polygon"));
}

TEST(StepsOfTheFourBar, WhatIsNewIsInTheAccentAndWhatWasIsGrey) {
    const Theme theme;
    bool both = false;
    for (const Page& page : lay_out_steps(example("four_bar"), {}, fonts())) {
        if (shown_on(page).figure != "velocity") continue;
        std::map<std::string, Colour> colours;
        for (const TextMark* text : texts_of(page))
            if (text->cls == "label") colours[text->words] = text->colour;
        if (!colours.contains("v_BA")) continue;
        if (colours["v_BA"] == theme.accent) {
            EXPECT_EQ(colours["v_A"], theme.secondary);
            both = true;
        } else {
            EXPECT_EQ(colours["v_BA"], theme.secondary);
        }
    }
    EXPECT_TRUE(both);
}

const Page* page_that_says(const std::vector<Page>& pages, const std::string& words) {
    const auto found = std::find_if(pages.begin(), pages.end(), [&](const Page& page) { return says(page, words); });
    return found == pages.end() ? nullptr : &*found;
}
std::optional<Colour> colour_of_label(const Page& page, const std::string& words) {
    for (const TextMark* text : texts_of(page))
        if (text->cls == "label" && text->words == words) return text->colour;
    return std::nullopt;
}

TEST(StepsOfTheFourBar, ShowWhatAnAngularVelocityIsReadOffAndDrawItOnTheBody) {
    const Theme theme;
    const auto pages = lay_out_steps(example("four_bar"), {}, fonts());
    const Page* page = page_that_says(pages, "ω_3 is v_BA divided by AB");
    ASSERT_TRUE(page);
    EXPECT_EQ(colour_of_label(*page, "v_BA"), theme.accent);
    EXPECT_EQ(colour_of_label(*page, "v_B"), theme.secondary);
    EXPECT_EQ(colour_of_label(*page, "ω_3 = 1.31 rad/s"), theme.accent);
    EXPECT_TRUE(says(*page, "1.31\u00a0rad/s"));
    const Page* next = page_that_says(pages, "ω_4 is v_B divided by");
    ASSERT_TRUE(next);
    EXPECT_EQ(colour_of_label(*next, "ω_3 = 1.31 rad/s"), theme.secondary);
    EXPECT_EQ(colour_of_label(*next, "ω_4 = −4.78 rad/s"), theme.accent);
}

TEST(StepsOfForces, DrawAForceWhereTheSentenceFindsIt) {
    const auto pages = lay_out_steps(example("gas_force"), {}, fonts());
    const Page* line = page_that_says(pages, "two forces only");
    const Page* triangle = page_that_says(pages, "The force triangle of body 4");
    const Page* couple = page_that_says(pages, "force times arm");
    ASSERT_TRUE(line && triangle && couple);
    EXPECT_TRUE(colour_of_label(*line, "F_gas")) << "is given";
    EXPECT_FALSE(colour_of_label(*line, "F_14"));
    EXPECT_FALSE(colour_of_label(*line, "F_12"));
    EXPECT_EQ(colour_of_label(*triangle, "F_14"), Theme{}.accent);
    EXPECT_FALSE(colour_of_label(*triangle, "F_12"));
    EXPECT_EQ(colour_of_label(*couple, "F_12"), Theme{}.accent);
    EXPECT_EQ(colour_of_label(*couple, "F_14"), Theme{}.secondary);
    EXPECT_TRUE(says(*triangle, "F_14\u00a0=\u00a0603\u00a0N"));
}

TEST(StepsOfForces, EndWithTheClosedPolygon) {
    const auto pages = lay_out_steps(example("gas_force"), in(Language::it), fonts());
    EXPECT_EQ(shown_on(pages.back()).figure.substr(0, 7), "closure");
    EXPECT_TRUE(says(pages.back(), "esterne sono in"));
}

TEST(StepsOfAnInstantaneousMotion, FindTheCentreBeforeTheVelocitiesAboutIt) {
    const auto pages = lay_out_steps(example("act_of_motion_general"), {}, fonts());
    const Page* centre = page_that_says(pages, "the perpendiculars at A and B meet");
    ASSERT_TRUE(centre);
    EXPECT_TRUE(colour_of_label(pages.front(), "v_A")) << "is given";
    EXPECT_FALSE(colour_of_label(pages.front(), "P_12"));
    EXPECT_FALSE(colour_of_label(pages.front(), "v_D"));
    EXPECT_EQ(colour_of_label(*centre, "P_12"), Theme{}.accent);
    EXPECT_FALSE(colour_of_label(*centre, "v_D"));
    EXPECT_TRUE(colour_of_label(pages.back(), "v_D"));
}

TEST(EquationBlock, GoesOnInAFurtherRowWhereItIsTooWide) {
    const Solution& solution = example("quick_return");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::it};
    bool broken = false;
    for (const Statement& statement : solution.protocol.statements) {
        if (!statement.equation) continue;
        const Block whole = equation_block(context, *statement.equation, 300),
                    narrow = equation_block(context, *statement.equation, 50);
        EXPECT_LE(narrow.width, 50);
        broken = broken || narrow.height > 1.5 * whole.height;
        const auto words = [](const Block& block, const std::string& name) {
            std::size_t count = 0;
            for (const Mark& mark : block.marks)
                if (const auto* text = std::get_if<TextMark>(&mark)) count += text->words == name;
            return count;
        };
        for (const std::vector<Term>& side : statement.equation->sides)
            for (const Term& term : side) {
                const std::string name = plain(typeset(term.symbol, Language::it));
                EXPECT_EQ(words(narrow, name), words(whole, name)) << name;
            }
    }
    EXPECT_TRUE(broken);
}

TEST(StepsOfTheFourBar, AreTheSameEveryTime) {
    const Solution& solution = example("four_bar");
    const auto first = lay_out_steps(solution, {}, fonts()), second = lay_out_steps(solution, {}, fonts());
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(to_svg(first[i], fonts()), to_svg(second[i], fonts()));
}

TEST(Revealed, DropsWhatComesLaterWithItsGroup) {
    const Theme theme;
    Path path;
    path.stroked = true;
    path.segments = {MoveTo{{0, 0}}, LineTo{{1, 1}}};
    Path old = path, next = path;
    old.statement = StatementIndex(0);
    next.statement = StatementIndex(2);
    std::vector<Mark> marks{GroupBegin{"figure", GroupId("f"), "", {}},
                            path,
                            old,
                            GroupBegin{"vector", GroupId("v"), "", {}, StatementIndex(1)},
                            path,
                            GroupEnd{},
                            GroupBegin{"vector", GroupId("w"), "", {}, StatementIndex(2)},
                            path,
                            Axis{},
                            GroupEnd{},
                            next,
                            GroupEnd{}};
    const auto shown = revealed(marks, {0, 1, 2}, 1, theme);
    ASSERT_EQ(shown.size(), 7u);
    EXPECT_EQ(std::get<Path>(shown[1]).pen.colour, path.pen.colour);
    EXPECT_EQ(std::get<Path>(shown[2]).pen.colour, theme.secondary);
    EXPECT_EQ(std::get<Path>(shown[4]).pen.colour, theme.accent);
    EXPECT_EQ(revealed(marks, {0, 1, 2}, 2, theme).size(), marks.size());
}

TEST(Revealed, PutsWhatWasGivenBackWhereThereIsOneInk) {
    Theme theme;
    theme.accent = theme.text;
    Path given, found;
    given.stroked = found.stroked = true;
    given.pen.colour = found.pen.colour = theme.text;
    found.statement = StatementIndex(0);
    TextMark name;
    name.colour = theme.text;
    const auto shown = revealed({given, found, name}, {0}, 0, theme);
    EXPECT_EQ(std::get<Path>(shown[0]).pen.colour, theme.secondary);
    EXPECT_EQ(std::get<Path>(shown[1]).pen.colour, theme.text);
    EXPECT_EQ(std::get<TextMark>(shown[2]).colour, theme.text) << "names stay readable";
}

TEST(Revealed, PutsWhatIsCitedInTheAccent) {
    const Theme theme;
    Path path;
    path.stroked = true;
    TextMark label;
    label.names = {"v_A"};
    const std::vector<Mark> marks{
        GroupBegin{"vector", GroupId("velocity", "v_A"), "", {{"data-name", "v_A"}}, StatementIndex(0)},
        path,
        GroupEnd{},
        label,
        GroupBegin{"vector", GroupId("velocity", "v_B"), "", {{"data-name", "v_B"}}, StatementIndex(0)},
        path,
        GroupEnd{}};
    const auto shown = revealed(marks, {0, 1}, 1, theme, {{"v_A"}, {}});
    EXPECT_EQ(std::get<Path>(shown[1]).pen.colour, theme.accent);
    EXPECT_EQ(std::get<TextMark>(shown[3]).colour, theme.accent);
    EXPECT_EQ(std::get<Path>(shown[5]).pen.colour, theme.secondary);
}

}  // namespace
}  // namespace steps_test
