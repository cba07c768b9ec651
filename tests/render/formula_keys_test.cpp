// What is handed out of problems, of closure equations and of virtual work: keys with their values, results that a file
// may ask for, laws that a platform is told; and the derivatives of a point's motion on the command line.
#include <gtest/gtest.h>

#include "constructions/positions/named_results.hpp"
#include "engine/solution/problem_solution.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/pages.hpp"

namespace kinegraph::render::formula_keys_test {
namespace {

using tests::solved;

/// An example's text with more members.
std::string with(const std::string& example, const std::string& members) {
    std::string text = tests::contents(tests::example_file(example));
    return text.replace(text.find("\"kinegraph\": 1"), 14, "\"kinegraph\": 1, " + members);
}
std::vector<Page> sheet(const Solution& solution, SheetKind kind, Language language = Language::en) {
    SheetOptions options;
    options.kind = kind;
    options.language = language;
    std::vector<Page> pages = lay_out(solution, options, tests::fonts());
    pages::expect_clean(pages);
    for (const Page& page : pages) pages::expect_sound_groups(page);
    return pages;
}

TEST(KeyOfProblem, HasTheValuesThatTheQuestionKeepsBack) {
    const Solution& projectile = tests::example("motion/projectile");
    EXPECT_TRUE(pages::says(sheet(projectile, SheetKind::answers), "19.940 m"));
    EXPECT_FALSE(pages::says(sheet(projectile, SheetKind::question), "19.940 m"));
    EXPECT_TRUE(pages::says(sheet(projectile, SheetKind::question, Language::it), "raggio di curvatura"));
    const Solution& positions = tests::example("motion/three_positions");
    const std::vector<Page> key = sheet(positions, SheetKind::answers, Language::it);
    EXPECT_TRUE(pages::says(key, "43,006 mm"));
    EXPECT_TRUE(pages::says(key, "Soluzioni: solo i risultati"));
    EXPECT_FALSE(pages::says(sheet(positions, SheetKind::question, Language::it), "43,006 mm"));
}

TEST(KeyOfProblem, HasWhatTheFileAsksFor) {
    const Solution asked = solved(with("motion/projectile", R"("ask": ["speed"])"));
    const std::vector<Page> key = sheet(asked, SheetKind::answers);
    EXPECT_TRUE(pages::says(key, "12.506 m/s"));
    EXPECT_FALSE(pages::says(key, "19.940 m"));
}

TEST(KeyOfEquations, HasRatiosWhereTheyAreSought) {
    std::string text = tests::contents(tests::example_file("four_bar"));
    const std::string find = R"("find": ["instant centres", "velocity", "acceleration"])";
    text.replace(text.find(find), find.size(), R"("find": ["velocity", "equations"])");
    const std::vector<Page> key = sheet(solved(text), SheetKind::answers);
    EXPECT_TRUE(pages::says(key, "Velocity ratios"));
    EXPECT_TRUE(pages::says(key, "0.38074"));
    EXPECT_TRUE(pages::says(key, "Dead points"));
    EXPECT_FALSE(pages::says(sheet(tests::example("four_bar"), SheetKind::answers), "Velocity ratios"));
}

/// The same effort by the reactions, under the same name.
TEST(EffortOfVirtualWork, MayBeAskedFor) {
    const std::string asking = with("virtual_work", R"("ask": ["effort F_G"])");
    std::string by_forces = asking;
    by_forces.replace(by_forces.find("\"virtual work\"]"), 15, "\"forces\"]");
    const auto asked = asked_results(solved(asking));
    ASSERT_TRUE(asked);
    ASSERT_EQ(asked->size(), 1U);
    EXPECT_EQ(asked->front().column.name, "effort F_G");
    const auto beside = asked_results(solved(by_forces));
    ASSERT_TRUE(beside);
    EXPECT_NEAR(asked->front().value / beside->front().value, 1, 1e-9);
    EXPECT_TRUE(pages::says(sheet(solved(asking), SheetKind::answers), "−20.64"));
    EXPECT_TRUE(pages::says(sheet(tests::example("virtual_work"), SheetKind::answers, Language::it), "−20,64"));
}

/// Where reactions find the effort too it stands once.
TEST(EffortOfVirtualWork, StandsOnceBesideThatOfTheReactions) {
    std::string both = tests::contents(tests::example_file("virtual_work"));
    both.replace(both.find("\"virtual work\"]"), 15, "\"forces\", \"virtual work\"]");
    int count = 0;
    for (const NamedResult& each : named_results(solved(both))) count += each.column.name == "effort F_G" ? 1 : 0;
    EXPECT_EQ(count, 1);
}

class MotionOnTheCommandLine : public tests::CommandLine {
protected:
    std::string at(const std::string& name) const { return "'" + tests::example_file("motion/" + name).string() + "'"; }
};

TEST_F(MotionOnTheCommandLine, PrintsDerivativesAsTextLatexAndJson) {
    const tests::Outcome text = run("equations " + at("parabola"));
    EXPECT_EQ(text.status, 0) << text.err;
    for (const char* line :
         {"Derivatives\n", "s\u0307 = v_0 + a_0 t = 2.0000 m/s\n", "y′ = x/p = 1.2348\n", "a_0 = 0.5 m/s²."})
        EXPECT_NE(text.out.find(line), std::string::npos) << line << text.out;
    const tests::Outcome latex = run("equations " + at("parabola") + " --format latex --lang it");
    EXPECT_NE(latex.out.find("y'  = \\frac{x }{p } = 1{,}2348"), std::string::npos) << latex.out;
    const std::string json = run("equations " + at("harmonic") + " --format json").out;
    const std::string results = run("solve " + at("harmonic") + " --format json -o -").out;
    EXPECT_EQ(json.rfind("{\n  \"motion\": {", 0), 0U) << json;
    EXPECT_EQ(results.rfind(json.substr(0, json.size() - std::string("\n}\n").size()), 0), 0U) << json << results;
    const tests::Outcome positions = run("equations " + at("displacement"));
    EXPECT_EQ(positions.status, 2);
    EXPECT_EQ(positions.out, "");
    EXPECT_EQ(std::count(positions.err.begin(), positions.err.end(), '\n'), 1) << positions.err;
}

TEST_F(MotionOnTheCommandLine, TellsAPlatformTheLaws) {
    std::string text =
        with("motion/projectile",
             R"("parameters": {"u": "20 m/s"}, "vary": {"u": {"choose": ["18 m/s"]}}, "ask": ["speed"])");
    const std::string given = "\"20 m/s\"", by = "\"= u\"";
    text.replace(text.rfind(given), given.size(), by);
    write("p.json", text);
    const tests::Outcome made = run("variants p.json --count 1 --for moodle -o OUT/");
    ASSERT_EQ(made.status, 0) << made.err;
    const std::string quiz = tests::contents(folder_ / "OUT/moodle.xml");
    const std::size_t question = quiz.find("x = v_0 cos (α) t"), solution = quiz.find("<generalfeedback");
    EXPECT_LT(question, solution);
    EXPECT_NE(quiz.find("v_0 sin (α) − g t", solution), std::string::npos);
}

}  // namespace
}  // namespace kinegraph::render::formula_keys_test
