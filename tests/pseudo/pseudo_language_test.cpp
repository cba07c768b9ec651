// The sheets of all examples in the pseudo-language of tests/pseudo_language.awk, which this program has in the place
// of Italian: with longer words they stay clean, and what is not of the pseudo-language comes from the file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <variant>

#include "engine/mechanism/exercise.hpp"
#include "engine/results/result_expression.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/laid_out.hpp"
#include "tests/support/page_checker.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::render::pseudo_language_test {
namespace {

using tests::fonts;

/// The words of at least four letters, in lower case; a letter beyond ASCII belongs to its word. Without points in a
/// row: ABCD.
std::set<std::string> words_of(const std::string& text) {
    std::set<std::string> words;
    std::string word;
    bool has_small = false;
    for (const char c : text + " ") {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalpha(byte) != 0 || byte >= 0x80) {
            has_small = has_small || std::isupper(byte) == 0;
            word += static_cast<char>(std::tolower(byte));
            continue;
        }
        if (word.size() >= 4 && has_small) words.insert(word);
        word.clear();
        has_small = false;
    }
    return words;
}
bool is_pseudo(const std::string& word) {
    for (const char c : word)
        if (static_cast<unsigned char>(c) >= 0x80) return true;
    return false;
}

/// A file's name as words: four bar.
std::string spaced(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

/// Names of a format, of the product and of a person; on the terminal the letter ω by its name.
const std::set<std::string>& untranslated() {
    static const std::set<std::string> words{"json", "kinegraph", "coriolis", "omega"};
    return words;
}

/// The words that a file may bring to any sheet: its name and title, and the names of what it has.
std::set<std::string> words_given(const std::string& example) {
    const Mechanism& mechanism = tests::example(example).mechanism;
    std::string text = spaced(example) + " " + in(mechanism.title, Language::it) + " " + mechanism.cam_file;
    const auto add = [&](const auto& all) {
        for (const auto& each : all) text += " " + each.name;
    };
    add(mechanism.points);
    add(mechanism.bodies);
    for (const Body& body : mechanism.bodies) text += " " + in(body.label, Language::it);
    add(mechanism.joints);
    add(mechanism.parameters);
    for (const Load& load : mechanism.loads) std::visit([&](const auto& each) { text += " " + each.name; }, load);
    for (const Effort& effort : mechanism.efforts)
        std::visit([&](const auto& each) { text += " " + each.name; }, effort);
    if (mechanism.exercise)
        for (const std::string& each : mechanism.exercise->expressions)
            text += " " + std::string(named_expression(each).name);
    return words_of(text);
}

/// The pages of the worked solution, of the question and of the answers.
std::vector<std::vector<Page>> sheets_of(const std::string& example) {
    std::vector<std::vector<Page>> all;
    for (const SheetKind kind : {SheetKind::solution, SheetKind::question, SheetKind::answers}) {
        SheetOptions options = tests::options_of({Language::it});
        options.kind = kind;
        all.push_back(lay_out(tests::example(example), options, fonts()));
    }
    return all;
}

class PseudoLanguage : public testing::TestWithParam<std::string> {};

TEST_P(PseudoLanguage, StaysWithinTheFrameClearAndWithoutWordsOfAnother) {
    const std::set<std::string> given = words_given(GetParam());
    const auto expect_pseudo = [&](const std::string& text) {
        for (const std::string& word : words_of(text))
            EXPECT_TRUE(is_pseudo(word) || given.contains(word) || untranslated().contains(word))
                << word << " in \"" << text << '"';
    };
    for (const std::vector<Page>& pages : sheets_of(GetParam())) {
        pages::expect_clean(pages);
        for (const Page& page : pages) {
            for (const Fault& fault : faults_of(page, fonts())) ADD_FAILURE() << said(fault);
            for (const TextMark* text : pages::texts_of(page)) expect_pseudo(text->words);
        }
    }
    const SheetOptions brief = tests::options_of({.language = Language::it, .detail = SolutionDetail::brief});
    for (const Page& page : lay_out(tests::example(GetParam()), brief, fonts()))
        for (const TextMark* text : pages::texts_of(page)) expect_pseudo(text->words);
    expect_pseudo(results_table(tests::example(GetParam()), Language::it));
}

INSTANTIATE_TEST_SUITE_P(Examples, PseudoLanguage, testing::ValuesIn(tests::example_names()),
                         [](const auto& parameter) {
                             std::string name = parameter.param;
                             for (char& c : name)
                                 if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                             return name;
                         });

}  // namespace
}  // namespace kinegraph::render::pseudo_language_test
