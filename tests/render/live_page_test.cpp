// The live page as the program writes it. What it does in a browser: tests/live.
#include "render/live/live_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "constructions/moving/moving.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/files.hpp"

namespace kinegraph::tests::live_page_test {
namespace {

TEST(Sha256, OfKnownTexts) {
    EXPECT_EQ(render::sha256_base64(""), "47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
    EXPECT_EQ(render::sha256_base64("abc"), "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
    EXPECT_EQ(render::sha256_base64("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "JI1qYdIGOLjlwCaTDD5gOaM85Flk/yFn9uzt1BnbBsE=");
}

TEST(Moving, APlanForEveryStretchAndNoneTwice) {
    auto mechanism = read_mechanism(contents(std::filesystem::path(KINEGRAPH_EXAMPLES_DIR) / "slider_crank.json"),
                                    "slider_crank.json");
    ASSERT_TRUE(mechanism.has_value());
    const auto solution = solve(*std::move(mechanism));
    ASSERT_TRUE(solution.has_value());
    const auto moving = moving_of(*solution);
    ASSERT_TRUE(moving.has_value());
    ASSERT_EQ(moving->courses.size(), 1U);
    const MovingCourse& course = moving->courses.front();
    EXPECT_GE(course.samples.size(), 73U);
    for (const MovingCourse::Sample& sample : course.samples) {
        EXPECT_TRUE(sample.plan >= 0 || !sample.values.empty()) << sample.at;
        EXPECT_LT(sample.plan, static_cast<int>(moving->plans.size()));
    }
    // Every plan reads the same columns and is its own stretch's.
    for (std::size_t i = 0; i < moving->plans.size(); ++i) {
        EXPECT_EQ(moving->plans[i].sources.size(), moving->columns.size());
        const auto serves = [&](const MovingCourse::Sample& sample) { return sample.plan == static_cast<int>(i); };
        EXPECT_TRUE(std::any_of(course.samples.begin(), course.samples.end(), serves)) << i;
    }
}

/// Of an example, with what may be changed in it.
Moving moving_example(const std::string& name) {
    const std::string text = contents(std::filesystem::path(KINEGRAPH_EXAMPLES_DIR) / name);
    auto mechanism = read_mechanism(text, name);
    EXPECT_TRUE(mechanism.has_value());
    const auto solution = solve(*std::move(mechanism));
    EXPECT_TRUE(solution.has_value());
    auto moving = moving_of(*solution, rereading_of(text, name, {}));
    EXPECT_TRUE(moving.has_value());
    return *std::move(moving);
}
std::vector<std::pair<std::string, double>> names_and_values(const Moving& moving) {
    std::vector<std::pair<std::string, double>> all;
    for (const MovingSetting& each : moving.settings) all.emplace_back(each.name, each.value);
    return all;
}

TEST(Moving, LengthsOfBarsAndOfTheFrameMayBeChanged) {
    const Moving moving = moving_example("four_bar.json");
    const std::vector<std::pair<std::string, double>> expected{
        {"ω 2", -4 * std::acos(-1.0)}, {"O2A", 0.04}, {"AB", 0.15}, {"BO4", 0.08}, {"O2O4", 0.15}};
    const auto found = names_and_values(moving);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].first, expected[i].first);
        EXPECT_NEAR(found[i].second, expected[i].second, 1e-14);
    }
    EXPECT_TRUE(moving.effects.empty());
    // A rod with its mass centre beside its line is no bar; nor is what a slide holds.
    for (const auto& [name, value] : names_and_values(moving_example("exam_2001.json"))) EXPECT_NE(name, "AC");
}

TEST(Moving, ParametersWhoseNumbersAreMadeComparableAreInPlaceOfTheLengths) {
    const Moving moving = moving_example("variants/slider_crank.json");
    const std::vector<std::pair<std::string, double>> expected{
        {"ω 2", 10}, {"r", 50}, {"l", 160}, {"e", 10}, {"w", 10}};
    EXPECT_EQ(names_and_values(moving), expected);  // not phi: that is where the crank is drawn
    // e moves the guide across, and nothing else; w is the rate.
    std::size_t of_e = 0, of_w = 0;
    for (const MovingEffect& effect : moving.effects) {
        for (const MovingEffect::Term& term : effect.terms) {
            EXPECT_EQ(term.second, -1);
            of_e += term.first == 2 * 3 ? 1 : 0;
            of_w += term.first == 2 * 4 ? 1 : 0;
            if (term.first == 2 * 3) {
                EXPECT_EQ(effect.list, MovingEffect::List::row);
                EXPECT_NEAR(std::abs(term.by) * moving.unit, 1e-3, 1e-15);  // m a mm
            }
            if (term.first == 2 * 4) {
                EXPECT_EQ(effect.list, MovingEffect::List::setting);
                EXPECT_EQ(term.by, 1);
            }
        }
    }
    EXPECT_EQ(of_e, 1U);
    EXPECT_EQ(of_w, 1U);
}

TEST(Moving, WhatCannotBeChangedIsToldWithTheReason) {
    const Moving moving = moving_example("variants/slider_crank.json");
    ASSERT_EQ(moving.fixed.size(), 1U);
    EXPECT_EQ(moving.fixed[0].name, "phi");
    EXPECT_EQ(moving.fixed[0].why, Moving::Fixed::Why::nothing);
}

TEST(Moving, ForcesAndPlacesOfAPlanHaveNamesThatComeOnce) {
    for (const char* const name : {"exam_2001.json", "engine_inertia_gas.json", "coupler_curve.json"}) {
        const Moving moving = moving_example(name);
        ASSERT_FALSE(moving.plans.empty()) << name;
        for (const MovingPlan& plan : moving.plans) {
            EXPECT_FALSE(plan.held.empty()) << name;
            std::set<std::string> names;
            for (const MovingPlan::Binding& held : plan.held) {
                EXPECT_TRUE(names.insert(held.name).second || held.name[0] == 'M')
                    << held.name;  // a point of concurrency is of several bodies
                for (const ElementIndex element : {held.place, held.vector, held.couple}) {
                    if (element != none) {
                        EXPECT_LT(at_index(element), plan.program.strokes.size()) << held.name;
                    }
                }
            }
        }
    }
}

TEST(Moving, NothingMovesWithoutDriver) {
    auto mechanism = read_mechanism(contents(std::filesystem::path(KINEGRAPH_EXAMPLES_DIR) / "beam.json"), "beam.json");
    ASSERT_TRUE(mechanism.has_value());
    const auto solution = solve(*std::move(mechanism));
    ASSERT_TRUE(solution.has_value());
    EXPECT_FALSE(moving_of(*solution).has_value());
}

using LivePage = CommandLine;

TEST_F(LivePage, StandsBesideOtherOutputsAndIsTheSameEveryTime) {
    ASSERT_EQ(run("solve four_bar.json -o a.html -o a.json").status, 0);
    ASSERT_EQ(run("solve four_bar.json -o b.html").status, 0);
    const std::string page = contents(folder_ / "a.html");
    EXPECT_EQ(page, contents(folder_ / "b.html"));
    EXPECT_TRUE(fs::exists(folder_ / "a.json"));
    EXPECT_LE(page.size(), 330000U);
    EXPECT_EQ(page.find("http:"), std::string::npos);
    EXPECT_EQ(page.find("https:"), std::string::npos);
    EXPECT_EQ(page.find("eval("), std::string::npos);
}

TEST_F(LivePage, MarksOfForcesNameWhatThePlansKnow) {
    write("exam_2001.json", contents(fs::path(KINEGRAPH_EXAMPLES_DIR) / "exam_2001.json"));
    ASSERT_EQ(run("solve exam_2001.json --with joukowsky -o a.html -o a.svg").status, 0);
    int drawn = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) {
        if (entry.path().extension() == ".svg") {
            ++drawn;
            EXPECT_EQ(contents(entry.path()).find("data-on"), std::string::npos) << entry.path();
        }
    }
    EXPECT_GT(drawn, 0);
    const std::string page = contents(folder_ / "a.html");
    const std::regex mark("data-on=\"\\[([^\"]*)\\]\""), quoted("&quot;([^&]*)&quot;");
    std::size_t known = 0;
    for (std::sregex_iterator each(page.begin(), page.end(), mark), end; each != end; ++each) {
        const std::string names = (*each)[1];
        std::sregex_iterator name(names.begin(), names.end(), quoted);
        for (++name; name != end; ++name) {  // past the form
            const std::string said = (*name)[1];
            if (said.empty() || said == "o" || said[0] == 'p') continue;
            EXPECT_NE(page.find("[\"" + (said[0] == '/' ? said.substr(1) : said) + "\","), std::string::npos) << said;
            ++known;
        }
    }
    EXPECT_GT(known, 100U);
}

TEST_F(LivePage, WhatHasNoMeaningForItIsRefused) {
    for (const char* const other : {"--figure velocity", "--steps", "--sheet question"}) {
        const Outcome said = run(std::string("solve four_bar.json -o a.html ") + other);
        EXPECT_EQ(said.status, 2) << other;
        EXPECT_NE(said.err.find("live page"), std::string::npos) << said.err;
        EXPECT_FALSE(fs::exists(folder_ / "a.html"));
    }
}

}  // namespace
}  // namespace kinegraph::tests::live_page_test
