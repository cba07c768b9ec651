// Structures and trusses cut free whole: their reactions by pole, rays, strings and closing line, which are on the
// sheet with all else that the sentences name; bodies on bars, which are cut free once.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "lang/keys/sentences.hpp"
#include "render/figures/truss_figures.hpp"
#include "render/scene/load_case.hpp"
#include "render/sheet/sheet.hpp"
#include "render/sheet/steps.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/told.hpp"

namespace whole_structures_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::tests;

bool says(const Solution& solution, Key sentence) {
    const std::vector<Statement>& said = solution.protocol.statements;
    return std::any_of(said.begin(), said.end(),
                       [&](const Statement& each) { return each.message.sentence == sentence; });
}
Vector reaction_at(const Solution& solution, const std::string& joint) {
    for (const JointForce& action : solution.forces)
        if (action.from == frame && action.force && solution.mechanism.joint(action.joint).name == joint)
            return *action.force;
    ADD_FAILURE() << "no reaction at " << joint;
    return {};
}
std::vector<Page> sheet_of(const Solution& solution, const SheetOptions& options = {}) {
    return lay_out(solution, options, fonts());
}

std::set<std::string> figures_on(const std::vector<Page>& pages) {
    std::set<std::string> figures;
    for (const Page& page : pages)
        for (const Mark& mark : page.marks)
            if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->cls == "figure")
                figures.insert(group->id.text());
    return figures;
}
std::set<std::string> labels_on(const std::vector<Page>& pages) {
    std::set<std::string> names;
    for (const Page& page : pages)
        for (const TextMark* text : pages::texts_of(page)) {
            if (text->cls != "label") continue;
            names.insert(text->names.begin(), text->names.end());
            names.insert(text->words);
        }
    return names;
}

/// Strings parallel to their rays, ends on the lines of the forces between them, and the reactions of the closing line.
void expect_funicular(const FreeBody::Funicular& found, const Vector& first, const Vector& second) {
    ASSERT_EQ(found.vertices.size(), found.corners.size() + 1);
    ASSERT_EQ(found.known.size() + 1, found.corners.size());
    for (std::size_t i = 0; i < found.corners.size(); ++i) {
        const Vector string = *found.vertices[i + 1] - *found.vertices[i], ray = *found.corners[i] - *found.pole;
        EXPECT_TRUE(cross(string, ray).is_zero()) << i;
        EXPECT_FALSE(ray.is_zero()) << i;
    }
    const Vector closing = *found.vertices.front() - *found.vertices.back();
    EXPECT_TRUE(cross(closing, *found.dividing - *found.pole).is_zero());
    EXPECT_EQ(*found.dividing - *found.corners.back(), first);
    EXPECT_EQ(*found.corners.front() - *found.dividing, second);
}
/// The resultant passes where the outer strings meet: about there the given forces have no moment.
void expect_no_moment(const Solution& solution, const Vector& about) {
    Exact moment = 0;
    for (const Load& load : solution.mechanism.loads) {
        const auto& force = std::get<ForceLoad>(load);
        moment = moment + cross(solution.pose.at(force.at) - about, *force.value);
    }
    EXPECT_TRUE(moment.is_zero());
}
const TakenTogether& together_in(const Solution& solution) {
    if (solution.taken_together.size() != 1 || !solution.taken_together.front().funicular)
        throw std::runtime_error("no strings over bodies taken together");
    return solution.taken_together.front();
}

// --- by pole, rays and strings
// -----------------------------------------------------------------------------------------------

TEST(WholeByStrings, AStepLadderUnderWeights) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1,
      "points": {"A": [0, 0], "B": [4, 0], "C": [2, 4], "D": [1, 2], "E": [3, 2], "P": [0.5, 1], "Q": [3.5, 1]},
      "bodies": {"2": ["A", "C", "D", "P"], "3": ["B", "C", "E", "Q"], "4": ["D", "E"]},
      "joints": [{"revolute": "A", "bodies": [1, 2]}, {"contact": "B", "bodies": [3, 1], "tangent": 0},
                 {"revolute": "C", "bodies": [2, 3]}, {"revolute": "D", "bodies": [2, 4]}, {"revolute": "E",
                 "bodies": [3, 4]}],
      "loads": [{"force": "W", "body": 2, "at": "P", "value": [0, -800]},
                {"force": "V", "body": 3, "at": "Q", "value": [0, -400]}]})");
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_TRUE(says(solution, lang::sentences::funicular_parallel));
    EXPECT_FALSE(says(solution, lang::sentences::parallel_forces));
    // B: (800 · 0.5 + 400 · 3.5)/4.
    const TakenTogether& together = together_in(solution);
    expect_funicular(*together.funicular, {0, 450}, {0, 750});
    ASSERT_EQ(together.sums.size(), 1U);
    EXPECT_EQ(name_of(together.sums.front().symbol), "F_R");
    expect_no_moment(solution, together.sums.front().at);
    const std::vector<Page> pages = sheet_of(solution);
    const std::set<std::string> labels = labels_on(pages);
    for (const char* name : {"F_R", "1", "2", "3", "4"}) EXPECT_TRUE(labels.contains(name)) << name;
    EXPECT_TRUE(figures_on(pages).contains("forces-2-3-4"));
}

TEST(WholeByStrings, ATrussUnderWeights) {
    const Solution& solution = example("truss_simple");
    EXPECT_TRUE(says(solution, lang::sentences::funicular_parallel));
    expect_funicular(*together_in(solution).funicular, {0, 8000}, {0, 10000});
    for (const SolutionDetail detail : {SolutionDetail::full, SolutionDetail::brief}) {
        SheetOptions options;
        options.detail = detail;
        const std::vector<Page> pages = sheet_of(solution, options);
        EXPECT_TRUE(figures_on(pages).contains("forces-truss"));
        EXPECT_TRUE(labels_on(pages).contains("F_R"));
    }
}

TEST(WholeByStrings, ARoofUnderWind) {
    const Solution& solution = example("truss_roof_wind");
    EXPECT_TRUE(says(solution, lang::sentences::funicular_several));
    const TakenTogether& together = together_in(solution);
    Vector rest = reaction_at(solution, "E");
    for (const Load& load : solution.mechanism.loads) rest = rest + *std::get<ForceLoad>(load).value;
    expect_funicular(*together.funicular, reaction_at(solution, "E"), Vector{} - rest);
    expect_no_moment(solution, together.sums.front().at);
    // Where the outer strings meet has a letter, in the sentence as on the drawing.
    ASSERT_EQ(solution.truss->whole->meets.size(), 1U);
    const std::string letter = solution.truss->whole->meets.front().name;
    const auto said =
        std::find_if(solution.protocol.statements.begin(), solution.protocol.statements.end(),
                     [](const Statement& each) { return each.message.sentence == lang::sentences::funicular_several; });
    EXPECT_NE(english(said->message).find("its outer strings meet in " + letter + ", on the line"), std::string::npos);
    const Theme theme;
    const Figure figure = truss_figure({solution, theme, fonts()}, 150, 120);
    EXPECT_TRUE(std::any_of(figure.marks.begin(), figure.marks.end(), [&](const Mark& mark) {
        const auto* text = std::get_if<TextMark>(&mark);
        return text != nullptr && text->cls == "label" && text->words == letter;
    }));
}

/// Weights and wind, none parallel to another: one polygon adds them and parts the sum.
TEST(WholeByStrings, ForcesOfSeveralDirections) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1,
      "points": {"A": [0, 0], "B": [6, 0], "C": [3, 4], "M": [1.5, 2], "N": [4.5, 2], "D": [1, 0], "E": [5, 0]},
      "bodies": {"2": ["A", "C", "M", "D"], "3": ["B", "C", "N", "E"], "4": ["D", "E"]},
      "joints": [{"revolute": "A", "bodies": [1, 2]}, {"contact": "B", "bodies": [3, 1], "tangent": 0},
                 {"revolute": "C", "bodies": [2, 3]}, {"revolute": "D", "bodies": [2, 4]}, {"revolute": "E",
                 "bodies": [3, 4]}],
      "loads": [{"force": "P", "body": 2, "at": "M", "value": [400, -300]},
                {"force": "Q", "body": 3, "at": "N", "value": [-100, -700]},
                {"force": "W", "pin": "C", "value": [0, -500]}]})");
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_TRUE(says(solution, lang::sentences::funicular_several));
    // B = (300 · 1.5 + 400 · 2 + 700 · 4.5 − 100 · 2 + 500 · 3)/6.
    const TakenTogether& together = together_in(solution);
    expect_funicular(*together.funicular, {0, 950}, {-300, 550});
    expect_no_moment(solution, together.sums.front().at);
}

/// A couple has no line for a string to end on: the moments do it.
TEST(WholeByStrings, NotUnderACouple) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1,
      "points": {"A": [0, 0], "B": [4, 0], "C": [2, 4], "D": [1, 2], "E": [3, 2]},
      "bodies": {"2": ["A", "C", "D"], "3": ["B", "C", "E"], "4": ["D", "E"]},
      "joints": [{"revolute": "A", "bodies": [1, 2]}, {"contact": "B", "bodies": [3, 1], "tangent": 0},
                 {"revolute": "C", "bodies": [2, 3]}, {"revolute": "D", "bodies": [2, 4]}, {"revolute": "E",
                 "bodies": [3, 4]}],
      "loads": [{"couple": "M", "body": 2, "value": 800}]})");
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_FALSE(says(solution, lang::sentences::funicular_parallel));
    EXPECT_EQ(reaction_at(solution, "B"), (Vector{0, -200}));
}

/// The whole does not feel the spring between two of its bodies: neither among the known forces nor in the polygon.
TEST(WholeByStrings, WithoutTheSpringsWithin) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1,
      "points": {"A": [0, 0], "B": [4, 0], "C": [2, 4], "D": [1, 2], "E": [3, 2], "P": [0.5, 1], "Q": [3.5, 1]},
      "bodies": {"2": ["A", "C", "D", "P"], "3": ["B", "C", "E", "Q"], "4": ["D", "E"]},
      "joints": [{"revolute": "A", "bodies": [1, 2]}, {"contact": "B", "bodies": [3, 1], "tangent": 0},
                 {"revolute": "C", "bodies": [2, 3]}, {"revolute": "D", "bodies": [2, 4]}, {"revolute": "E",
                 "bodies": [3, 4]}],
      "loads": [{"force": "W", "body": 2, "at": "P", "value": [0, -800]},
                {"force": "V", "body": 3, "at": "Q", "value": [0, -400]},
                {"force": "S", "bodies": [2, 3], "between": ["P", "Q"], "magnitude": 50}]})");
    EXPECT_TRUE(solution.unsolved.empty());
    const TakenTogether& together = together_in(solution);
    EXPECT_EQ(together.funicular->known.size(), 2U);
    EXPECT_EQ(solution.protocol.polygons[at_index(together.polygon)].vectors.size(), 4U);
    expect_funicular(*together.funicular, {0, 450}, {0, 750});
}

/// Every load and roller stands upright, so that every hinge does: no superposition.
TEST(ParallelToAll, AGerberBeamOfThreeSpansNeedsNoSuperposition) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1,
      "points": {"A": [0, 0], "B": [6, 0], "G": [8, 0], "H": [12, 0], "C": [14, 0], "D": [20, 0], "P": [3, 0],
       "Q": [10, 0],
       "R": [17, 0]},
      "bodies": {"2": ["A", "B", "G", "P"], "3": ["G", "H", "Q"], "4": ["H", "C", "D", "R"]},
      "joints": [{"revolute": "A", "bodies": [1, 2]}, {"contact": "B", "bodies": [2, 1], "tangent": 0},
                 {"revolute": "G", "bodies": [2, 3]}, {"revolute": "H", "bodies": [3, 4]},
                 {"contact": "C", "bodies": [4, 1], "tangent": 0}, {"contact": "D", "bodies": [4, 1], "tangent": 0}],
      "loads": [{"force": "P_1", "body": 2, "at": "P", "value": [0, -40]}, {"force": "P_2", "body": 3, "at": "Q",
      "value": [0, -24]},
                {"force": "P_3", "body": 4, "at": "R", "value": [0, -30]}]})");
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_FALSE(solution.superposition);
    EXPECT_FALSE(says(solution, lang::sentences::moments_give));
    // Half of P_2 at either hinge: B = (40 · 3 + 12 · 8)/6, C = (30 · 3 + 12 · 8)/6.
    EXPECT_EQ(reaction_at(solution, "A"), (Vector{0, 16}));
    EXPECT_EQ(reaction_at(solution, "B"), (Vector{0, 36}));
    EXPECT_EQ(reaction_at(solution, "C"), (Vector{0, 31}));
    EXPECT_EQ(reaction_at(solution, "D"), (Vector{0, 11}));
    // P_1 is written with its letter, and polygons have a scale that can be read.
    const std::vector<Page> pages = sheet_of(solution);
    EXPECT_FALSE(pages::says(pages, "F_P_1"));
    EXPECT_FALSE(pages::says(pages, "× 10"));
}

// --- a body on bars
// ----------------------------------------------------------------------------------------------------------

/// Two of its struts share a pin, two a hinge of the frame: that is still one body, cut free once.
TEST(BodyOnBars, ThatSharePinsIsCutFreeOnce) {
    for (const bool at_body : {true, false}) {
        const std::string shared =
            at_body ? R"({"revolute": "K", "bodies": [2, 3, 4]}, {"revolute": "L", "bodies": [2, 5]},
                         {"revolute": "A", "bodies": [1, 3]}, {"revolute": "B", "bodies": [1, 4]})"
                    : R"({"revolute": "K", "bodies": [2, 3]}, {"revolute": "L", "bodies": [2, 5]}, {"revolute": "N",
                "bodies": [2, 4]},
                         {"revolute": "A", "bodies": [1, 3, 4]})";
        const std::string bar_4 = at_body ? R"(["B", "K"])" : R"(["A", "N"])";
        const Solution solution = solved(R"({"kinegraph": 1, "frame": 1,
          "points": {"A": [0, 0], "B": [2, 0], "C": [5, 0], "K": [1, 2], "L": [5, 2], "N": [3, 2], "P": [3, 3]},
          "bodies": {"2": ["K", "L", "N", "P"], "3": ["A", "K"], "4": )" +
                                         bar_4 + R"(, "5": ["C", "L"]},
          "joints": [)" + shared + R"(, {"revolute": "C", "bodies": [1, 5]}],
          "loads": [{"force": "F", "body": 2, "at": "P", "value": [100, -400]}]})");
        EXPECT_TRUE(solution.unsolved.empty());
        EXPECT_FALSE(says(solution, lang::sentences::structure_whole)) << at_body;
        // About the meet of the others: K, or A.
        const Vector up = reaction_at(solution, "C");
        EXPECT_EQ(up.x, Exact(0));
        EXPECT_EQ(up.y, at_body ? (Exact(400) * 2 + Exact(100) * 1) / 4 : (Exact(400) * 3 + Exact(100) * 3) / 5);
    }
}

// --- what a sentence of a truss names is drawn
// -------------------------------------------------------------------------------

/// By statement: strokes and letters that are drawn by it.
std::set<StatementIndex> drawn_by(const std::vector<Page>& pages) {
    std::set<StatementIndex> drawn;
    for (const Page& page : pages) {
        std::vector<StatementIndex> groups;
        for (const Mark& mark : page.marks) {
            const StatementIndex around = groups.empty() ? StatementIndex(none) : groups.back();
            if (const auto* group = std::get_if<GroupBegin>(&mark))
                groups.push_back(group->statement != none ? group->statement : around);
            else if (std::holds_alternative<GroupEnd>(mark))
                groups.pop_back();
            else if (const auto* path = std::get_if<Path>(&mark))
                drawn.insert(path->statement != none ? path->statement : around);
            else if (const auto* text = std::get_if<TextMark>(&mark); text && text->cls == "label")
                drawn.insert(text->statement != none ? text->statement : around);
        }
    }
    return drawn;
}
std::set<std::string> bars_on(const std::vector<Page>& pages) {
    std::set<std::string> bars;
    for (const Page& page : pages)
        for (const Mark& mark : page.marks)
            if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->cls == "bar")
                bars.insert(group->title);
    return bars;
}

class TrussSentence : public testing::Test {
protected:
    void expect_on_sheet(const Solution& solution, const std::vector<Page>& pages) {
        labels_ = labels_on(pages);
        bars_ = bars_on(pages);
        const std::set<StatementIndex> drawn = drawn_by(pages);
        for (const StatementIndex i : indices_of(solution.protocol.statements)) {
            const Statement& statement = solution.protocol.statements[at_index(i)];
            if (statement.section != Topic::forces) continue;
            const Key sentence = statement.message.sentence;
            const std::string said = english(statement.message);
            for (const Argument& argument : statement.message.arguments) expect_on_sheet(solution, argument, said);
            const bool draws = sentence != lang::sentences::truss_whole && sentence != lang::sentences::truss_stuck &&
                               sentence != lang::sentences::truss_closes &&
                               sentence != lang::sentences::known_resultant &&
                               sentence != lang::sentences::two_force_bar;  // of a bar, which is there
            EXPECT_TRUE(!draws || drawn.contains(i)) << said;
            if (sentence != lang::sentences::truss_plan) continue;
            for (const char letter : std::get<std::string>(statement.message.arguments.front()))
                EXPECT_TRUE(letter == ',' || letter == ' ' || labels_.contains(std::string(1, letter))) << said;
        }
    }

private:
    void expect_on_sheet(const Solution& solution, const Argument& argument, const std::string& said) const {
        const auto has_bar = [&](const std::string& name) {
            return solution.truss->structure.bar_named(solution.mechanism, name) >= 0;
        };
        if (const auto* names = std::get_if<Names>(&argument)) {
            for (const std::string& name : *names)
                EXPECT_TRUE(!has_bar(name) || bars_.contains(name)) << name << " of: " << said;
        }
        if (const auto* bar = std::get_if<BodyName>(&argument); bar && has_bar(bar->name)) {
            EXPECT_TRUE(bars_.contains(bar->name)) << bar->name << " of: " << said;
        }
        if (const auto* point = std::get_if<PointName>(&argument)) {
            if (has_bar(point->name))
                EXPECT_TRUE(bars_.contains(point->name)) << point->name << " of: " << said;
            else
                EXPECT_TRUE(labels_.contains(point->name)) << point->name << " of: " << said;
        }
        if (const auto* symbol = std::get_if<Symbol>(&argument)) expect_force(solution, *symbol, said);
        if (const auto* symbols = std::get_if<Symbols>(&argument))
            for (const Symbol& symbol : *symbols) expect_force(solution, symbol, said);
    }
    void expect_force(const Solution& solution, const Symbol& symbol, const std::string& said) const {
        if (symbol.letter != Symbol::Letter::F) return;
        if (solution.truss->structure.bar_named(solution.mechanism, symbol.about) >= 0)
            EXPECT_TRUE(bars_.contains(symbol.about)) << symbol.about << " of: " << said;
        else
            EXPECT_TRUE(labels_.contains(name_of(symbol)) || labels_.contains(plain(typeset(symbol, Language::en))))
                << name_of(symbol) << " of: " << said;
    }
    std::set<std::string> labels_, bars_;
};

class TrussExample : public TrussSentence, public testing::WithParamInterface<std::string> {};

TEST_P(TrussExample, HasTheLinesThatItsSentencesName) {
    const Solution& solution = example(GetParam());
    ASSERT_TRUE(solution.truss);
    expect_on_sheet(solution, sheet_of(solution));
}
INSTANTIATE_TEST_SUITE_P(Examples, TrussExample, testing::Values("truss_simple", "truss_roof_wind"),
                         [](const testing::TestParamInfo<std::string>& each) { return each.param; });

/// A truss on three links, which no two of meet on the load: Culmann's line over it, with its diagonal in a polygon.
TEST_F(TrussSentence, OfATrussOnThreeLinksHasCulmannsLine) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1,
      "points": {"A": [0,0], "B": [4,0], "C": [8,0], "D": [2,3], "E": [6,3], "P": [-2,-2], "Q": [4,-3], "R": [8,-3]},
      "bodies": {"2": ["A","B"], "3": ["B","C"], "4": ["A","D"], "5": ["D","B"], "6": ["D","E"], "7": ["B","E"],
      "8": ["E","C"],
                 "9": ["P","A"], "10": ["Q","B"], "11": ["R","C"]},
      "joints": [{"revolute": "A", "bodies": [2,4,9]}, {"revolute": "B", "bodies": [2,3,5,7,10]}, {"revolute": "C",
      "bodies": [3,8,11]},
                 {"revolute": "D", "bodies": [4,5,6]}, {"revolute": "E", "bodies": [6,7,8]}, {"revolute": "P",
                 "bodies": [1,9]},
                 {"revolute": "Q", "bodies": [1,10]}, {"revolute": "R", "bodies": [1,11]}],
      "loads": [{"force": "F_D", "pin": "D", "value": [3000, -8000]}, {"force": "F_E", "pin": "E", "value": [0,
      -6000]}]})");
    ASSERT_TRUE(solution.truss);
    EXPECT_TRUE(solution.unsolved.empty());
    EXPECT_TRUE(says(solution, lang::sentences::culmann_line));
    const std::vector<Page> pages = sheet_of(solution);
    expect_on_sheet(solution, pages);
    EXPECT_TRUE(labels_on(pages).contains("F_HK"));
    EXPECT_TRUE(figures_on(pages).contains("forces-truss"));
    EXPECT_TRUE(pages::says(pages, "Bar AP carries a force along itself."));
}

TEST(TrussSteps, ShowTheStringsAndTheirPolygon) {
    const std::set<std::string> figures = figures_on(lay_out_steps(example("truss_simple"), {}, fonts()));
    for (const char* id : {"truss", "forces-truss", "cremona"}) EXPECT_TRUE(figures.contains(id)) << id;
}

// --- loads that act alone
// ----------------------------------------------------------------------------------------------------

/// Each body that carries three forces is cut free under the loads of each row.
TEST(LoadsAlone, HaveTheirBodiesCutFree) {
    const Solution& solution = example("four_bar_weights");
    SheetOptions options;
    options.superposed = SuperposedLoads::each;
    const std::set<std::string> full = figures_on(sheet_of(solution, options));
    options.detail = SolutionDetail::brief;
    const std::set<std::string> brief = figures_on(sheet_of(solution, options));
    int bodies = 0;
    for (const Superposition::Part& part : solution.superposition->parts)
        for (const FreeBody& body : part.bodies) {
            if (body.body == none || solution.protocol.polygons[at_index(body.polygon)].vectors.size() < 3) continue;
            const std::string id =
                "body-" + solution.mechanism.body(body.body).name + "-load-" + name_of(solution.mechanism, part);
            EXPECT_TRUE(full.contains(id)) << id;
            EXPECT_FALSE(brief.contains(id)) << id;
            ++bodies;
        }
    EXPECT_GT(bodies, 0);
}

}  // namespace
}  // namespace whole_structures_test
