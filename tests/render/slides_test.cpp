// Slides: steps on pages of 16:9. Nothing moves, nothing is cut off, every page says what it shows.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "render/backends/backends.hpp"
#include "render/page/scale.hpp"
#include "render/sheet/steps.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/pages.hpp"

namespace slides_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

SheetOptions slides(Language language = Language::en) {
    SheetOptions options;
    options.paper = Paper::slide;
    options.language = language;
    return options;
}

/// The labels of a page with their places.
std::set<std::string> labels_of(const Page& page) {
    std::set<std::string> labels;
    for (const TextMark* text : texts_of(page))
        if (text->cls == "label" && !text->glyphs.empty())
            labels.insert(text->words + " at " + std::to_string(text->glyphs.front().origin.x) + ", " +
                          std::to_string(text->glyphs.front().origin.y));
    return labels;
}

class Slides : public testing::TestWithParam<std::string> {};

TEST_P(Slides, AreCleanAndNothingMoves) {
    const Solution& solution = example(GetParam());
    for (const Language language : {Language::en, Language::de}) {
        const auto pages = lay_out_steps(solution, slides(language), fonts());
        expect_clean(pages, 4, 4);  // a margin of 6 mm, which the boxes of large letters overhang by less than 2
        std::map<std::string, std::set<std::string>> before;
        std::size_t said = 0;
        for (const Page& page : pages) {
            EXPECT_DOUBLE_EQ(page.width / page.height, 16.0 / 9);
            expect_sound_groups(page);
            if (!page.step) continue;
            ++said;
            EXPECT_FALSE(page.step->sentences.empty());
            for (const RichText& each : page.step->sentences) EXPECT_FALSE(plain(each).empty());
            std::set<std::string> now = labels_of(page);
            const std::set<std::string>& then = before[page.step->figure];
            EXPECT_TRUE(std::includes(now.begin(), now.end(), then.begin(), then.end())) << page.step->figure;
            before[page.step->figure] = std::move(now);
        }
        EXPECT_GT(said, 0U);
    }
}

INSTANTIATE_TEST_SUITE_P(Examples, Slides,
                         testing::Values("four_bar", "slider_crank", "gas_force", "planetary_train", "jansen_leg",
                                         "sluice_gate", "four_bar_weights", "stephenson_3_driver_6",
                                         "contact/ball_on_plane", "act_of_motion_general"),
                         [](const testing::TestParamInfo<std::string>& each) {
                             std::string name = each.param;
                             std::replace(name.begin(), name.end(), '/', '_');
                             return name;
                         });

TEST(SlidesOfTheFourBar, HaveNoTitleBlockAndLargerType) {
    const auto pages = lay_out_steps(example("four_bar"), slides(), fonts());
    const auto sheets = lay_out_steps(example("four_bar"), {}, fonts());
    EXPECT_EQ(pages.size(), sheets.size());
    EXPECT_FALSE(says(pages, "Scale"));
    EXPECT_TRUE(says(sheets, "Scale"));
    EXPECT_TRUE(says(pages.front(), "1 / " + std::to_string(pages.size())));
    for (const Page& page : pages) EXPECT_GE(page.step->size / page.height, 1.9 * 11.25 / 210);
}

TEST(SlidesOfTheFourBar, WithoutSentencesTheirWordsAreSaidOnly) {
    SheetOptions silent = slides();
    silent.with_sentences = false;
    const auto with = lay_out_steps(example("four_bar"), slides(), fonts()),
               without = lay_out_steps(example("four_bar"), silent, fonts());
    ASSERT_EQ(with.size(), without.size());
    EXPECT_TRUE(says(with, "draw the lines"));
    EXPECT_FALSE(says(without, "draw the lines"));
    for (std::size_t i = 0; i < with.size(); ++i) {
        EXPECT_EQ(labels_of(with[i]), labels_of(without[i]));
        ASSERT_TRUE(with[i].step && without[i].step);
        EXPECT_EQ(plain(with[i].step->sentences.front()), plain(without[i].step->sentences.front()));
    }
}

// Before a slide of a film stand pictures in which its lines grow; the slides themselves stay as they are, and a
// picture has no letter that its slide has not.
TEST(SlidesOfTheFourBar, GrowInAFilm) {
    SheetOptions film = slides();
    film.growing = 3;
    const auto still = lay_out_steps(example("four_bar"), slides(), fonts());
    const auto pages = lay_out_steps(example("four_bar"), film, fonts());
    std::vector<Page> whole;
    std::size_t in_a_row = 0, grown = 0;
    for (std::size_t i = 0; i < pages.size(); ++i) {
        if (!pages[i].step->grows) {
            whole.push_back(pages[i]);
            EXPECT_TRUE(in_a_row == 0 || in_a_row == 3) << in_a_row;
            grown += in_a_row;
            in_a_row = 0;
            continue;
        }
        ++in_a_row;
        ASSERT_LT(i + 1, pages.size());
        const std::set<std::string> now = labels_of(pages[i]), then = labels_of(pages[i + 1]);
        EXPECT_TRUE(std::includes(then.begin(), then.end(), now.begin(), now.end()));
        EXPECT_NE(to_svg(pages[i], fonts()), to_svg(pages[i + 1], fonts())) << "a line has grown";
    }
    EXPECT_EQ(in_a_row, 0U);
    EXPECT_GT(grown, 15U);
    EXPECT_EQ(to_svg(whole, fonts()), to_svg(still, fonts()));
}

TEST(SlidesOfTheFourBar, GrowInSoManyPicturesAndNoMore) {
    SheetOptions film = slides();
    film.growing = 100'000;
    EXPECT_LE(lay_out_steps(example("four_bar"), film, fonts()).size(), 613U);
    film.growing = 0;
    EXPECT_EQ(lay_out_steps(example("four_bar"), film, fonts()).size(), 13U);
}

// On a slide no ruler is laid: a polygon is drawn larger than at the round scale that a sheet of that room would have.
TEST(SlidesOfTheFourBar, HaveFiguresThatFillTheirRoom) {
    const auto pages = lay_out_steps(example("four_bar"), slides(), fonts());
    EXPECT_TRUE(says(pages, "0.004 m/s"));
    double widest = 0;
    for (const Page& page : pages)
        for (const Mark& mark : page.marks)
            if (const auto* axis = std::get_if<Axis>(&mark)) widest = std::max(widest, length(axis->tip - axis->tail));
    EXPECT_GT(widest, 0.55 * 203.2);
}

TEST(Scale, HasAFinerSeriesBetweenTwoScales) {
    EXPECT_EQ(scales_between(0.0021, 0.005), (std::vector<double>{0.0025, 0.003, 0.004}));
    EXPECT_EQ(scales_between(0.7, 1), std::vector<double>{0.8});
    EXPECT_EQ(scales_between(8, 20), (std::vector<double>{8, 10, 12.5, 15}));
    EXPECT_TRUE(scales_between(1, 1).empty());
}

TEST(Beamer, HasAFrameForEachFigureAndAnOverlayForEachStep) {
    const auto pages = lay_out_steps(example("four_bar"), slides(), fonts());
    const std::string text = to_beamer(pages, fonts());
    std::size_t figures = 1;
    for (std::size_t i = 1; i < pages.size(); ++i) figures += pages[i].step->figure != pages[i - 1].step->figure;
    const auto count = [&](const std::string& piece) {
        std::size_t found = 0;
        for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++found;
        return found;
    };
    EXPECT_LT(figures, pages.size());
    EXPECT_EQ(count("\\begin{frame}"), figures);
    EXPECT_EQ(count("\\end{frame}"), figures);
    EXPECT_EQ(count("\\begin{tikzpicture}[kg]"), figures);
    EXPECT_EQ(count("\n\\kgsays{"), pages.size());
    // The sentence is TeX's: not a line of it is in the picture too.
    EXPECT_EQ(count("Through the known ends"), 1U);
    EXPECT_EQ(text, to_beamer(pages, fonts()));
}

TEST(OfficeText, IsInAFontThatWordProcessorsHave) {
    const std::vector<Page> pages = laid_out("four_bar");
    const std::string live = to_live_svg(pages, fonts()).front(), office = to_office_svg(pages, fonts()).front();
    EXPECT_NE(office.find("font-family=\"Times New Roman, "), std::string::npos);
    EXPECT_EQ(office.find("@font-face"), std::string::npos);
    // All else is as in live text.
    EXPECT_EQ(office.substr(office.find("<rect class=\"paper\"")), live.substr(live.find("<rect class=\"paper\"")));
}

class SlidesFiles : public tests::CommandLine {};

TEST_F(SlidesFiles, AreWrittenByTheProgram) {
    EXPECT_EQ(run("solve four_bar.json --steps --slides -o a.pdf -o a.png --dpi 160").status, 0);
    EXPECT_TRUE(is_there("a-3.png"));
    EXPECT_EQ(tests::contents(folder_ / "a.png").substr(16, 8), std::string("\0\0\5\0\0\0\2\xD0", 8)) << "1280 × 720";
    EXPECT_EQ(run("solve four_bar.json --steps --beamer -o b.tex").status, 0);
    EXPECT_NE(tests::contents(folder_ / "b.tex").find("{beamer}"), std::string::npos);
    write("lines",
          "{\"file\": \"four_bar.json\", \"steps\": true, \"slides\": true, \"want\": [\"svg\"], \"to\": \"c\"}\n");
    EXPECT_EQ(run("batch <lines").status, 0);
    EXPECT_NE(tests::contents(folder_ / "c.svg").find("viewBox=\"0 0 203.2 114.3\""), std::string::npos);
}

TEST_F(SlidesFiles, WhatMakesNoSenseIsRefused) {
    const auto before = snapshot();
    const auto refused = [&](const std::string& options, const std::string& message) {
        const tests::Outcome done = run("solve four_bar.json " + options);
        EXPECT_EQ(done.status, 2) << options;
        EXPECT_NE(done.err.find(message), std::string::npos) << done.err;
    };
    refused("--slides -o a.pdf", "--slides shows the solution step by step: add --steps");
    refused("--beamer -o a.tex", "--beamer shows the solution step by step: add --steps");
    refused("--steps --slides --paper A3 -o a.pdf", "--paper");
    refused("--figure velocity -o a.mp4", "-o a.mp4 and --figure exclude each other");
    refused("--sheet question -o a.mp4", "-o a.mp4 and --sheet exclude each other");
    EXPECT_EQ(changed_since(before), "");
    EXPECT_NE(run("solve four_bar.json --steps --beamer -o a.pdf").err.find("no .tex is asked for"), std::string::npos);
    EXPECT_NE(run("solve four_bar.json --captions burnt -o a.pdf").err.find("no film is asked for"), std::string::npos);
}

}  // namespace
}  // namespace slides_test
