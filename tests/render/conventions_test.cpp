// Conventions of the figures: every vector has its axis line, a dashed side is an internal force, what a heavy or a
// thin stroke and an arrow without a scale mean is said, signs at arrows are those of the tables.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "render/figures/figure.hpp"
#include "render/figures/truss_figures.hpp"
#include "render/page/shapes.hpp"
#include "render/sheet/sheet.hpp"
#include "tests/support/pages.hpp"

namespace conventions_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;
using namespace kinegraph::pages;

const std::string* attribute_of(const GroupBegin& group, const std::string& key) {
    for (const auto& [own, text] : group.attributes)
        if (own == key) return &text;
    return nullptr;
}

/// Calls see(mark, groups that hold it, outermost first) for each mark.
template <class See>
void visit_marks(const std::vector<Mark>& marks, See see) {
    std::vector<const GroupBegin*> inside;
    for (const Mark& mark : marks) {
        if (std::holds_alternative<GroupEnd>(mark)) {
            inside.pop_back();
            continue;
        }
        see(mark, inside);
        if (const auto* group = std::get_if<GroupBegin>(&mark)) inside.push_back(group);
    }
}

const std::vector<const char*> with_vectors{"truss_simple",  "truss_roof_wind",         "scara",     "moving_frame",
                                            "four_bar",      "slider_on_moving_guide",  "exam_2001", "four_bar_weights",
                                            "excavator_arm", "joint_contact/spur_gears"};

/// The axis of a vector is as long as its value at its scale; of a bar in compression the value is negative.
TEST(Conventions, EveryVectorHasItsAxisLine) {
    for (const char* name : with_vectors) {
        std::size_t vectors = 0, axes = 0;
        for (const Page& page : laid_out(name))
            visit_marks(page.marks, [&](const Mark& mark, const std::vector<const GroupBegin*>& inside) {
                if (const auto* group = std::get_if<GroupBegin>(&mark)) {
                    const bool in_figure = std::any_of(inside.begin(), inside.end(), [](const GroupBegin* each) {
                        return attribute_of(*each, "data-figure") != nullptr;
                    });
                    vectors += in_figure && group->cls == "vector" ? 1 : 0;
                }
                const auto* axis = std::get_if<Axis>(&mark);
                if (axis == nullptr || inside.back()->cls != "vector") return;
                ++axes;
                double scale = 0;
                for (const GroupBegin* group : inside)
                    if (const std::string* text = attribute_of(*group, "data-scale")) scale = std::stod(*text);
                const double value = std::stod(*attribute_of(*inside.back(), "data-value"));
                EXPECT_NEAR(length(axis->tip - axis->tail), std::abs(value) / scale, 2e-6)
                    << name << ", " << inside.back()->id.text();
            });
        EXPECT_EQ(axes, vectors) << name;
        EXPECT_GT(vectors, 0U) << name;
    }
}

bool is_dashed(const Mark& mark) {
    const auto* path = std::get_if<Path>(&mark);
    return path != nullptr && path->stroked && path->pen.dashes == dashes();
}

/// In the sixth body's colour, too, and of rays and reactions: solid. Resultants have long dashes.
TEST(Conventions, ADashedSideIsAnInternalForce) {
    std::size_t dashed = 0;
    for (const char* name : {"excavator_arm", "gerber_beam", "truss_roof_wind", "four_bar_inertia", "pliers"})
        for (const Page& page : laid_out(name))
            visit_marks(page.marks, [&](const Mark& mark, const std::vector<const GroupBegin*>& inside) {
                if (!is_dashed(mark)) return;
                std::string figure;
                for (const GroupBegin* group : inside)
                    if (const std::string* kind = attribute_of(*group, "data-figure")) figure = *kind;
                const bool is_arrow =
                    !inside.empty() &&
                    (inside.back()->cls == "vector" || inside.back()->cls == "force" || inside.back()->cls == "sense");
                if (figure == "closure" && is_arrow) ++dashed;
                if (figure != "closure") {
                    EXPECT_FALSE(is_arrow) << name << ", " << inside.back()->id.text();
                    EXPECT_NE(figure, "forces") << name;
                }
            });
    EXPECT_GT(dashed, 3U);
}

std::string words_in(const Figure& figure) {
    std::string words;
    for (const Mark& mark : figure.marks)
        if (const auto* text = std::get_if<TextMark>(&mark)) words += text->words + "\n";
    return words;
}

TEST(Conventions, TrussesSayHowTensionAndCompressionAreDrawn) {
    const Theme theme;
    for (const char* name : {"truss_simple", "truss_roof_wind"}) {
        const DrawingContext context{example(name), theme, fonts()};
        for (const Figure& figure : {truss_figure(context, 120, 120), cremona_figure(context, 120, 120)})
            for (const char* word : {"tension\n", "compression\n"})
                EXPECT_NE(words_in(figure).find(word), std::string::npos) << name << ", " << figure.id;
    }
}

TEST(Conventions, ArrowsWithoutAScaleAreThinAndSaySo) {
    const Theme theme;
    const DrawingContext context{example("exam_2001"), theme, fonts()};
    const Figure figure = mechanism_with_forces(context, 120, 120);
    EXPECT_EQ(figure.further_scale, "arrows not to scale");
    EXPECT_FALSE(says(laid_out("four_bar"), "arrows not to scale"));
}

/// A couple at its arrow has the sign that it has in the table, as an angular velocity has.
TEST(Conventions, CouplesAtArrowsHaveTheSignOfTheTable) {
    const Theme theme;
    std::size_t negative = 0, positive = 0;
    for (const char* name : {"exam_2001", "four_bar_inertia", "sluice_gate"}) {
        const Solution& solution = example(name);
        const DrawingContext context{solution, theme, fonts()};
        for (std::size_t i = 0; i < solution.free_bodies.size(); ++i)
            for (const AppliedForce& applied : solution.free_bodies[i].forces) {
                if (applied.couple.is_zero()) continue;
                const std::string words = words_in(free_body_figure(context, i, 130, 130, false));
                const bool is_negative = applied.couple.sign() < 0;
                (is_negative ? negative : positive) += 1;
                EXPECT_EQ(words.find("= −") != std::string::npos, is_negative) << name << ": " << words;
            }
    }
    EXPECT_GT(negative, 0U);
    EXPECT_GT(positive, 0U);
}

TEST(Conventions, TeethShowThePressureAngleOnTheLineOfAction) {
    EXPECT_TRUE(says(laid_out("joint_contact/spur_gears"), "20°"));
    const Theme theme;
    const DrawingContext context{example("joint_contact/spur_gears"), theme, fonts()};
    EXPECT_NE(words_in(mechanism_with_forces(context, 120, 120)).find("20°"), std::string::npos);
}

/// The barrel of a cylinder is cut free as a barrel: as long as the stroke, though its body has one point only.
TEST(Conventions, ABarrelCutFreeIsABarrel) {
    const Theme theme;
    const Solution& solution = example("tipper");
    const DrawingContext context{solution, theme, fonts()};
    std::size_t barrels = 0;
    for (std::size_t i = 0; i < solution.free_bodies.size(); ++i) {
        if (solution.free_bodies[i].body != solution.mechanism.body_named("2")) continue;
        const Figure figure = free_body_figure(context, i, 100, 80, false);
        visit_marks(figure.marks, [&](const Mark& mark, const std::vector<const GroupBegin*>& inside) {
            const auto* path = std::get_if<Path>(&mark);
            if (path == nullptr || inside.empty() || inside.back()->cls != "link") return;
            const Box box = box_of(std::vector<Mark>{mark});
            barrels += std::hypot(box.width(), box.height()) > 15 ? 1 : 0;
        });
    }
    EXPECT_GT(barrels, 0U);
}

/// A noun follows from what a body does, not from a list of mechanisms.
TEST(Conventions, NounsFollowTheStructure) {
    const auto bodies_of = [](const char* name) { return words_of(laid_out(name)); };
    EXPECT_NE(bodies_of("cam_roller_follower").find("follower R"), std::string::npos);
    EXPECT_NE(bodies_of("cam_knife_edge").find("cam O"), std::string::npos);
    EXPECT_NE(bodies_of("rack_and_pinion").find("rack "), std::string::npos);
    EXPECT_NE(bodies_of("rack_and_pinion").find("gear "), std::string::npos);
    EXPECT_EQ(bodies_of("three_hinged_arch").find("rocker"), std::string::npos);
    EXPECT_NE(bodies_of("wheel_rod_slider").find("disc "), std::string::npos);
}

/// What uses the velocities stands after them, and equal sentences are one.
TEST(Conventions, SentencesAreToldOnceAndInTheirOrder) {
    const std::string exam = words_of(laid_out("exam_2001"));
    EXPECT_NE(exam.find("move alike"), std::string::npos);
    const std::string butterfly = words_of(laid_out("double_butterfly"));
    const std::size_t centres = butterfly.find("from the velocities: ");
    ASSERT_NE(centres, std::string::npos);
    EXPECT_LT(butterfly.find("Velocity polygon"), centres);
    EXPECT_NE(butterfly.find("trial values 0 and 1"), std::string::npos);
}

}  // namespace
}  // namespace conventions_test
