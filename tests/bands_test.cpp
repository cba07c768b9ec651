// Bands: pages are made of questions in the order of the solution, none torn apart, each sentence with the figure that it draws.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "render/sheet/sheet.hpp"
#include "tests/pages.hpp"

namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

/// One band as it stands on a page.
struct Shown {
    std::string question;
    std::size_t page = 0;
    bool has_figure = false;
    std::vector<int> numbers;              ///< of its sentences
    std::set<StatementIndex> said, drawn;  ///< by its sentences; by its figures
};

bool is_number(const std::string& words) {
    return !words.empty() && std::all_of(words.begin(), words.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<Shown> bands_of(const std::vector<Page>& pages) {
    std::vector<Shown> bands;
    for (std::size_t p = 0; p < pages.size(); ++p) {
        std::vector<const GroupBegin*> groups;
        for (const Mark& mark : pages[p].marks) {
            if (const auto* group = std::get_if<GroupBegin>(&mark)) {
                if (group->cls == "band") {
                    bands.emplace_back().question = *group->attribute("data-question");
                    bands.back().page = p;
                }
                groups.push_back(group);
            }
            const auto within = [&](const char* cls) {
                return std::any_of(groups.begin(), groups.end(), [&](const GroupBegin* g) { return g->cls == cls; });
            };
            const bool in_figure = within("figure");
            if (in_figure) {
                EXPECT_TRUE(within("band"));
                bands.back().has_figure = true;
                StatementIndex statement = none;
                for (const GroupBegin* group : groups)
                    if (group->statement != none) statement = group->statement;
                if (const auto* path = std::get_if<Path>(&mark); path && path->statement != none) statement = path->statement;
                if (statement != none) bands.back().drawn.insert(statement);
            } else if (const auto* text = std::get_if<TextMark>(&mark); text && text->statement != none) {
                EXPECT_TRUE(within("band")) << text->words;
                bands.back().said.insert(text->statement);
                if (is_number(text->words)) bands.back().numbers.push_back(std::stoi(text->words));
            }
            if (std::holds_alternative<GroupEnd>(mark)) groups.pop_back();
        }
    }
    return bands;
}

/// What a text's own band draws it need not be told elsewhere.
void expect_sentences_beside_their_figures(const std::vector<Shown>& bands) {
    std::map<StatementIndex, bool> beside;
    for (const Shown& band : bands)
        for (const StatementIndex statement : band.said) {
            const bool drawn_somewhere =
                std::any_of(bands.begin(), bands.end(), [&](const Shown& other) { return other.drawn.contains(statement); });
            if (drawn_somewhere) beside[statement] = beside[statement] || band.drawn.contains(statement) || !band.has_figure;
        }
    for (const auto& [statement, is] : beside) EXPECT_TRUE(is) << "statement " << statement.number();
}

TEST(Bands, AreReadInTheOrderOfTheSolutionAndNoneIsTorn) {
    int pages_in_all = 0;
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const auto pages = lay_out(example(name), {}, fonts());
        pages_in_all += static_cast<int>(pages.size());
        const std::vector<Shown> bands = bands_of(pages);
        ASSERT_FALSE(bands.empty());
        std::vector<int> numbers;
        std::map<std::string, int> figures_of;
        for (std::size_t b = 0; b < bands.size(); ++b) {
            numbers.insert(numbers.end(), bands[b].numbers.begin(), bands[b].numbers.end());
            figures_of[bands[b].question] += bands[b].has_figure ? 1 : 0;
            // Text alone goes on over pages, right after what it belongs to.
            const bool again = std::any_of(bands.begin(), bands.begin() + static_cast<std::ptrdiff_t>(b),
                                           [&](const Shown& before) { return before.question == bands[b].question; });
            if (again) {
                EXPECT_FALSE(bands[b].has_figure) << bands[b].question;
                EXPECT_EQ(bands[b - 1].question, bands[b].question);
            }
        }
        for (const auto& [question, count] : figures_of) EXPECT_LE(count, 1) << question;
        for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], static_cast<int>(i) + 1);
        expect_sentences_beside_their_figures(bands);
    }
    // 183 before there were bands, 186 with the arithmetic in the sentences; 4 more of examples that came later.
    EXPECT_LE(pages_in_all, 159);
}

}  // namespace
