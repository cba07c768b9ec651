// Closure equations of many bodies: no formula leaves its column, in the widest and the narrowest that sheets have, and
// none becomes too small to read.
#include <gtest/gtest.h>

#include <algorithm>

#include "constructions/solving/solve.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "render/equations/equation_block.hpp"
#include "render/page/shapes.hpp"
#include "tests/support/chains.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::render::long_equations_test {
namespace {

/// In pt: of the smallest piece of text, indices that belong to a letter left out.
double smallest_size(const Block& block) {
    double least = 1e300;
    for (const Mark& mark : block.marks) {
        const auto* text = std::get_if<TextMark>(&mark);
        if (text == nullptr || text->glyphs.empty()) continue;
        const auto larger = [](const Glyph& a, const Glyph& b) { return a.size < b.size; };
        least =
            std::min(least, std::max_element(text->glyphs.begin(), text->glyphs.end(), larger)->size / millimetres(1));
    }
    return least;
}

void expect_within(const std::string& file, Language language, const std::string& recipe) {
    SCOPED_TRACE(recipe);
    auto mechanism = read_mechanism(file, "long.json");
    ASSERT_TRUE(mechanism);
    mechanism->find.equations = true;
    const auto solution = solve(*std::move(mechanism));
    ASSERT_TRUE(solution);
    const auto theme = built_in_theme("colour");
    const DrawingContext context{*solution, *theme, tests::fonts(), language};
    const std::vector<EquationItem> items = equation_items(*solution, language);
    NaturalBlocks natural;
    constexpr double narrow = 56, wide = 80, overhang = 0.6, ink_of_a_line = 0.3, hardly_legible = 4.5;
    for (const double measure : {narrow, wide})
        for (const Block& block : equation_blocks(context, items, measure, natural)) {
            EXPECT_GE(smallest_size(block), hardly_legible);
            for (const Mark& mark : block.marks) {
                const auto* text = std::get_if<TextMark>(&mark);
                const Box ink = text != nullptr ? pages::ink_of(*text) : box_of(std::span(&mark, 1));
                EXPECT_GE(ink.min.x, -overhang) << (text != nullptr ? text->words : "");
                EXPECT_LE(ink.max.x, measure + ink_of_a_line) << (text != nullptr ? text->words : "");
            }
        }
}
/// A table is legible in any column: one that is too wide is set in parts, each with its first column.
TEST(LongEquations, TablesAreSetInPartsBeforeTheyAreTooSmall) {
    const Solution& solution = tests::example("virtual_work");
    const auto theme = built_in_theme("colour");
    const DrawingContext context{solution, *theme, tests::fonts(), Language::en};
    const std::string wide = "a head of some length";
    const std::vector<std::vector<Formula>> rows(8, std::vector<Formula>(5, Formula::upright(wide)));
    const std::vector<EquationItem> items{{.kind = EquationItem::Kind::table, .rows = rows}};
    constexpr double narrow = 56, least = 2.4;  // mm
    NaturalBlocks natural;
    std::size_t lines = 0;  // a head is one with the first row
    for (const Block& block : equation_blocks(context, items, narrow, natural)) {
        EXPECT_GE(smallest_size(block) * millimetres(1), least);
        EXPECT_LE(block.width, narrow + 1e-9);
        ++lines;
    }
    EXPECT_EQ(lines % 7, 0U);
    EXPECT_GE(lines, 14U);
}

Language language_of(std::uint64_t seed) { return seed % 2 == 0 ? Language::en : Language::it; }

TEST(LongEquations, OfChainsOfDyadsStayWithinTheirColumn) {
    for (const int dyads : {3, 4}) {  // eight and ten bodies
        const RandomMechanism chain = chain_of_dyads(dyads, 1);
        expect_within(chain.text, language_of(static_cast<std::uint64_t>(dyads)), chain.recipe);
    }
}

TEST(LongEquations, OfEightBarsStayWithinTheirColumn) {
    constexpr std::uint64_t first = 2600, apart = 13;  // among the chains of eight links
    for (int i = 0; i < unless_sanitized(6, 2); ++i) {
        const std::uint64_t seed = first + apart * static_cast<std::uint64_t>(i);
        const ChainMechanism chain = random_chain_mechanism(seed);
        expect_within(chain.text, language_of(seed), chain.recipe);
    }
}

TEST(LongEquations, OfRandomMechanismsStayWithinTheirColumn) {
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(unless_sanitized(10, 3)); ++seed) {
        const RandomMechanism drawn = random_mechanism(seed);
        expect_within(drawn.text, language_of(seed), drawn.recipe);
    }
}

}  // namespace
}  // namespace kinegraph::render::long_equations_test
