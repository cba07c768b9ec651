// The sheets of contact, wear and impact: clean pages in two languages on every paper, steps, figures alone, results;
// what other commands say of such files.
#include "engine/file/units.hpp"  // before signal.h, which makes a macro of si_value

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/results/results.hpp"
#include "engine/solution/problem_solution.hpp"
#include "render/backends/backends.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/sheet/steps.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/pages.hpp"
#include "tests/support/through_all.hpp"

namespace kinegraph::problem_sheet_test {
namespace {

using namespace pages;

std::vector<std::string> problem_names() {
    std::vector<std::string> names;
    for (const char* folder : {"contact", "motion", "rotor"})
        for (const std::string& name : tests::example_names(folder)) names.push_back(std::string(folder) + "/" + name);
    return names;
}

class ProblemSheets : public testing::TestWithParam<std::string> {};

TEST_P(ProblemSheets, AreCleanInBothLanguages) {
    const Solution& solution = example(GetParam());
    for (const Language language : {Language::en, Language::it}) {
        SheetOptions options;
        options.language = language;
        options.orientation = language == Language::en ? Orientation::landscape : Orientation::portrait;
        const std::vector<Page> sheets = lay_out(solution, options, fonts());
        EXPECT_LE(sheets.size(), GetParam().starts_with("motion/") ? 4u : 2u);
        expect_clean(sheets);
        for (const Page& page : sheets) expect_sound_groups(page);
        EXPECT_TRUE(
            says(sheets, language == Language::en ? "Results and numeric check" : "Risultati e verifica numerica"));
    }
}

TEST_P(ProblemSheets, HaveStepsAndFiguresOfTheirOwn) {
    const Solution& solution = example(GetParam());
    const std::vector<Page> steps = lay_out_steps(solution, {}, fonts());
    EXPECT_GE(steps.size(), 5u);
    expect_clean(steps);
    for (const std::string& name : figure_names(solution, {}, fonts()))
        EXPECT_TRUE(lay_out_alone(solution, {}, name, fonts())) << name;
    EXPECT_FALSE(lay_out_alone(solution, {}, "mechanism", fonts()));
}

TEST_P(ProblemSheets, HaveResultsThatAgreeWithTheChecks) {
    const Solution& solution = example(GetParam());
    const auto results =
        nlohmann::json::parse(results_json(solution, false, [](const Message&) { return std::string(); }));
    EXPECT_EQ(results.size(), solution.problem->remarks.empty() ? 3u : 4u);
    const auto& checks = results.at("checks");
    EXPECT_EQ(checks.size(), solution.problem->values.size());
    for (const auto& row : checks)
        EXPECT_NEAR(row.at("graphical"), row.at("numeric"), 1e-5 + 1e-5 * std::abs(row.at("graphical").get<double>()));
    for (const Language language : {Language::en, Language::it})
        for (const ProblemValue& each : solution.problem->values)
            EXPECT_NE(results_table(solution, language).find(in(each.name, language)), std::string::npos);
}

TEST_P(ProblemSheets, ComeThroughAll) {
    const tests::HowFar far = tests::through_all(tests::contents(tests::example_file(GetParam())), fonts());
    EXPECT_TRUE(far.drawn);
}

std::string name_of_file(const testing::TestParamInfo<std::string>& info) {
    return info.param.substr(info.param.find('/') + 1);
}
INSTANTIATE_TEST_SUITE_P(Examples, ProblemSheets, testing::ValuesIn(problem_names()), name_of_file);

class ProblemCommands : public tests::CommandLine {};

TEST_F(ProblemCommands, SolveAndCheckAloneTakeThem) {
    std::filesystem::copy(tests::example_file("contact/pad"), folder_ / "pad.json");
    EXPECT_EQ(run("check pad.json").status, 0);
    EXPECT_EQ(run("solve pad.json -o pad.svg").status, 0);
    for (const char* command : {"sweep pad.json", "pairs pad.json", "solve pad.json --at 30°"}) {
        const tests::Outcome refused = run(command);
        EXPECT_EQ(refused.status, 2) << command;
        EXPECT_NE(refused.err.find("this file has no joints"), std::string::npos) << refused.err;
    }
}

}  // namespace
}  // namespace kinegraph::problem_sheet_test
