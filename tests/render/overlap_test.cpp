// Nothing on a sheet covers anything: counted over all examples, languages, papers and orientations, from the display
// lists of finished pages and in their pixels. The theme changes from one paper to the next; KINEGRAPH_ALL_PAPERS=1
// takes all three.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>
#include <tuple>

#include "render/sheet/sheet.hpp"
#include "tests/support/files.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/laid_out.hpp"
#include "tests/support/page_checker.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::render::overlap_test {
namespace {

using tests::fonts;
using tests::laid_out;
using tests::Look;

class OverlapOnPaper : public testing::TestWithParam<std::tuple<Language, Paper, Orientation>> {};

TEST_P(OverlapOnPaper, OfAllExamplesIsNone) {
    Look look{std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam())};
    // From one paper to the next the theme changes, so that over the papers each example is seen in all of them; on A4
    // it is the usual one, in which other suites look at the same pages.
    const std::size_t first_theme = static_cast<std::size_t>(look.paper) + static_cast<std::size_t>(look.orientation);
    const bool is_shared = look.paper == Paper::a4 && look.orientation == Orientation::landscape;
    const std::size_t themes = std::getenv("KINEGRAPH_ALL_PAPERS") != nullptr ? theme_names().size() : 1;
    std::map<Fault::Kind, int> counts;
    std::size_t pixels = 0;
    std::string first;
    const auto look_at = [&](const std::string& name) {
        SCOPED_TRACE(name);
        const std::vector<Page> own =
            is_shared ? std::vector<Page>{} : lay_out(tests::example(name), tests::options_of(look), fonts());
        const std::vector<Page>& pages = is_shared ? laid_out(name, look) : own;
        pages::expect_clean(pages);
        for (const Page& page : pages) {
            EXPECT_EQ(page.height > page.width, look.orientation == Orientation::portrait);
            for (const Fault& fault : faults_of(page, fonts())) {
                ++counts[fault.kind];
                if (first.size() < 2000) first += name + ", " + said(fault) + "\n";
            }
            const std::size_t common = pixels_in_common(page, fonts(), 100);
            if (common > 0) first += name + ", " + std::to_string(common) + " pixels in common\n";
            pixels += common;
        }
    };
    // Under sanitizers each example is seen on a sixth of the papers and languages.
    constexpr std::size_t one_in = unless_sanitized(1, 6);
    std::size_t turn = first_theme + static_cast<std::size_t>(look.language);
    for (const std::string& name : tests::example_names()) {
        ++turn;
        if (turn % one_in != 0) continue;
        for (std::size_t more = 0; more < themes; ++more) {
            look.theme = theme_names()[(first_theme + more) % theme_names().size()];
            look_at(name);
        }
    }
    EXPECT_EQ(counts, (std::map<Fault::Kind, int>{})) << first;
    EXPECT_EQ(pixels, 0U) << first;
}

// Two entries for ctest to run side by side.
INSTANTIATE_TEST_SUITE_P(Lying, OverlapOnPaper,
                         testing::Combine(testing::Values(Language::en, Language::it),
                                          testing::Values(Paper::a4, Paper::a3, Paper::letter),
                                          testing::Values(Orientation::landscape)));
INSTANTIATE_TEST_SUITE_P(Upright, OverlapOnPaper,
                         testing::Combine(testing::Values(Language::en, Language::it),
                                          testing::Values(Paper::a4, Paper::a3, Paper::letter),
                                          testing::Values(Orientation::portrait)));

}  // namespace
}  // namespace kinegraph::render::overlap_test
