// Nothing on a sheet covers anything: counted from the display lists of finished pages over all examples, languages and papers.
#include <gtest/gtest.h>

#include <map>

#include "constructions/solve.hpp"
#include "render/sheet.hpp"
#include "tests/files.hpp"
#include "tests/fonts.hpp"
#include "tests/page_checker.hpp"

namespace kinegraph::render {
namespace {

using tests::fonts;

using Counts = std::map<Fault::Kind, int>;

/// Adds the faults of all pages of a sheet; the first few in words.
void count(const std::string& text, const std::string& name, Language language, Paper paper, Counts& counts, std::string& first) {
    auto mechanism = read_mechanism(text, name);
    ASSERT_TRUE(mechanism.has_value()) << name;
    const auto solution = solve(std::move(*mechanism));
    ASSERT_TRUE(solution.has_value()) << name;
    SheetOptions options;
    options.language = language;
    options.paper = paper;
    for (const Page& page : lay_out(*solution, options, fonts()))
        for (const Fault& fault : faults_of(page, fonts())) {
            ++counts[fault.kind];
            if (first.size() < 2000) first += name + ", " + said(fault) + "\n";
        }
}

class OverlapOnPaper : public testing::TestWithParam<std::tuple<Language, Paper>> {};

TEST_P(OverlapOnPaper, OfAllExamplesIsNone) {
    Counts counts;
    std::string first;
    for (const std::string& name : tests::example_names())
        count(tests::contents(tests::example_file(name)), name, std::get<0>(GetParam()), std::get<1>(GetParam()), counts, first);
    EXPECT_EQ(counts, Counts{}) << first;
}

INSTANTIATE_TEST_SUITE_P(Sheets, OverlapOnPaper,
                         testing::Combine(testing::Values(Language::en, Language::it),
                                          testing::Values(Paper::a4, Paper::a3, Paper::letter)));

}  // namespace
}  // namespace kinegraph::render
