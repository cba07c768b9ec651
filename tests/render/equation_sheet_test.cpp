// Closure equations as they are printed: formulas as text and LaTeX, set within their measure, on sheets with nothing
// cut or covered; and the program that prints them.
#include <gtest/gtest.h>

#include "render/equations/equation_text.hpp"
#include "render/page/set_formula.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/command_line.hpp"
#include "tests/support/pages.hpp"

namespace kinegraph::render::equation_sheet_test {
namespace {

Solution with_equations(const std::string& name) {
    auto mechanism = read_mechanism(tests::contents(tests::example_file(name)), name + ".json");
    mechanism->find.equations = true;
    return *solve(*std::move(mechanism));
}

Formula sample() {
    Formula sum = Formula::letter("b", "1") + Formula::sign("+") +
                  Formula::root(Formula::power(Formula::letter("lambda"), Formula::upright("2")));
    return Formula::fraction(std::move(sum), Formula::upright("2") + Formula::letter("alpha", "", 1)) +
           Formula::sign("=") +
           Formula::matrix(
               {Formula::upright("1"), Formula::upright("−0,5 mm"), Formula::letter("c"), Formula::upright("0")}, 2);
}

TEST(FormulaOfText, PrintsPlainAndAsLatex) {
    EXPECT_EQ(sample().plain(), "(b_1 + √(λ^2))/(2 α\u0307) = [1, −0,5 mm; c, 0]");
    EXPECT_EQ(sample().latex(),
              "\\frac{b_{\\text{1}}  + \\sqrt{{\\lambda }^{2}}}{2\\dot{\\alpha} } = "
              "\\left[\\begin{array}{cc}1 & -0{,}5\\text{ mm} \\\\ c  & 0\\end{array}\\right]");
}

TEST(FormulaOfText, TakesAnyNameIntoLatex) {
    const std::string text = Formula::letter("a_b", "x&y{%").latex() + Formula::upright("10⁻¹² m²").latex();
    EXPECT_EQ(text, "\\textit{a\\_b}_{\\text{x\\&y\\{\\%}} 10^{-12}\\text{ m}^{2}");
}

TEST(FormulaOfText, StandsWithinItsMeasure) {
    Formula sum;
    for (int i = 0; i < 30; ++i) {
        if (i > 0) sum += Formula::sign("+");
        sum += Formula::letter("a", std::to_string(i)) + Formula::function("cos") + Formula::letter("beta");
    }
    const Block broken = formula_block(sum, tests::fonts(), 10, 60, {});
    EXPECT_LE(broken.width, 60 + 1e-9);
    EXPECT_GT(broken.height, 20);  // several lines
    for (const double measure : {200.0, 40.0, 15.0}) {
        const Block block = formula_block(sample(), tests::fonts(), 10, measure, {});
        EXPECT_LE(block.width, measure + 1e-9);
        const Box ink = box_of(block.marks);
        EXPECT_GE(ink.min.x, -0.3);
        EXPECT_GE(ink.min.y, -0.3);
        EXPECT_LE(ink.max.x, block.width + 0.3);
        EXPECT_LE(ink.max.y, block.height + 0.3);
    }
}

class EquationSheet : public testing::TestWithParam<const char*> {};

TEST_P(EquationSheet, HasNothingCutOrCovered) {
    const Solution solution = with_equations(GetParam());
    const bool italian = std::string_view(GetParam()).size() % 2 == 0;
    SheetOptions options;
    options.language = italian ? Language::it : Language::en;
    const std::vector<Page> pages = lay_out(solution, options, tests::fonts());
    pages::expect_clean(pages);
    for (const Page& page : pages) pages::expect_sound_groups(page);
    EXPECT_TRUE(pages::says(pages, italian ? "Equazioni di chiusura" : "Closure equations"));
}
INSTANTIATE_TEST_SUITE_P(Examples, EquationSheet,
                         testing::Values("four_bar", "slider_crank", "exam_2001", "watt_six_bar", "planetary_train",
                                         "cam_roller_follower", "scara", "double_butterfly", "beam"),
                         [](const auto& each) { return std::string(each.param); });

TEST(EquationText, CallsASineAsItsLanguageDoes) {
    const Solution solution = with_equations("slider_crank");
    for (const Language language : languages) {
        const std::vector<EquationItem> items = equation_items(solution, language);
        const bool spanish = language == Language::es;
        EXPECT_NE(as_text(items).find(spanish ? "sen β" : "sin β"), std::string::npos);
        EXPECT_EQ(as_text(items).find(spanish ? "sin β" : "sen β"), std::string::npos);
        EXPECT_NE(as_latex(items).find(spanish ? "\\operatorname{sen} \\beta" : "\\sin \\beta"), std::string::npos);
    }
}

/// Every known term is on the side, and has the sign, that the drawn position asks for.
TEST(EquationText, ProjectsWithTheRightSigns) {
    const auto text = [](const char* name) { return as_text(equation_items(with_equations(name), Language::en)); };
    const auto has = [](const std::string& all, const char* line) {
        EXPECT_NE(all.find(std::string("  ") + line + "\n"), std::string::npos) << line << "\n" << all;
    };
    has(text("slider_crank"), "sin β = − λ sin α");
    has(text("slider_crank"), "Λ_c = dc/dα = − a (sin α − cos α tan β) = −50.839 mm/rad");
    has(text("slider_crank_offset"), "sin β = − λ sin α − d/b");
    has(text("slider_crank_offset"), "c = a cos α + b cos β = 160.99 mm");
    has(text("cam_roller_follower"), "cos β = − λ cos α");
    has(text("cam_roller_follower"), "c = a sin α + b sin β = 65.679 mm");
    has(text("planetary_train"), "R_2 (α̇ − γ̇) + R_3 (β̇ − γ̇) = 0");
    // Of two drivers partial derivatives, the mixed ones too (by differences of the loop's solution).
    has(text("five_bar"), "Λ_β,δ = ∂β/∂δ = 0.65655");
    has(text("five_bar"), "Λ′_β,α,δ = ∂^2β/∂α ∂δ = 0.3004");
    EXPECT_EQ(text("slider_driven_dead_point").find("Velocity ratios"), std::string::npos) << "nothing under a heading";
}

/// ω and α of the SCARA's forearm relative to the arm: the groups add up to what the polygons say.
TEST(EquationText, PartsTheScarasAcceleration) {
    const std::string text = as_text(equation_items(with_equations("scara"), Language::it));
    for (const char* const line :
         {"z_B = a e^{i α} + b e^{i (α + β)}", "v_rel = i b β̇ e^{i (α + β)}", "a_cor = − 2 b α̇ β̇ e^{i (α + β)}"})
        EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
}

class EquationsCommand : public tests::CommandLine {};

TEST_F(EquationsCommand, PrintsTextLatexAndJson) {
    const tests::Outcome text = run("equations four_bar.json --lang it");
    EXPECT_EQ(text.status, 0);
    EXPECT_EQ(text.out.rfind("Equazioni di chiusura\n", 0), 0U) << text.out;
    EXPECT_EQ(run("equations four_bar.json --format latex").out.rfind("\\documentclass", 0), 0U);
    EXPECT_NE(run("equations four_bar.json --format json").out.find("\"unknowns\": [\"theta 3\", \"theta 4\"]"),
              std::string::npos);
    const tests::Outcome dead = run("equations slider_driven_dead_point.json");
    EXPECT_EQ(dead.status, 0);
    EXPECT_NE(dead.out.find("cannot be driven"), std::string::npos) << dead.out;
}

TEST_F(EquationsCommand, IsRefusedWithThePlace) {
    write("open.json", spoilt("{\"revolute\": \"B\",  \"bodies\": [3, 4]}",
                              "{\"rolling\": \"B\", \"bodies\": [3, 4], \"tangent\": 30}"));
    const tests::Outcome open = run("equations open.json");
    EXPECT_EQ(open.status, 2);
    EXPECT_NE(open.err.find("joint B: without the \"profiles\""), std::string::npos) << open.err;
    EXPECT_EQ(open.out, "");
    EXPECT_EQ(run("solve four_bar.json --with equations --sheet question -o q.svg").status, 2);
    EXPECT_EQ(run("equations four_bar.json --format tex").status, 2);
}

/// Asked for or not, all else of the results stays as it is.
TEST_F(EquationsCommand, AddOneKeyToTheResults) {
    const std::string plain = run("solve four_bar.json --format json -o -").out;
    const std::string more = run("solve four_bar.json --format json -o - --with equations").out;
    EXPECT_EQ(plain.find("\"equations\""), std::string::npos);
    const std::size_t at = more.find("  \"equations\": {"), end = more.find("  \"checks\"");
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(more.substr(0, at) + more.substr(end), plain);
}

}  // namespace
}  // namespace kinegraph::render::equation_sheet_test
