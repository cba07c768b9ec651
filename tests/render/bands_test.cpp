// Bands: pages are made of questions in the order of the solution, none torn apart, each sentence with the figure that
// it draws.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/number/index.hpp"
#include "lang/keys/sentences.hpp"
#include "lang/keys/sheet.hpp"
#include "render/backends/backends.hpp"
#include "render/backends/picture_difference.hpp"
#include "render/content/title_block.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/four_bars_in_a_row.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/random_mechanism.hpp"

namespace bands_test {
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
                if (const auto* path = std::get_if<Path>(&mark); path && path->statement != none)
                    statement = path->statement;
                if (statement != none) bands.back().drawn.insert(statement);
            } else if (const auto* text = std::get_if<TextMark>(&mark); text && text->statement != none) {
                EXPECT_TRUE(within("band")) << text->words;
                bands.back().said.insert(text->statement);
                if (is_number(text->words) && text->words != "0")  // that of a bar without force, which a sentence says
                    bands.back().numbers.push_back(std::stoi(text->words));
            }
            if (std::holds_alternative<GroupEnd>(mark)) groups.pop_back();
        }
    }
    return bands;
}

/// What a text's own band draws it need not be told elsewhere. The arcs of what turns stand on the first figure once
/// more.
void expect_sentences_beside_their_figures(const std::vector<Shown>& bands, const Solution& solution) {
    const auto finds_turning = [&](StatementIndex statement) {
        const std::vector<Quantity>& finds = solution.protocol.statements[at_index(statement)].finds;
        return std::any_of(finds.begin(), finds.end(), [](const Quantity& found) {
            return found.kind == Quantity::Kind::omega || found.kind == Quantity::Kind::alpha;
        });
    };
    std::map<StatementIndex, bool> beside;
    for (const Shown& band : bands)
        for (const StatementIndex statement : band.said) {
            const bool drawn_somewhere = std::any_of(bands.begin(), bands.end(), [&](const Shown& other) {
                return other.drawn.contains(statement) && !(other.question == "given" && finds_turning(statement));
            });
            if (drawn_somewhere)
                beside[statement] = beside[statement] || band.drawn.contains(statement) || !band.has_figure;
        }
    for (const auto& [statement, is] : beside) EXPECT_TRUE(is) << "statement " << statement.number();
}

/// The share of squares of 10 mm within the frame on which something is drawn.
double fill_of(const Page& page, const SheetFormat& format) {
    constexpr double dpi = 50, square = 10, millimetre = dpi / 25.4, off_frame = 1;
    constexpr int white = 250;
    const Picture picture = decode_png(to_png(page, fonts(), dpi)).value();
    const auto is_inked = [&](double x, double y) {
        for (auto row = static_cast<int>(y * millimetre); row < static_cast<int>((y + square) * millimetre); ++row)
            for (auto column = static_cast<int>(x * millimetre); column < static_cast<int>((x + square) * millimetre);
                 ++column) {
                const Colour ink = picture.at(column, row);
                if (std::min({ink.red, ink.green, ink.blue}) < white) return true;
            }
        return false;
    };
    const Box& room = format.inner;
    int squares = 0, inked = 0;
    for (double y = room.min.y + off_frame; y + square < room.max.y - off_frame; y += square)
        for (double x = room.min.x + off_frame; x + square < room.max.x - off_frame; x += square) {
            ++squares;
            inked += is_inked(x, y) ? 1 : 0;
        }
    return static_cast<double>(inked) / squares;
}

/// The statements told with a number, in the order of their numbers.
std::vector<StatementIndex> in_order_of_numbers(const std::vector<Page>& pages) {
    std::map<int, StatementIndex> told;
    for (const Page& page : pages) {
        int depth = 0, figure = 0;  // numbers in figures are those of lines
        for (const Mark& mark : page.marks) {
            if (const auto* group = std::get_if<GroupBegin>(&mark);
                group && (++depth, figure == 0) && group->cls == "figure")
                figure = depth;
            const auto* text = std::get_if<TextMark>(&mark);
            if (text && figure == 0 && text->statement != none && is_number(text->words))
                told.emplace(std::stoi(text->words), text->statement);
            if (std::holds_alternative<GroupEnd>(mark) && depth-- == figure) figure = 0;
        }
    }
    std::vector<StatementIndex> order;
    for (const auto& [number, statement] : told)
        if (std::find(order.begin(), order.end(), statement) == order.end()) order.push_back(statement);
    return order;
}

/// By its name, with the statement that finds it; what is given has none.
std::map<std::string, StatementIndex> found_by(const Solution& solution) {
    std::map<std::string, StatementIndex> found;
    for (const FreeBody& body : solution.free_bodies)
        for (const AppliedForce& applied : body.forces)
            if (!body.in_parts && applied.force_statement != none)
                found.emplace(name_of(applied.symbol), applied.force_statement);
    return found;
}

/// Of the forces that a statement closes a polygon with, those that others find.
std::map<std::string, StatementIndex> used_by(const Solution& solution, StatementIndex statement) {
    std::map<std::string, StatementIndex> used;
    for (const FreeBody& body : solution.free_bodies)
        if (body.statement == statement && !body.in_parts)
            for (const AppliedForce& applied : body.forces)
                if (applied.force_statement != none && applied.force_statement != statement)
                    used.emplace(name_of(applied.symbol), applied.force_statement);
    const Message& said = solution.protocol.statements[at_index(statement)].message;
    const auto found = found_by(solution);
    if (said.sentence == lang::sentences::known_resultant)
        for (const Symbol& symbol : std::get<Symbols>(said.arguments[1]))
            if (const auto finding = found.find(name_of(symbol)); finding != found.end()) used.insert(*finding);
    return used;
}

TEST(Bands, UseNoForceBeforeTheSentenceThatFindsIt) {
    std::size_t turn = 0, used = 0;
    for (const std::string& name : example_names()) {
        const Solution& solution = example(name);
        if (solution.free_bodies.empty()) continue;
        for (const SolutionDetail detail : {SolutionDetail::full, SolutionDetail::brief})
            for (const Language language : {Language::en, Language::it}) {
                if (++turn % unless_sanitized(1, 3) != 0) continue;
                std::set<StatementIndex> told;
                const std::vector<StatementIndex> order =
                    in_order_of_numbers(laid_out(name, {.language = language, .detail = detail}));
                for (const StatementIndex statement : order) {
                    for (const auto& [force, finding] : used_by(solution, statement)) {
                        const bool is_told = std::find(order.begin(), order.end(), finding) != order.end();
                        EXPECT_TRUE(!is_told || told.contains(finding))
                            << name << ": " << force << " by " << statement.number() << ", found by "
                            << finding.number();
                        ++used;
                    }
                    told.insert(statement);
                }
            }
    }
    EXPECT_GT(used, 0U);
}

/// What bodies are taken together for may hang on a force that another body gave before.
TEST(Bands, TakeBodiesTogetherWhereTheyAreSolved) {
    // The lever's load presses on the slider: that force is known before rod and slider are taken together.
    const Solution solution = tests::solved(R"({"kinegraph": 1, "frame": 1,
        "points": {"O": [0, 0], "A": [3, 4], "B": [15, 0], "G": [9, 4], "P": [16, 0], "C": [16, 5], "D": [12, 5]},
        "bodies": {"2": ["O", "A"], "3": ["A", "B", "G"], "4": ["B", "P"], "5": ["C", "D"]},
        "joints": [{"revolute": "O", "bodies": [1, 2]}, {"revolute": "A", "bodies": [2, 3]},
        {"revolute": "B", "bodies": [3, 4]}, {"prismatic": "B", "bodies": [4, 1], "along": 0},
        {"revolute": "C", "bodies": [1, 5]}, {"contact": "P", "bodies": [4, 5], "tangent": 90, "pushes": [-1, 0]}],
        "loads": [{"force": "Q", "body": 3, "at": "G", "value": [1, -6]},
        {"force": "W", "body": 5, "at": "D", "value": [0, 5]}], "effort": {"couple": "M", "body": 2}})");
    ASSERT_FALSE(solution.taken_together.empty());
    const std::vector<StatementIndex> order = in_order_of_numbers(lay_out(solution, {}, fonts()));
    const StatementIndex together = solution.taken_together.front().statement;
    const auto place = [&](StatementIndex of) { return std::find(order.begin(), order.end(), of) - order.begin(); };
    int before = 0;
    for (const FreeBody& body : solution.free_bodies)
        for (const AppliedForce& each : body.forces)
            if (each.force_statement != none && each.force_statement < together) {
                EXPECT_LT(place(each.force_statement), place(together)) << name_of(each.symbol);
                ++before;
            }
    EXPECT_GT(before, 0) << "nothing is found before";
}

/// How full pages are is a matter of taste: reported, and bounded only where something has gone wrong.
TEST(Bands, LeaveNoPageNearlyEmpty) {
    const SheetFormat format = format_of(Paper::a4, Orientation::landscape);
    // A mechanism that fills its page by itself, with its bodies and centres beside it, covers a third of it.
    constexpr double least = 0.3, most_pages = 1.1 * 142;  // 142 of all examples in November 2026
    double sum = 0;
    std::size_t filled = 0, pages_in_all = 0;
    for (const std::string& name : example_names()) {
        const std::vector<Page>& pages = laid_out(name);
        pages_in_all += pages.size();
        for (std::size_t p = 0; p + 1 < pages.size(); ++p) {
            const double fill = fill_of(pages[p], format);
            EXPECT_GE(fill, least) << name << ", page " << p + 1;
            sum += fill;
            ++filled;
        }
    }
    ASSERT_GT(filled, 0U);
    EXPECT_LE(static_cast<double>(pages_in_all), most_pages);
    const double mean = sum / static_cast<double>(filled);
    RecordProperty("fill", std::to_string(mean));
    std::cout << pages_in_all << " pages; all but the last of each sheet " << 100 * mean << " % full\n";
}

TEST(Bands, TellNothingLikewiseBeforeItsVectorIsDrawn) {
    std::string words = words_of(laid_out("quick_return"));
    std::replace(words.begin(), words.end(), '\n', ' ');
    const std::size_t drawn = words.find("they meet in d and close"), read = words.find("ω_5 is v_DC divided by CD");
    ASSERT_NE(drawn, std::string::npos);
    ASSERT_NE(read, std::string::npos);
    EXPECT_LT(drawn, read);
}

TEST(Bands, AreReadInTheOrderOfTheSolutionAndNoneIsTorn) {
    std::size_t numbered = 0;
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const auto& solution = example(name);
        const std::vector<Page>& pages = laid_out(name);
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
        numbered += numbers.size();
        for (const auto& [question, count] : figures_of) EXPECT_LE(count, 1) << question;
        for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], static_cast<int>(i) + 1);
        expect_sentences_beside_their_figures(bands, solution);
    }
    EXPECT_GT(numbered, example_names().size());
}

/// What 22 bodies have to be told about goes on over pages.
const std::vector<Page>& crowded_pages() {
    static const std::vector<Page> pages = lay_out(tests::solved(tests::four_bars_in_a_row(10)), {}, fonts());
    return pages;
}

TEST(Bands, ThatGoOnSayWhereTheirFiguresStand) {
    const std::vector<Page>& pages = crowded_pages();
    int told = 0;
    for (std::size_t p = 0; p < pages.size(); ++p)
        for (const Mark& mark : pages[p].marks) {
            const auto* text = std::get_if<TextMark>(&mark);
            const std::size_t at = text ? text->words.find(", sheet ") : std::string::npos;
            if (at == std::string::npos) continue;
            ++told;
            EXPECT_EQ(text->words.find("Fig. "), text->words.rfind("Fig. ", at)) << text->words;
            EXPECT_LE(std::stoi(text->words.substr(at + 8)), static_cast<int>(p)) << text->words;
        }
    EXPECT_GE(told, 2);
    EXPECT_EQ(word(lang::sheet::on_sheet, Language::it), "foglio");
}

/// A sentence that speaks of all bodies but two was higher than any page, of 82.
TEST(Bands, TellOnlySoManyLikewiseInOneSentence) {
    int sentences = 0;
    for (const Page& page : crowded_pages())
        for (const Mark& mark : page.marks)
            if (const auto* text = std::get_if<TextMark>(&mark); text && text->words.starts_with("Second way: "))
                ++sentences;
    EXPECT_EQ(sentences, 2);  // 20 bodies, 17 of them in the first
}

}  // namespace
}  // namespace bands_test
