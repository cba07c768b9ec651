// data-statement: what a statement of the solution draws says so in the SVG, on the figures and beside its sentence.
#include <gtest/gtest.h>

#include <algorithm>
#include <list>
#include <map>
#include <pugixml.hpp>
#include <set>

#include "lang/keys/sentences.hpp"
#include "render/backends/backends.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/sheet/sheet.hpp"
#include "render/sheet/steps.hpp"
#include "tests/support/pages.hpp"

namespace data_statement_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

/// An element of an SVG with the statement that it belongs to: its own, or that of the nearest group that has one; −1:
/// none.
struct Element {
    pugi::xml_node node;
    std::string figure;  // id
    StatementIndex statement;
    bool own;
    bool is(const char* cls) const { return std::string(node.attribute("class").value()) == cls; }
    std::string label() const { return node.attribute("aria-label").value(); }
    std::string name() const { return node.attribute("data-name").value(); }
};

class Svg {
public:
    explicit Svg(const std::vector<Page>& pages) {
        for (const std::string& text : to_svg(pages, fonts())) {
            documents_.emplace_back();
            EXPECT_TRUE(documents_.back().load_string(text.c_str()));
            walk(documents_.back().document_element(), "", none);
        }
    }
    std::vector<Element> elements;

    const Element& vector(const std::string& figure, const std::string& name) const {
        const auto found = std::find_if(elements.begin(), elements.end(),
                                        [&](const Element& e) { return e.figure == figure && e.name() == name; });
        if (found == elements.end()) throw std::runtime_error(figure + " has no " + name);
        return *found;
    }

private:
    void walk(const pugi::xml_node& node, const std::string& figure, StatementIndex statement) {
        for (const pugi::xml_node child : node.children()) {
            if (child.type() != pugi::node_element || std::string(child.name()) == "defs") continue;
            const pugi::xml_attribute own = child.attribute("data-statement");
            const StatementIndex drawn_by = own ? StatementIndex(own.as_int(-1)) : statement;
            const bool is_figure = std::string(child.attribute("class").value()) == "figure";
            const std::string in = is_figure ? child.attribute("id").value() : figure;
            elements.push_back({child, in, drawn_by, !own.empty()});
            walk(child, in, drawn_by);
        }
    }
    std::list<pugi::xml_document> documents_;
};

Svg sheet(const std::string& name) { return Svg(laid_out(name)); }
Svg figure(const Solution& solution, const std::string& name) {
    const auto page = lay_out_alone(solution, {}, name, fonts());
    if (!page) throw std::runtime_error("no figure " + name);
    return Svg({*page});
}
const Message& message_of(const Solution& solution, StatementIndex statement) {
    return solution.protocol.statements.at(at_index(statement)).message;
}

class DataStatement : public testing::TestWithParam<std::string> {};

TEST_P(DataStatement, IsAlwaysOneOfTheSolution) {
    const Solution& solution = example(GetParam());
    std::size_t told = 0;
    for (const Element& each : sheet(GetParam()).elements) {
        if (!each.own) continue;
        ++told;
        EXPECT_NE(each.statement, none);
        EXPECT_LT(at_index(each.statement), solution.protocol.statements.size());
    }
    EXPECT_GT(told, solution.protocol.statements.size());
}

TEST_P(DataStatement, StandsOnEveryVectorAndLineOfThePolygonsOfMotion) {
    const Solution& solution = example(GetParam());
    const Svg svg = sheet(GetParam());
    for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p) {
        const Polygon& polygon = solution.protocol.polygons[p];
        if (polygon.plane == Plane::force) continue;
        std::set<StatementIndex> vectors, lines;
        for (const Element& each : svg.elements) {
            if (each.figure != legal_id(polygon.id)) continue;
            if (each.is("vector")) {
                EXPECT_TRUE(each.own) << each.name();
                vectors.insert(each.statement);
            }
            if (std::string(each.node.name()) == "path" && each.statement != none) lines.insert(each.statement);
        }
        ASSERT_FALSE(vectors.empty()) << polygon.id;
        std::set<StatementIndex> drawn;
        for (const int v : polygon.vectors)
            drawn.insert(solution.protocol.vectors[static_cast<std::size_t>(v)].statement);
        EXPECT_TRUE(std::includes(drawn.begin(), drawn.end(), vectors.begin(), vectors.end())) << polygon.id;
        for (const DrawnLine& line : solution.protocol.lines) {
            if (line.polygon != static_cast<int>(p) || solution.protocol.line(line.line).at_infinity()) continue;
            EXPECT_TRUE(lines.contains(line.statement)) << polygon.id << ", statement " << line.statement.number();
        }
    }
}

TEST_P(DataStatement, StandsOnEverySentence) {
    const Solution& solution = example(GetParam());
    std::map<StatementIndex, std::string> said;  // by statement, all that stands outside of the figures
    for (const Element& each : sheet(GetParam()).elements)
        if (each.figure.empty() && each.own && each.is("text")) said[each.statement] += each.label() + " ";
    ASSERT_FALSE(said.empty());
    for (const auto& [statement, words] : said) {
        // What the list of centres says as well stands there alone.
        if (message_of(solution, statement).sentence == lang::sentences::kennedy) continue;
        const std::string sentence = plain(say(message_of(solution, statement), Language::en));
        EXPECT_TRUE(words.find(sentence.substr(0, 20)) != std::string::npos ||
                    solution.protocol.statements[at_index(statement)].section == Topic::centres)
            << words << "\n  instead of\n"
            << sentence;
    }
}

INSTANTIATE_TEST_SUITE_P(Examples, DataStatement, testing::Values("four_bar", "quick_return", "slider_crank"),
                         [](const auto& tested) { return tested.param; });

TEST(DataStatement, NamesTheStatementOfEachVectorOfTheFourBar) {
    const Solution& solution = example("four_bar");
    const Svg svg = sheet("four_bar");
    for (const char* name : {"v_A", "v_B", "v_BA"}) {
        const auto drawn = std::find_if(solution.protocol.vectors.begin(), solution.protocol.vectors.end(),
                                        [&](const DrawnVector& v) { return name_of(v.symbol) == name; });
        ASSERT_NE(drawn, solution.protocol.vectors.end()) << name;
        EXPECT_EQ(svg.vector("velocity", name).statement, drawn->statement) << name;
    }
    // v_A is found before v_B, and by another sentence.
    EXPECT_LT(svg.vector("velocity", "v_A").statement, svg.vector("velocity", "v_B").statement);
    for (const InstantCentre& centre : solution.centres) {
        const std::string label =
            plain(typeset(Symbol{Symbol::Letter::centre, solution.mechanism.bodies[at_index(centre.first)].name,
                                 solution.mechanism.bodies[at_index(centre.second)].name},
                          Language::en));
        const bool marked = std::any_of(svg.elements.begin(), svg.elements.end(), [&](const Element& each) {
            return each.is("centre") && each.statement == centre.statement && each.own;
        });
        EXPECT_TRUE(marked || !centre.at || centre.at->at_infinity()) << label;
    }
}

TEST(DataStatement, NamesTheStatementsOfTheForcesOfTheGate) {
    const Solution& solution = example("sluice_gate");
    // The weight is given: no statement draws it. The others are read off the triangle that closes at H.
    const Svg body = figure(solution, "body-1");
    EXPECT_FALSE(body.vector("body-1", "F_g").own);
    for (const char* name : {"F_21", "F_01"}) {
        const Element& force = body.vector("body-1", name);
        ASSERT_TRUE(force.own) << name;
        EXPECT_NE(plain(say(message_of(solution, force.statement), Language::en)).find("On body 1"), std::string::npos)
            << name;
    }
    const Svg lines = figure(solution, "lines-of-action");
    std::set<std::string> said;
    for (const Element& each : lines.elements)
        if (each.own) said.insert(plain(say(message_of(solution, each.statement), Language::en)).substr(0, 9));
    EXPECT_TRUE(said.contains("Body 2 ca"));  // line CD
    EXPECT_TRUE(said.contains("On body 1"));  // H and F_01
    EXPECT_TRUE(said.contains("On body 3"));
    // Each side of a body's triangle is of the sentence that closes it.
    for (const Element& each : figure(solution, "forces").elements) {
        if (!each.is("vector")) continue;
        const Key sentence = message_of(solution, each.statement).sentence;
        EXPECT_TRUE(sentence == lang::sentences::triangle_at || sentence == lang::sentences::triangle) << each.name();
    }
}

TEST(DataStatement, LeavesOutWhatTheGroupRoundItSays) {
    Page page;
    page.marks.emplace_back(GroupBegin{"vector", GroupId("a"), "", {}, StatementIndex(3)});
    page.marks.emplace_back(line({0, 0}, {10, 0}, {}));
    belong(page.marks, 1, StatementIndex(3));
    page.marks.emplace_back(line({0, 0}, {10, 10}, {}));
    belong(page.marks, 2, StatementIndex(4));
    page.marks.emplace_back(GroupEnd{});
    const std::string svg = to_svg(page, fonts());
    EXPECT_NE(svg.find("<g class=\"vector\" id=\"a\" data-statement=\"3\">"), std::string::npos) << svg;
    EXPECT_EQ(svg.find("data-statement=\"3\"", svg.find("<path")), std::string::npos) << svg;
    EXPECT_NE(svg.find("data-statement=\"4\""), std::string::npos) << svg;
}

TEST(RichMarks, CarryTheScriptsOfALabel) {
    // The acceleration of B against A, tangential: three stretches of type, not one word.
    const Solution& solution = example("four_bar");
    const auto page = lay_out_alone(solution, {}, "acceleration", fonts());
    ASSERT_TRUE(page);
    bool found = false;
    for (const TextMark* text : texts_of(*page)) {
        if (text->cls != "label" || text->words != "a_BA^t") continue;
        found = true;
        ASSERT_EQ(text->text.size(), 1u);
        EXPECT_EQ(text->text[0].text, "a");
        EXPECT_EQ(text->text[0].sub, "BA");
        EXPECT_EQ(text->text[0].sup, "t");
    }
    EXPECT_TRUE(found);
    // A dotted ω is a letter and its dots.
    const auto italian = lay_out_steps(
        solution,
        [] {
            SheetOptions options;
            options.language = Language::it;
            return options;
        }(),
        fonts());
    bool dotted = false;
    for (const Page& each : italian)
        for (const TextMark* text : texts_of(each))
            dotted = dotted || std::any_of(text->text.begin(), text->text.end(),
                                           [](const Piece& piece) { return piece.text == "ω" && piece.dots == 1; });
    EXPECT_TRUE(dotted);
}

}  // namespace
}  // namespace data_statement_test
