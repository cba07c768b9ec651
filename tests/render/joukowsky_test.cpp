// Joukowsky's lever: what is drawn balances about the pole, each moment being the power that the table has; and the
// option that asks for it, from the outside.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "lang/keys/sheet.hpp"
#include "render/figures/figure.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/tables.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::render::joukowsky_test {
namespace {

using tests::contents;
using tests::example;
using tests::fonts;

namespace fs = std::filesystem;

/// The axes of the groups of a class, in order.
std::vector<Axis> axes(const Figure& figure, const std::string& cls) {
    std::vector<Axis> found;
    for (std::size_t i = 0; i + 1 < figure.marks.size(); ++i)
        if (const auto* group = std::get_if<GroupBegin>(&figure.marks[i]); group && group->cls == cls)
            if (const auto* axis = std::get_if<Axis>(&figure.marks[i + 1])) found.push_back(*axis);
    return found;
}
double scale_of_forces(const Figure& figure) {
    for (const Mark& mark : figure.marks)
        if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->cls == "force")
            if (const std::string* scale = group->attribute("data-scale")) return std::stod(*scale);
    return 0;
}

class Lever : public testing::TestWithParam<const char*> {};

TEST_P(Lever, BalancesAboutThePole) {
    const Solution& solution = example(GetParam());
    ASSERT_EQ(no_lever(solution), NoLever::drawn);
    const Units& units = solution.mechanism.units;
    for (const double room : {70.0, 160.0}) {
        const Figure figure = joukowsky_figure({solution, Theme{}, fonts(), Language::en}, room, room);
        const std::vector<Axis> forces = axes(figure, "force"), rays = axes(figure, "ray");
        ASSERT_FALSE(rays.empty());
        const Spot pole = rays.front().tail;
        for (const Axis& ray : rays) EXPECT_LT(length(ray.tail - pole), 1e-12);
        const double power_of_square = figure.scale * scale_of_forces(figure) *
                                       (units.velocity.si * units.force.si).to_double();  // W for each mm²
        std::vector<double> moments;
        for (const Axis& force : forces)
            moments.push_back(power_of_square * cross(force.tail - pole, force.tip - force.tail));

        double largest = 0, sum = 0;
        for (const VirtualWork::Entry& entry : solution.virtual_work->entries)
            largest = std::max(largest, std::abs(entry.power.to_double()));
        ASSERT_GT(largest, 0);
        std::size_t next = 0;
        for (const VirtualWork::Entry& entry : solution.virtual_work->entries) {
            const double couple = (entry.couple * entry.omega).to_double();
            sum += couple;
            if (entry.force.is_zero()) continue;
            ASSERT_LT(next, moments.size());
            // y runs downwards on paper: the sign of moments is changed there once more.
            EXPECT_NEAR(moments[next], entry.power.to_double() - couple, 1e-9 * largest) << name_of(entry.symbol);
            sum += moments[next++];
        }
        EXPECT_EQ(next, moments.size());
        EXPECT_LE(std::abs(sum), 1e-9 * largest);
    }
}

TEST_P(Lever, FitsItsRoomAndItsTableSaysThatTheSumIsZero) {
    const Solution& solution = example(GetParam());
    for (const Language language : {Language::en, Language::it}) {
        const DrawingContext context{solution, Theme{}, fonts(), language};
        const Figure figure = joukowsky_figure(context, 110, 130);
        EXPECT_LE(figure.box.width(), 110);
        EXPECT_LE(figure.box.height(), 130);
        EXPECT_EQ(figure.data_figure, "velocity");
        EXPECT_EQ(figure.id, "joukowsky");
        double longest = 0;
        for (const Axis& force : axes(figure, "force")) longest = std::max(longest, length(force.tip - force.tail));
        EXPECT_GT(longest, 9.9);
        EXPECT_LE(longest, 25 * (1 + 1e-9));

        const Block table = joukowsky_block(context, 80);
        EXPECT_LE(table.width, 80);
        bool after_sum = false;
        for (const Mark& mark : table.marks) {
            const auto* text = std::get_if<TextMark>(&mark);
            if (!text || text->words.empty()) continue;
            if (after_sum) {
                EXPECT_EQ(text->words, "0");
                break;
            }
            after_sum = text->words == word(lang::sheet::sum, language);
        }
        EXPECT_TRUE(after_sum);
    }
}

INSTANTIATE_TEST_SUITE_P(Examples, Lever,
                         testing::Values("exam_2001", "gas_force", "cutting_force", "four_bar_weights",
                                         "four_bar_inertia", "rotating_body"));

TEST(NoLever, IsTold) {
    EXPECT_EQ(no_lever(example("four_bar")), NoLever::no_forces);
    EXPECT_EQ(no_lever(example("beam")), NoLever::no_velocities);
}

struct Outcome {
    int status = -1;
    std::string err;
    int levers = 0, pages = 0;
};
/// Runs `solve` on an example with an SVG as its output, in a folder of its own.
Outcome run(const std::string& name, const std::string& options) {
    std::string pattern = (fs::temp_directory_path() / "kinegraph-lever-XXXXXX").string();
    if (!::mkdtemp(pattern.data())) return {};
    const fs::path folder = pattern;
    const std::string command = "cd '" + folder.string() + "' && '" + KINEGRAPH_PROGRAM + "' solve '" +
                                tests::example_file(name).string() + "' " + options + " >out 2>err";
    Outcome outcome;
    const int status = std::system(command.c_str());
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.err = contents(folder / "err");
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".svg") continue;
        ++outcome.pages;
        const std::string svg = contents(entry.path());
        if (svg.find("id=\"joukowsky\" data-figure=\"velocity\"") != std::string::npos) ++outcome.levers;
    }
    fs::remove_all(folder);
    return outcome;
}

TEST(WithJoukowsky, AddsOneFigure) {
    EXPECT_EQ(run("gas_force", "-o a.svg").levers, 0);
    for (const char* options :
         {"-o a.svg --with joukowsky", "--with joukowsky --with joukowsky -o a.svg --lang it --paper A3"}) {
        const Outcome outcome = run("gas_force", options);
        EXPECT_EQ(outcome.status, 0);
        EXPECT_EQ(outcome.levers, 1) << options;
        EXPECT_EQ(outcome.err.find("lever"), std::string::npos) << outcome.err;
    }
}

TEST(WithJoukowsky, RemarksWhereThereIsNoLever) {
    const Outcome outcome = run("four_bar", "-o a.svg --with joukowsky");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_GT(outcome.pages, 0);
    EXPECT_EQ(outcome.levers, 0);
    EXPECT_NE(outcome.err.find("remark: no lever: "), std::string::npos) << outcome.err;
    EXPECT_NE(run("gas_force", "-o a.json --with joukowsky").err.find("remark: --with joukowsky"), std::string::npos);
}

TEST(WithJoukowsky, AnUnknownFigureIsRefusedAndTheKnownOnesNamed) {
    const Outcome outcome = run("gas_force", "-o a.svg --with zhukovsky");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.pages, 0);
    EXPECT_NE(outcome.err.find("zhukovsky"), std::string::npos);
    EXPECT_NE(outcome.err.find("joukowsky"), std::string::npos);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
}

}  // namespace
}  // namespace kinegraph::render::joukowsky_test
