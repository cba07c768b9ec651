// The catalogue of pairs drawn: every pair has its figure, what it shows is what the table says, and no page has a
// fault.
#include "engine/file/units.hpp"  // before signal.h, which makes a macro of si_value

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "render/backends/backends.hpp"
#include "render/figures/pair_figures.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/pages.hpp"

namespace kinegraph::catalogue_sheet_test {
namespace {

using namespace pages;

/// What the labels of a figure say, without scripts' marks.
std::multiset<std::string> names_on(const Figure& figure) {
    std::multiset<std::string> names;
    for (const Mark& mark : figure.marks)
        if (const auto* text = std::get_if<TextMark>(&mark); text && !text->words.empty()) names.insert(text->words);
    return names;
}
std::set<std::string> figure_ids(const std::vector<Page>& sheets) {
    std::set<std::string> ids;
    for (const Page& page : sheets)
        for (const Mark& mark : page.marks)
            if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->cls == "figure")
                ids.insert(group->id.text());
    return ids;
}

class CatalogueSheets : public testing::TestWithParam<const char*> {};

TEST_P(CatalogueSheets, AreCleanInBothLanguagesAndHaveEveryFigure) {
    for (const Language language : {Language::en, Language::it}) {
        SheetOptions options;
        options.language = language;
        options.theme = *built_in_theme(GetParam());
        options.orientation = language == Language::en ? Orientation::landscape : Orientation::portrait;
        const std::vector<Page> sheets = lay_out_catalogue(options, fonts());
        expect_clean(sheets);
        for (const Page& page : sheets) expect_sound_groups(page);
        const std::set<std::string> ids = figure_ids(sheets);
        for (const PlanePair& pair : plane_pairs)
            EXPECT_TRUE(ids.contains("pair-" + std::string(pair.key))) << pair.key;
        for (const SpacePair& pair : space_pairs)
            EXPECT_TRUE(ids.contains("space-" + std::string(pair.key))) << pair.key;
        // Two closures, three links, three chains, a hinge of three bodies with three schemes, sixteen of four.
        EXPECT_EQ(ids.size(), plane_pairs.size() + space_pairs.size() + 2 + 3 + 3 + 4 + 16);
        EXPECT_TRUE(says(
            sheets, language == Language::en ? "Form closure and force closure" : "Accoppiamento di forma e di forza"));
        EXPECT_EQ(says(sheets, "closure"), language == Language::en) << "nothing is left in the other language";
    }
}
INSTANTIATE_TEST_SUITE_P(Themes, CatalogueSheets, testing::Values("colour", "print", "dark"));

TEST(CatalogueFigures, ShowAsManyReactionsAsTheTableHas) {
    const Solution solution;
    const Theme theme;
    const DrawingContext context{solution, theme, fonts()};
    const auto count = [](const Figure& figure, const std::string& letters) {
        int found = 0;
        for (const std::string& name : names_on(figure)) found += letters.find(name[0]) != std::string::npos ? 1 : 0;
        return found;
    };
    for (const PlanePair& pair : plane_pairs) {
        const Figure figure = plane_pair_figure(context, pair.kind);
        EXPECT_EQ(count(figure, "FM"), pair.reactions()) << pair.key;
        EXPECT_EQ(count(figure, "rt"), pair.freedoms()) << pair.key;
    }
    for (const SpacePair& pair : space_pairs) {
        const Figure figure = space_pair_figure(context, pair);
        const int tied = pair.key == "helical" ? 1 : 0;  // one motion and one reaction have two components
        EXPECT_EQ(count(figure, "FM") - tied, pair.reaction_count()) << pair.key;
        EXPECT_EQ(count(figure, "rt") - tied, pair.freedoms) << pair.key;
    }
}

class CatalogueCommands : public tests::CommandLine {};

TEST_F(CatalogueCommands, DrawTheCatalogueAndRefuseWhatHasNoDrawing) {
    EXPECT_EQ(run("pairs -o catalogue.svg --lang it").status, 0);
    const std::string first = tests::contents((folder_ / "catalogue.svg").string());
    EXPECT_NE(first.find("pair-revolute"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "catalogue-2.svg"));
    EXPECT_EQ(run("pairs -o again.svg --lang it").status, 0);
    EXPECT_EQ(first, tests::contents((folder_ / "again.svg").string())) << "the same bytes";
    EXPECT_EQ(run("pairs -o catalogue.json").status, 0);
    EXPECT_EQ(run("pairs --format json").out, tests::contents((folder_ / "catalogue.json").string()));
    const tests::Outcome refused = run("pairs four_bar.json -o pairs.svg");
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("leave four_bar.json out"), std::string::npos) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "pairs.svg"));
    EXPECT_EQ(run("pairs four_bar.json -o four_bar.json").status, 2) << "not over the file itself";
    EXPECT_EQ(run("pairs -o catalogue.csv").status, 2);
}

}  // namespace
}  // namespace kinegraph::catalogue_sheet_test
