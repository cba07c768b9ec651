// Sheets: nothing overlaps, nothing is cut, nothing is missing, on every example, paper and language.
#include "render/sheet/sheet.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "constructions/solving/solve.hpp"
#include "render/backends/backends.hpp"
#include "render/layout/drawn_sheet.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/tables.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/solved.hpp"

namespace sheet_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;

using namespace kinegraph::pages;

class EveryExample : public testing::TestWithParam<std::string> {};

void expect_nested_groups_and_measured_axes(const std::vector<Page>& pages) {
    for (const Page& page : pages) {
        std::set<std::string> ids;
        std::vector<double> scales;
        double value = 0;
        int depth = 0;
        for (const Mark& mark : page.marks) {
            if (const auto* group = std::get_if<GroupBegin>(&mark)) {
                ++depth;
                EXPECT_TRUE(group->id.empty() || ids.insert(group->id.text()).second) << group->id.text();
                for (const auto& [name, text] : group->attributes) {
                    if (name == "data-scale") scales.push_back(std::strtod(text.c_str(), nullptr));
                    if (name == "data-value") value = std::strtod(text.c_str(), nullptr);
                }
            }
            if (std::holds_alternative<GroupEnd>(mark)) --depth;
            EXPECT_GE(depth, 0);
            if (const auto* axis = std::get_if<Axis>(&mark)) {
                ASSERT_FALSE(scales.empty());
                // A bar in compression has a negative value.
                EXPECT_NEAR(std::hypot(axis->tip.x - axis->tail.x, axis->tip.y - axis->tail.y),
                            std::abs(value) / scales.back(), 1e-6);
            }
        }
        EXPECT_EQ(depth, 0);
    }
}

void expect_all_listed(const Solution& solution, const std::vector<Page>& pages) {
    EXPECT_TRUE(says(pages, "Bodies"));
    EXPECT_TRUE(solution.centres.empty() || says(pages, "Instant centres"));
    for (const DrawnVector& vector : solution.protocol.vectors) {
        RichText symbol = typeset(vector.symbol, Language::en);
        EXPECT_TRUE(says(pages, plain(symbol))) << name_of(vector.symbol);
    }
}

// That nothing is cut and no text covers another is seen with the pixels, on all papers: overlap_test.cpp.
TEST_P(EveryExample, GroupsNestAxesMeasureTheirValueAllIsListedAndTheSameEveryTime) {
    const Solution& solution = example(GetParam());
    const auto& pages = laid_out(GetParam());
    const auto again = lay_out(solution, {}, fonts());
    expect_nested_groups_and_measured_axes(pages);
    expect_all_listed(solution, pages);
    ASSERT_EQ(pages.size(), again.size());
    for (std::size_t i = 0; i < pages.size(); ++i) EXPECT_EQ(to_svg(pages[i], fonts()), to_svg(again[i], fonts()));
}

INSTANTIATE_TEST_SUITE_P(Sheet, EveryExample, testing::ValuesIn(example_names()),
                         [](const testing::TestParamInfo<std::string>& each) { return each.param; });

TEST(Sheet, FiguresAreNumberedAndSayTheirScale) {
    const auto& pages = laid_out("four_bar");
    EXPECT_TRUE(says(pages[0], "Fig. 1"));
    EXPECT_TRUE(says(pages[0], "Mechanism and centres"));
    EXPECT_TRUE(says(pages[0], "Velocity polygon"));
    EXPECT_TRUE(says(pages, "Acceleration polygon"));
    EXPECT_TRUE(says(pages[0], "1 mm ≙ "));
    EXPECT_TRUE(says(pages[0], "1 : "));
    EXPECT_TRUE(says(pages[0], "1/" + std::to_string(pages.size())));
}

TEST(Sheet, SaysWhichPointsCoincide) {
    EXPECT_TRUE(says(laid_out("quick_return"), "A*\u00A0at\u00A0A"));
    // Stars of the file's own are names.
    std::string text = tests::contents(tests::example_file("quick_return"));
    for (std::size_t at = text.find("\"A\""); at != std::string::npos; at = text.find("\"A\"", at + 1))
        text.insert(at + 2, "*");
    const std::vector<Page> pages = lay_out(tests::solved(text), {}, fonts());
    EXPECT_TRUE(says(pages, "A**\u00A0at\u00A0A*"));
    EXPECT_FALSE(says(pages, " A*\u00A0at\u00A0"));
}

TEST(Sheet, TheFourBarFitsOneA3) {
    EXPECT_EQ(lay_out(example("four_bar"), {Paper::a3, Language::en, {}}, fonts()).size(), 1u);
}

TEST(Sheet, WithoutMotionThereIsStillADrawing) {
    auto mechanism = read_mechanism(
        R"({"kinegraph": 1, "points": {"O": [0, 0], "A": [1, 0.5]}, "bodies": {"1": ["O", "A"]},
            "joints": [{"revolute": "O", "bodies": [0, 1]}]})",
        "still.json");
    ASSERT_TRUE(mechanism);
    auto solution = solve(std::move(*mechanism));
    ASSERT_TRUE(solution);
    const auto pages = lay_out(*solution, {}, fonts());
    ASSERT_EQ(pages.size(), 1u);
    EXPECT_TRUE(says(pages[0], "Nothing is driven"));
}

TEST(Sheet, AVeryLongTitleStaysInItsBlock) {
    Solution solution = example("four_bar");
    solution.mechanism.title = std::string(
        "A linkage whose title was written by somebody who liked titles that go on and on <and on> & on, and on");
    const auto pages = lay_out(solution, {}, fonts());
    ASSERT_TRUE(says(pages, "A linkage"));
    for (const Page& page : pages) EXPECT_LE(box_of(page.marks).max.x, page.width - 9.5);
}

/// A search for line breaks that tries them all once took minutes; the time limit of the suite sees it.
TEST(Sheet, ATitleOfAMegabyteStaysTheTitle) {
    Solution solution = example("four_bar");
    std::string title;
    for (int i = 0; i < 200000; ++i) title += "Wort ";
    solution.mechanism.title = title;
    EXPECT_EQ(lay_out(solution, {}, fonts()).front().title, solution.mechanism.title.in(Language::en));
}

TEST(Sheet, TwoHundredCharactersAndMarkupStayInTheTitleBlock) {
    Solution solution = example("four_bar");
    std::string words, one_word;
    for (int i = 0; i < 20; ++i) words += "<b> & \"xy\" ", one_word += "Gelenk<&\">";
    for (const std::string& title : {words, one_word})
        for (const Orientation orientation : {Orientation::landscape, Orientation::portrait}) {
            SCOPED_TRACE(title);
            solution.mechanism.title = title;
            SheetOptions options;
            options.orientation = orientation;
            options.author = one_word;
            options.date = "21 November 2026";
            const auto pages = lay_out(solution, options, fonts());
            expect_clean(pages);
            // Left of the cells of the block, above the frame's lower edge.
            const Box block = format_of(Paper::a4, orientation).block;
            int seen = 0;
            for (const TextMark* text : texts_of(pages[0])) {
                if (text->glyphs.empty() || text->words.find("Gelenk") == std::string::npos) continue;
                ++seen;
                EXPECT_LE(ink_of(*text).max.x, block.max.x - 3 * 17.5);
                EXPECT_LE(ink_of(*text).max.y, block.max.y);
                EXPECT_GE(ink_of(*text).min.y, block.min.y);
            }
            EXPECT_GT(seen, 0) << "the author stands there, if not the title";
        }
}

TEST(Sheet, DateAndAuthorStandInTheBlockOnlyWhereGiven) {
    const Solution& solution = example("four_bar");
    SheetOptions options;
    EXPECT_FALSE(says(lay_out(solution, options, fonts()), "four_bar.json  ·"));
    options.date = "2026-11-21";
    EXPECT_TRUE(says(lay_out(solution, options, fonts())[0], "four_bar.json  ·  2026-11-21"));
    options.author = "A. Rossi";
    EXPECT_TRUE(says(lay_out(solution, options, fonts())[0], "four_bar.json  ·  A. Rossi  ·  2026-11-21"));
}

TEST(Sheet, TheFilesScalesAreTaken) {
    Solution solution = example("four_bar");
    solution.mechanism.scales = {{"mechanism", Exact::ratio(25, 10000), ""},  // 1 : 2.5
                                 {"velocity", Exact::ratio(8, 1000), ""},
                                 {"acceleration", Exact::ratio(2, 10), ""}};
    const auto pages = lay_out(solution, {}, fonts());
    EXPECT_TRUE(says(pages[0], "1 : 2.5"));
    EXPECT_TRUE(says(pages, "1 mm ≙ 0.008 m/s"));
    EXPECT_TRUE(says(pages, "1 mm ≙ 0.2 m/s"));
    EXPECT_FALSE(says(pages, "Remarks"));
    expect_clean(pages);
}

TEST(Sheet, AScaleTooLargeForThePaperIsRefusedAndSaidSo) {
    Solution solution = example("four_bar");
    solution.mechanism.scales = {{"mechanism", Exact::ratio(1, 10000), ""}, {"velocity", Exact::ratio(1, 10000), ""}};
    const auto pages = lay_out(solution, {}, fonts());
    EXPECT_TRUE(says(pages, "Remarks"));
    expect_clean(pages);
}

TEST(Sheet, LongNamesPushNothingAside) {
    auto mechanism = read_mechanism(
        R"({"kinegraph": 1, "frame": "the foundation", "units": {"length": "mm"},
            "points": {"O2": [0, 0], "A": {"from": "O2", "distance": 40, "angle": 60}, "O4": [150, 0],
                       "the upper pin": {"meet": [{"circle": "A", "radius": 150}, {"circle": "O4", "radius": 80}],
                       "side": "left"}},
            "bodies": {"driving crank": ["O2", "A"],
                       "connecting rod": {"points": ["A", "the upper pin"],
                       "label": "a rod of which more is said than has room on one line <&>"},
                       "rocking lever": ["O4", "the upper pin"]},
            "joints": [{"revolute": "O2", "bodies": ["the foundation", "driving crank"]},
                       {"revolute": "A", "bodies": ["driving crank", "connecting rod"]},
                       {"revolute": "the upper pin", "bodies": ["connecting rod", "rocking lever"]},
                       {"revolute": "O4", "bodies": ["the foundation", "rocking lever"]}],
            "drivers": [{"body": "driving crank", "omega": 5}]})",
        "long.json");
    ASSERT_TRUE(mechanism) << mechanism.error().front().message.in(Language::en);
    auto solution = solve(std::move(*mechanism));
    ASSERT_TRUE(solution);
    for (const Paper paper : {Paper::a4, Paper::a3})
        expect_clean(lay_out(*solution, {paper, Language::en, {}}, fonts()));
}

/// A crank and dyads one after the other, each on a pivot of its own.
std::string chain_of(int dyads) {
    std::string points = R"("O": [0, 0], "A0": {"from": "O", "distance": 40, "angle": 60})",
                bodies = R"("crank": ["O", "A0"])", joints = R"({"revolute": "O", "bodies": ["0", "crank"]})",
                before = "crank";
    for (int k = 1; k <= dyads; ++k) {
        const std::string n = std::to_string(k), pin = "A" + std::to_string(k - 1);
        points += ", \"Q" + n + "\": [" + std::to_string(150 * k) + ", " + std::to_string(k % 2 == 0 ? 5 : -5) +
                  "], \"A" + n + "\": {\"meet\": [{\"circle\": \"" + pin + "\", \"radius\": 150}, {\"circle\": \"Q" +
                  n + "\", \"radius\": 60}], \"side\": \"left\"}";
        bodies += ", \"coupler" + n + "\": [\"" + pin + "\", \"A" + n + "\"], \"rocker" + n + "\": [\"Q" + n +
                  "\", \"A" + n + "\"]";
        joints += ", {\"revolute\": \"" + pin + "\", \"bodies\": [\"" + before + "\", \"coupler" + n +
                  "\"]}, {\"revolute\": \"A" + n + "\", \"bodies\": [\"coupler" + n + "\", \"rocker" + n +
                  "\"]}, {\"revolute\": \"Q" + n + "\", \"bodies\": [\"0\", \"rocker" + n + "\"]}";
        before = "rocker" + n;
    }
    return R"({"kinegraph": 1, "frame": "0", "units": {"length": "mm"}, "points": {)" + points + R"(}, "bodies": {)" +
           bodies + R"(}, "joints": [)" + joints + R"(], "drivers": [{"body": "crank", "omega": 5}]})";
}

TEST(Sheet, ALongChainGoesOnOverItsPages) {
    auto mechanism = read_mechanism(chain_of(5), "chain.json");
    ASSERT_TRUE(mechanism) << mechanism.error().front().message.in(Language::en);
    const auto solution = solve(std::move(*mechanism));
    ASSERT_TRUE(solution);
    for (const Orientation orientation : {Orientation::landscape, Orientation::portrait})
        for (const Paper paper : {Paper::a4, Paper::a3}) {
            SheetOptions options{paper, Language::it, {}};
            options.orientation = orientation;
            expect_clean(lay_out(*solution, options, fonts()));
        }
}

/// The scale of each figure by its id, without details.
std::map<std::string, double> scales_of(const Solution& solution, Language language, SolutionDetail detail) {
    SheetOptions options;
    options.language = language;
    options.detail = detail;
    std::map<std::string, double> scales;
    for (const Figure& figure : draw_solution(solution, options, fonts()).figures)
        if (figure.has_scale) scales[figure.id] = figure.scale;
    return scales;
}

class SameProblem : public testing::TestWithParam<std::string> {};

TEST_P(SameProblem, HasTheSameScalesInEveryLanguageAndNoCoarserOnesInBriefAtTheSameLength) {
    const Solution& solution = example(GetParam());
    const auto scales = scales_of(solution, Language::en, SolutionDetail::full);
    ASSERT_GE(scales.size(), 2U);
    for (const Language language : {Language::it, Language::fr, Language::de, Language::es})
        EXPECT_EQ(scales_of(solution, language, SolutionDetail::full), scales);
    std::size_t compared = 0, coarser = 0;
    for (const auto& [id, scale] : scales_of(solution, Language::en, SolutionDetail::brief))
        if (const auto full = scales.find(id); full != scales.end()) {
            ++compared;
            coarser += scale > full->second * (1 + 1e-9) ? 1 : 0;
        }
    EXPECT_GE(compared, 2U);
    // Coarser scales only where those of the full solution would cost a page.
    SheetOptions brief;
    brief.detail = SolutionDetail::brief;
    const std::size_t pages = draw_solution(solution, brief, fonts()).pages.size();
    brief.kept = scales_of_solution(solution, {}, fonts());
    brief.kept->hold = KeptScales::Hold::not_coarser;
    const std::size_t pages_with_those = draw_solution(solution, brief, fonts()).pages.size();
    EXPECT_LE(pages, pages_with_those);
    EXPECT_TRUE(coarser == 0 || pages < pages_with_those);
}

INSTANTIATE_TEST_SUITE_P(Sheet, SameProblem,
                         testing::Values("four_bar", "exam_2001", "engine_inertia_gas", "three_hinged_arch",
                                         "elliptic_trammel", "watt_six_bar"));

double scale_of_group(const Figure& figure, const std::string& id) {
    for (const Mark& mark : figure.marks)
        if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->id.text() == id)
            if (const std::string* scale = group->attribute("data-scale")) return std::strtod(scale->c_str(), nullptr);
    return 0;
}

TEST(Results, AreMeasuredOnTheDrawing) {
    const Solution& solution = example("four_bar");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    std::vector<Figure> figures{polygon_figure(context, 0, 150, 100), polygon_figure(context, 1, 150, 100)};
    int vectors = 0;
    for (const ResultRow& row : result_rows(context, figures)) {
        ASSERT_TRUE(row.numeric) << row.name << " has its number from the check";
        EXPECT_NEAR(row.drawing, *row.numeric, 1e-9) << row.name;
        if (!row.millimetres) continue;
        ++vectors;
        const Figure& figure = row.symbol.letter == Symbol::Letter::v ? figures[0] : figures[1];
        const double scale =
            row.detail.empty() ? figure.scale : scale_of_group(figure, figure.id + "-detail-" + row.detail);
        EXPECT_NEAR(*row.millimetres * scale, row.drawing, 1e-6 * scale) << row.name;
    }
    EXPECT_GE(vectors, 10);
}

/// Rows of one arrow have one reading, and stand in one line where the table is not wider for it.
TEST(Results, OfOneArrowShareALine) {
    std::size_t shared = 0;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        const Theme theme;
        const DrawingContext context{solution, theme, fonts(), Language::en};
        std::vector<Figure> figures;
        for (int p = 0; p < static_cast<int>(solution.protocol.polygons.size()); ++p)
            figures.push_back(polygon_figure(context, p, 150, 100));
        const std::vector<ResultRow> rows = result_rows(context, figures);
        std::vector<ResultRow> apart = rows;
        std::map<std::size_t, const ResultRow*> first;  // by arrow
        std::size_t numbered = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            apart[i].arrow = 0;
            if (rows[i].arrow == 0) continue;  // a radius
            ++numbered;
            const ResultRow& like = *first.emplace(rows[i].arrow, &rows[i]).first->second;
            EXPECT_EQ(rows[i].group, like.group) << name << ": " << rows[i].name;
            EXPECT_EQ(rows[i].unit, like.unit) << name << ": " << rows[i].name;
            EXPECT_EQ(rows[i].drawing, like.drawing) << name << ": " << rows[i].name;
            EXPECT_EQ(rows[i].millimetres, like.millimetres) << name << ": " << rows[i].name;
        }
        const std::size_t repeated = numbered - first.size();
        const ResultsTable joined(context, rows), single(context, apart);
        constexpr double wide = 400;  // mm: all names have room
        EXPECT_EQ(joined.lines(wide).size() + repeated, single.lines(wide).size()) << name;
        const auto width = [](const std::vector<SharedBlock>& lines) {
            double most = 0;
            for (const SharedBlock& line : lines) most = std::max(most, line.width());
            return most;
        };
        for (const double column : {40.0, 55.0, 80.0})
            EXPECT_LE(width(joined.lines(column)), std::max(width(single.lines(column)), column) + 1e-9) << name;
        shared += repeated;
    }
    EXPECT_GE(shared, 50U);
}

/// Whatever is drawn of a motion that the check determines has its own number beside it: of two slidings at one point,
/// of an auxiliary point, of a place on a guide, of an equivalent link too. A component along a line alone has none.
TEST(Results, AreBesideTheirOwnNumbers) {
    int compared = 0;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        const bool determined = solution.unsolved.empty();
        const Theme theme;
        const DrawingContext context{solution, theme, fonts(), Language::en};
        std::vector<Figure> figures;
        for (int p = 0; p < static_cast<int>(solution.protocol.polygons.size()); ++p)
            figures.push_back(polygon_figure(context, p, 150, 100));
        std::map<std::pair<RowGroup, std::string>, double> largest;
        for (const ResultRow& row : result_rows(context, figures))
            largest[{row.group, row.unit}] = std::max(largest[{row.group, row.unit}], std::abs(row.drawing));
        for (const ResultRow& row : result_rows(context, figures)) {
            const bool component = row.symbol.term.starts_with("∥") || row.symbol.term.starts_with("⟂");
            EXPECT_TRUE(row.numeric || component || !determined) << name << ": " << row.name;
            if (row.numeric) {
                EXPECT_NEAR(row.drawing, *row.numeric, (1e-9 * largest[{row.group, row.unit}]) + 1e-12)
                    << name << ": " << row.name;
                ++compared;
            }
        }
    }
    EXPECT_GE(compared, 1);
}

TEST(Results, InTheTableAreReadToATenthOfAMillimetre) {
    const Solution& solution = example("four_bar");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    ResultRow row;
    row.symbol = {Symbol::Letter::v, "A", ""};
    row.millimetres = 100.53;
    row.drawing = 100.53 * 0.005;
    row.numeric = 0.5027;
    row.unit = "m/s";
    std::set<std::string> words;
    for (const SharedBlock& line : ResultsTable(context, {row}).lines(90))
        for (const Mark& mark : line.set().marks)
            if (const auto* text = std::get_if<TextMark>(&mark)) words.insert(text->words);
    EXPECT_TRUE(words.contains("100.5"));
    EXPECT_TRUE(words.contains("0.5025")) << "100.5 mm at 0.005 m/s a millimetre";
    EXPECT_TRUE(words.contains("0.50270"));
    EXPECT_TRUE(words.contains("−0.04"));
}

TEST(Results, AsTextNameTheirUnits) {
    const std::string text = results_table(example("four_bar"), Language::en);
    for (const char* words : {"ω [rad/s]", "vx [m/s]", "x [mm]", "1,3", "Four-bar linkage", "by Grübler"})
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    EXPECT_NE(results_table(example("four_bar"), Language::it).find("−12,5664"), std::string::npos);
}

TEST(Results, WhatIsNothingBesideTheLargestOfItsKindIsZeroInAllColumns) {
    const std::string text = results_table(tests::solved(R"({"kinegraph": 1,
        "points": {"O": [0, 0], "A": {"from": "O", "distance": "5e-20 mm", "angle": 60},
                   "B": {"meet": [{"circle": "A", "radius": "150 mm"}, {"line": [0, 0], "angle": 0}], "side": "ahead"}},
        "bodies": {"2": ["O", "A"], "3": ["A", "B"], "4": ["B"]},
        "joints": [{"revolute": "O", "bodies": [0, 2]}, {"revolute": "A", "bodies": [2, 3]}, {"revolute": "B",
        "bodies": [3, 4]},
                   {"prismatic": "B", "bodies": [4, 0], "along": 0}],
        "drivers": [{"body": 2, "omega": 10}]})"),
                                           Language::en);
    EXPECT_NE(text.find("|v| [m/s]"), std::string::npos) << text;
    EXPECT_EQ(text.substr(0, text.find("Remarks")).find("× 10"), std::string::npos) << text;
}

TEST(Tables, PowersAreSetAsSuperscripts) {
    const RichText text = with_powers("m/s²");
    ASSERT_EQ(text.size(), 1u);
    EXPECT_EQ(text[0].text, "m/s");
    EXPECT_EQ(text[0].sup, "2");
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(shortest(0.025, Language::it), "0,025");
}

TEST(Tables, AnEquationKeepsToItsWidthAsFarAsItCan) {
    const Solution& solution = example("four_bar");
    const Theme theme;
    const DrawingContext context{solution, theme, fonts(), Language::en};
    Equation equation;
    const auto term = [](const char* about, const char* up) {
        return Term{{Symbol::Letter::a, about, up},
                    true,
                    true,
                    {LineReason::Kind::perpendicular_to_segment, "O4", "B"},
                    BodyIndex(1)};
    };
    equation.sides = {{term("B", "n"), term("B", "t")},
                      {term("A", "n"), term("A", "t"), term("BA", "n"), term("BA", "t")}};
    EXPECT_LE(equation_block(context, equation, 80).width, 80);
    EXPECT_GT(equation_block(context, equation, 200).width, 80);
}

}  // namespace
}  // namespace sheet_test
