// Sheets of virtual work and of relative motions taken apart: figures and tables are there in two languages, nothing
// is cut or covered; what a question says of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <type_traits>

#include "engine/results/quantity_name.hpp"
#include "engine/solution/displacements.hpp"
#include "engine/solution/result_values.hpp"
#include "render/figures/figure.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/pages.hpp"

namespace kinegraph::render::work_sheet_test {
namespace {

using pages::says;

std::vector<Page> sheet_of(const Solution& solution, Language language, SheetKind kind = SheetKind::solution) {
    SheetOptions options;
    options.language = language;
    options.kind = kind;
    return lay_out(solution, options, tests::fonts());
}
std::set<std::string> classes_of(const Figure& figure) {
    std::set<std::string> classes;
    for (const Mark& mark : figure.marks)
        if (const auto* group = std::get_if<GroupBegin>(&mark)) classes.insert(group->cls);
    return classes;
}

TEST(VirtualWorkSheet, HasDisplacementsTableAndEffort) {
    const Solution& solution = tests::example("virtual_work");
    for (const Language language : {Language::en, Language::it}) {
        const std::vector<Page> sheet = sheet_of(solution, language);
        pages::expect_clean(sheet);
        for (const Page& page : sheet) pages::expect_sound_groups(page);
        EXPECT_TRUE(says(sheet, language == Language::en ? "Virtual work" : "Lavori virtuali"));
        EXPECT_TRUE(says(sheet, language == Language::en ? "20.642 MN" : "20,642 MN")) << "F_G";
    }
    const Figure figure = displacement_figure({solution, Theme{}, tests::fonts(), Language::en}, 0, 120, 120);
    const std::set<std::string> classes = classes_of(figure);
    EXPECT_TRUE(classes.contains("displacement") && classes.contains("force"));
    EXPECT_LE(figure.box.width(), 120.01);
}

TEST(VirtualWorkSheet, HasInertiaForcesAsLoads) {
    auto mechanism = read_mechanism(tests::contents(tests::example_file("four_bar_inertia")), "four_bar_inertia.json");
    ASSERT_TRUE(mechanism.has_value());
    mechanism->find.virtual_work = true;
    const Solution solution = *solve(*std::move(mechanism));
    ASSERT_TRUE(solution.displacements && solution.displacements->why_not.empty());
    // A force at each centre and a couple, zero only where the body turns uniformly: the crank.
    std::size_t forces = 0, couples = 0;
    for (const VirtualWork::Entry& entry : solution.displacements->freedoms.at(0).moved->virtual_work->entries)
        if (entry.quantity.kind == Quantity::Kind::load) {
            forces += entry.force.is_zero() ? 0 : 1;
            couples += entry.couple.is_zero() ? 0 : 1;
        }
    EXPECT_EQ(forces, 3U);
    EXPECT_EQ(couples, 2U);
    const std::vector<Page> sheet = sheet_of(solution, Language::en);
    EXPECT_TRUE(says(sheet, "Virtual work"));
    pages::expect_clean(sheet);
}

class ApartSheet : public testing::TestWithParam<const char*> {};

TEST_P(ApartSheet, HasNothingCutOrCovered) {
    const Solution& solution = tests::example(GetParam());
    const bool italian = std::string_view(GetParam()).size() % 2 == 0;
    const std::vector<Page> sheet = sheet_of(solution, italian ? Language::it : Language::en);
    pages::expect_clean(sheet);
    for (const Page& page : sheet) pages::expect_sound_groups(page);
    EXPECT_TRUE(says(sheet, italian ? "Poisson" : "Poisson’s"));
    EXPECT_TRUE(classes_of(moving_axes_figure({solution, Theme{}, tests::fonts(), Language::en},
                                              solution.relative_motion.size() - 1, 100, 100))
                    .contains("axis"));
}
INSTANTIATE_TEST_SUITE_P(Examples, ApartSheet, testing::Values("moving_frame", "slider_on_moving_guide", "scara"),
                         [](const auto& each) { return std::string(each.param); });

TEST(TerminalTable, HasEveryPartOfARelativeMotion) {
    const Solution& solution = tests::example("moving_frame");
    const std::string table = results_table(solution, Language::en);
    std::size_t parts = 0;
    for_each_sought(solution, [&](const Quantity& quantity, const auto& found, const auto& /*of*/) {
        if constexpr (std::is_same_v<std::decay_t<decltype(found)>, Recorded<Vector>>) {
            if (!found || quantity.part == Quantity::Part::whole) return;
            const Unit unit = unit_of(unit_kind_of(quantity, solution.mechanism), solution.mechanism.units);
            const double length = kinegraph::length(*found) / unit.si.to_double();
            EXPECT_NE(table.find(number(length, 6, Language::en)), std::string::npos) << length << unit.symbol;
            ++parts;
        }
    });
    EXPECT_GE(parts, 5U);
}

class TerminalNumbers : public testing::TestWithParam<const char*> {};
/// A component that equilibrium gives alone has four digits, all others have six.
TEST_P(TerminalNumbers, AreAllScalarsFound) {
    const Solution& solution = tests::example(GetParam());
    const std::string table = results_table(solution, Language::en);
    std::size_t scalars = 0;
    for_each_sought(solution, [&](const Quantity& quantity, const auto& found, const auto& /*of*/) {
        if constexpr (std::is_same_v<std::decay_t<decltype(found)>, Recorded<Exact>>) {
            if (!found) return;
            const Unit unit = unit_of(unit_kind_of(quantity, solution.mechanism), solution.mechanism.units);
            const int digits = quantity.kind == Quantity::Kind::force_component ? 4 : 6;
            const std::string text = number((*found / unit.si).to_double(), digits, Language::en);
            EXPECT_NE(table.find(text), std::string::npos) << name_of(quantity, solution) << " = " << text;
            ++scalars;
        }
    });
    EXPECT_GE(scalars, 1U);
}
INSTANTIATE_TEST_SUITE_P(Examples, TerminalNumbers,
                         testing::Values("truss_simple", "plate_under_forces", "redundant/movable_pulley", "cantilever",
                                         "engine_inertia_gas", "virtual_work"),
                         [](const auto& each) {
                             std::string name = each.param;
                             std::replace(name.begin(), name.end(), '/', '_');
                             return name;
                         });

TEST(QuestionOfEquations, ShowsTheLoopsThatGiveTheLetters) {
    auto mechanism = read_mechanism(tests::contents(tests::example_file("four_bar")), "four_bar.json");
    mechanism->find.stated = mechanism->find.equations = true;
    const Solution solution = *solve(*std::move(mechanism));
    const std::vector<Page> question = sheet_of(solution, Language::en, SheetKind::question);
    pages::expect_clean(question);
    EXPECT_TRUE(says(question, "Jacobian"));
    bool loops = false;
    for (const Mark& mark : question.back().marks)
        if (const auto* group = std::get_if<GroupBegin>(&mark)) loops = loops || group->cls == "side";
    EXPECT_TRUE(loops);
    EXPECT_EQ(question.size(), 2U);
}

}  // namespace
}  // namespace kinegraph::render::work_sheet_test
