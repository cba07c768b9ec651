// Figures: scales, ids, arrows, and what the mechanism figure promises: groups that nest, unique legal ids, vectors
// whose axes have the length of their values, nothing outside the room.
#include "render/figures/figure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "engine/sentences/centre_symbol.hpp"
#include "render/page/shapes.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::render::figure_test {
namespace {

using tests::example;
using tests::example_names;
using tests::fonts;
using tests::solved;

/// Opens and closes in order; ids are legal and met once.
void expect_well_grouped(const Figure& figure) {
    std::set<std::string> ids;
    int depth = 0;
    for (const Mark& mark : figure.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark)) {
            ++depth;
            if (group->id.empty()) continue;
            EXPECT_TRUE(ids.insert(group->id.text()).second) << group->id.text() << " twice";
            EXPECT_EQ(legal_id(group->id.text()), group->id.text());
        }
        if (std::holds_alternative<GroupEnd>(mark)) --depth;
        EXPECT_GE(depth, 0);
    }
    EXPECT_EQ(depth, 0);
}

TEST(Scale, is_the_finest_round_one_that_fits) {
    EXPECT_EQ(choose_scale(0.2, 0.1, 100, 100, std::nullopt), 0.002);
    EXPECT_EQ(choose_scale(0.201, 0.1, 100, 100, std::nullopt), 0.0025);
    EXPECT_EQ(choose_scale(0.26, 0.1, 100, 100, std::nullopt), 0.005);
    EXPECT_EQ(choose_scale(0.1, 6, 100, 100, std::nullopt), 0.1);
    EXPECT_EQ(choose_scale(3e7, 0, 100, 100, std::nullopt), 5e5);
    EXPECT_EQ(choose_scale(0.2, 0.1, 100, 100, 0.003), 0.003);
    EXPECT_GT(choose_scale(0, 0, 100, 100, std::nullopt), 0);
}

TEST(Scale, has_neighbours_in_the_series) {
    double scale = 0.001;
    for (int step = 0; step < 40; ++step) {
        const double coarser = next_scale(scale);
        EXPECT_GT(coarser, scale);
        EXPECT_LE(coarser, 2 * scale * (1 + 1e-12));
        EXPECT_EQ(finer_scale(coarser), scale);
        scale = coarser;
    }
}

TEST(Ids, keep_letters_and_write_the_rest_as_bytes) {
    EXPECT_EQ(legal_id("O2.a-b_c"), "O2.a-b_c");
    EXPECT_EQ(legal_id("A*"), "A_x2A_");
    EXPECT_EQ(legal_id("1 <2>"), "1_x20__x3C_2_x3E_");
    EXPECT_EQ(legal_id("α"), "_xCE__xB1_");
}

TEST(Arrow, has_its_tip_exactly_on_the_vertex) {
    for (const double width : {0.18, 0.35, 0.7})
        for (const double size : {0.3, 2.0, 60.0}) {
            const Spot tail{1.5, -2}, tip = tail + size * Spot{0.6, -0.8};
            std::vector<Mark> marks;
            draw_arrow(marks, tail, tip, width, {});
            ASSERT_EQ(marks.size(), 2U);
            const auto& head = std::get<Path>(marks[1]);
            const Spot first = std::get<MoveTo>(head.segments.front()).to;
            EXPECT_EQ(first.x, tip.x);
            EXPECT_EQ(first.y, tip.y);
            // The shaft stops inside the head, whose barbs lie behind the tip, never behind the tail.
            const Spot end = std::get<LineTo>(std::get<Path>(marks[0]).segments.back()).to;
            EXPECT_LT(length(end - tail), size);
            for (const Segment& segment : head.segments)
                if (const auto* barb = std::get_if<LineTo>(&segment)) {
                    EXPECT_GT(dot(barb->to - tail, unit(tip - tail)), 0);
                    EXPECT_LT(dot(barb->to - tip, unit(tip - tail)), 0);
                }
        }
}

TEST(Arrow, of_no_length_is_nothing) {
    std::vector<Mark> marks;
    draw_arrow(marks, {1, 1}, {1, 1}, 0.7, {});
    EXPECT_TRUE(marks.empty());
}

TEST(Move, carries_marks_labels_and_box) {
    Figure figure;
    figure.marks = {line({0, 0}, {1, 2}, {}), Axis{{0, 0}, {1, 2}}};
    figure.labels.resize(1);
    figure.labels[0].toward = Spot{1, 1};
    figure.box = {{0, 0}, {1, 2}};
    figure.move(10, 0.1);
    EXPECT_EQ(std::get<Axis>(figure.marks[1]).tip.x, 11);
    EXPECT_EQ(std::get<Axis>(figure.marks[1]).tip.y, 2.1);
    EXPECT_EQ(figure.labels[0].anchor.x, 10);
    EXPECT_EQ(figure.labels[0].toward->x, 11);
    EXPECT_EQ(figure.box.max.x, 11);
}

TEST(MechanismFigure, of_every_example_is_well_grouped_and_within_its_room) {
    const Theme theme;
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution& solution = example(name);
        for (const Language language : {Language::en, Language::it}) {
            const DrawingContext context{solution, theme, fonts(), language};
            const Figure figure = mechanism_figure(context, 185, 150, true);
            expect_well_grouped(figure);
            EXPECT_LE(figure.box.width(), 185);
            EXPECT_LE(figure.box.height(), 150);
            EXPECT_TRUE(figure.labels.empty());
            // box_of takes every letter for 0.62 em wide, the figure's box is that of the true ink; a parenthesis has
            // 0.33 em.
            const Box ink = box_of(figure.marks);
            const double narrow = 0.3 * theme.label;
            EXPECT_GE(ink.min.x, figure.box.min.x - narrow);
            EXPECT_LE(ink.max.x, figure.box.max.x + narrow);
        }
    }
}

TEST(MechanismFigure, has_a_group_for_each_link_joint_and_centre) {
    const Theme theme;
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution& solution = example(name);
        const DrawingContext context{solution, theme, fonts()};
        const Figure figure = mechanism_figure(context, 185, 150, true);
        std::set<std::string> ids;
        for (const Mark& mark : figure.marks)
            if (const auto* group = std::get_if<GroupBegin>(&mark)) ids.insert(group->id.text());
        EXPECT_EQ(ids.count("mechanism"), 1U);
        for (std::size_t b = 1; b < solution.mechanism.bodies.size(); ++b)
            EXPECT_EQ(ids.count("link-" + legal_id(solution.mechanism.bodies[b].name)), 1U);
        for (const Joint& joint : solution.mechanism.joints) EXPECT_EQ(ids.count("joint-" + legal_id(joint.name)), 1U);
        // Of many only the primary and the absolute ones are shown, and what leads to these.
        constexpr std::size_t bodies_with_all_centres_shown = 6;
        const bool all = solution.mechanism.bodies.size() <= bodies_with_all_centres_shown;
        for (const InstantCentre& centre : solution.centres)
            if (centre.at && (all || centre.first == frame || centre.how == InstantCentre::How::primary)) {
                std::string id = "centre-" + legal_id(solution.mechanism.bodies[at_index(centre.first)].name);
                id += "." + legal_id(solution.mechanism.bodies[at_index(centre.second)].name);
                EXPECT_EQ(ids.count(id), 1U);
            }
    }
}

TEST(MechanismFigure, has_only_finite_numbers_and_is_the_same_twice) {
    const Theme theme;
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution& solution = example(name);
        const DrawingContext context{solution, theme, fonts()};
        const Figure once = mechanism_figure(context, 120, 90, true), twice = mechanism_figure(context, 120, 90, true);
        EXPECT_EQ(once.marks.size(), twice.marks.size());
        EXPECT_EQ(once.box.max.x, twice.box.max.x);
        EXPECT_EQ(once.box.max.y, twice.box.max.y);
        EXPECT_TRUE(std::isfinite(once.box.width()) && std::isfinite(once.box.height()));
    }
}

TEST(MechanismFigure, takes_the_scale_the_file_asks) {
    const Solution solution = solved(R"({"kinegraph": 1, "frame": 1, "points": {"O": [0, 0], "A": [0.3, 0.4]},
        "bodies": {"2": ["O", "A"]}, "joints": [{"revolute": "O", "bodies": [1, 2]}],
        "drivers": [{"body": 2, "omega": 3}], "scales": {"mechanism": "1:5"}})");
    const Theme theme;
    const Figure figure = mechanism_figure({solution, theme, fonts()}, 185, 150, true);
    EXPECT_EQ(figure.scale, 0.005);
}

TEST(MechanismFigure, survives_strange_names) {
    const Solution solution = solved(
        R"({"kinegraph": 1, "frame": "the frame", "points": {"a b": [0, 0], "a_x20_b": [0.3, 0.4], "<&>": [0.5, 0]},
        "bodies": {"crank & arm": ["a b", "a_x20_b"], "5\"": ["a_x20_b", "<&>"]},
        "joints": [{"revolute": "a b", "bodies": ["the frame", "crank & arm"]}, {"revolute": "a_x20_b",
        "bodies": ["crank & arm", "5\""]}],
        "drivers": [{"body": "crank & arm", "omega": 3}, {"body": "5\"", "omega": 1}]})");
    const Theme theme;
    expect_well_grouped(mechanism_figure({solution, theme, fonts()}, 150, 120, true));
    expect_well_grouped(velocities_on_mechanism({solution, theme, fonts()}, 150, 120));
}

TEST(MechanismFigure, is_the_same_drawing_at_any_size) {
    const auto four_bar = [](const std::string& e) {
        return solved(R"({"kinegraph": 1, "points": {"A": [0, 0], "B": [3e)" + e + R"(, 4e)" + e + R"(], "C": [12e)" +
                      e + R"(, 7e)" + e + R"(], "D": [11e)" + e +
                      R"(, 0]}, "bodies": {"1": ["A", "B"], "2": ["B", "C"], "3": ["C", "D"]}, "joints": [
            {"revolute": "A", "bodies": ["0", "1"]}, {"revolute": "B", "bodies": ["1", "2"]}, {"revolute": "C",
            "bodies": ["2", "3"]},
            {"revolute": "D", "bodies": ["0", "3"]}], "drivers": [{"body": "1", "omega": 3}]})");
    };
    const Theme theme;
    const Solution usual = four_bar("-2");
    const Figure expected = mechanism_figure({usual, theme, fonts()}, 150, 120, true);
    for (const std::string e : {"-42", "38"}) {
        const Solution solution = four_bar(e);
        const Figure figure = mechanism_figure({solution, theme, fonts()}, 150, 120, true);
        EXPECT_NEAR(figure.scale / expected.scale, std::pow(10, std::stoi(e) + 2),
                    std::pow(10, std::stoi(e) + 2) * 1e-9);
        EXPECT_NEAR(figure.box.width(), expected.box.width(), 12);  // the bar's numbers are longer
        expect_well_grouped(figure);
    }
}

/// A number on the tint of a wheel would be taken for that wheel's.
TEST(MechanismFigure, has_the_numbers_of_wheels_on_no_other_wheel) {
    const Theme theme;
    int seen = 0;
    for (const char* name : {"planetary_train", "joint_contact/spur_gears", "rack_and_pinion", "disc_in_ring",
                             "cam_from_law", "cam_roller_follower", "variants/planetary_train"})
        for (double wide = 50; wide <= 170; wide += 10) {
            const Spot room{wide, 0.8 * wide};
            const Solution& solution = example(name);
            const Mechanism& mechanism = solution.mechanism;
            const Figure figure = mechanism_figure({solution, theme, fonts()}, room.x, room.y, false);
            const auto on_paper = [&](const Vector& place) {
                return figure.origin + (1 / figure.scale) * Spot{place.x.to_double(), -place.y.to_double()};
            };
            for (const Mark& mark : figure.marks) {
                const auto* text = std::get_if<TextMark>(&mark);
                const auto numbered = text == nullptr ? std::nullopt : mechanism.body_named(text->words);
                if (!numbered || text->cls != "label" || !mechanism.body(*numbered).circle) continue;
                ++seen;
                for (const BodyIndex other : mechanism.moving_bodies()) {
                    const auto& wheel = mechanism.body(other).circle;
                    if (other == *numbered || !wheel) continue;
                    EXPECT_GT(length(box_of(std::span(&mark, 1)).middle() - on_paper(solution.pose.at(wheel->centre))),
                              wheel->radius.to_double() / figure.scale)
                        << name << ", body " << text->words;
                }
            }
        }
    EXPECT_GT(seen, 8);
}

TEST(MechanismFigure, of_a_single_point_is_drawn) {
    const Solution solution = solved(R"({"kinegraph": 1, "points": {"O": [0, 0]}, "bodies": {"2": ["O"]},
        "joints": [{"revolute": "O", "bodies": ["0", "2"]}], "drivers": [{"body": "2", "omega": 1}]})");
    const Theme theme;
    const Figure figure = mechanism_figure({solution, theme, fonts()}, 150, 120, true);
    expect_well_grouped(figure);
    EXPECT_GT(figure.box.height(), 10);
    EXPECT_LT(figure.box.height(), 60);
}

/// Every vector drawn is as long as its value at the figure's scale. How many there are.
int expect_axes_as_long_as_their_values(const Figure& figure) {
    expect_well_grouped(figure);
    double value = -1;
    int measured = 0;
    for (const Mark& mark : figure.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->cls == "vector")
            if (const std::string* text = group->attribute("data-value")) value = std::stod(*text);
        if (const auto* axis = std::get_if<Axis>(&mark)) {
            EXPECT_NEAR(length(axis->tip - axis->tail), value / figure.scale, 1e-6);
            ++measured;
        }
    }
    return measured;
}

bool any_moves(const Solution& solution, Recorded<Vector> PointMotion::*vector) {
    return std::any_of(solution.points.begin(), solution.points.end(),
                       [&](const PointMotion& motion) { return motion.*vector && !(motion.*vector)->is_zero(); });
}

TEST(OnMechanism, VelocitiesAndAccelerationsAreAsLongAsTheirValues) {
    const Theme theme;
    for (const std::string& name : example_names()) {
        SCOPED_TRACE(name);
        const Solution& solution = example(name);
        const DrawingContext context{solution, theme, fonts()};
        EXPECT_EQ(expect_axes_as_long_as_their_values(velocities_on_mechanism(context, 120, 100)) > 0,
                  any_moves(solution, &PointMotion::velocity));
        EXPECT_EQ(expect_axes_as_long_as_their_values(accelerations_on_mechanism(context, 120, 100)) > 0,
                  any_moves(solution, &PointMotion::acceleration));
    }
}

std::set<std::string> labels_of(const Figure& figure) {
    std::set<std::string> words;
    for (const Mark& mark : figure.marks)
        if (const auto* text = std::get_if<TextMark>(&mark); text && text->cls == "label") words.insert(text->words);
    return words;
}

// The numbers are those of the seed problem's four-bar: its sentences tell them with as many digits.
TEST(OnMechanism, WhatTurnsIsNamedWithItsValue) {
    const Theme theme;
    const Solution& solution = example("four_bar");
    const std::set<std::string> words = labels_of(accelerations_on_mechanism({solution, theme, fonts()}, 120, 100));
    EXPECT_TRUE(words.contains("α_3 = 31.4 rad/s^2"));
    EXPECT_TRUE(words.contains("α_4 = 56.9 rad/s^2"));
}

TEST(FoundTurnings, StandOnTheMechanismWhereTheyCostItNothing) {
    const Theme theme;
    const Solution& solution = example("four_bar");
    const DrawingContext context{solution, theme, fonts()};
    const Spot roomy{100, 90}, tight{64, 52};
    const Figure plain = mechanism_figure(context, roomy.x, roomy.y, true);
    const Figure rich = mechanism_with_found_turnings(context, plain, roomy, true);
    EXPECT_EQ(rich.scale, plain.scale);
    EXPECT_LE(rich.box.width(), roomy.x);
    EXPECT_LE(rich.box.height(), roomy.y);
    const std::set<std::string> before = labels_of(plain), after = labels_of(rich);
    EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
    EXPECT_TRUE(after.contains("ω_3 = 1.31 rad/s") && after.contains("ω_4 = −4.78 rad/s"));
    // In less room some are left out, and no name that stood there before.
    const Figure small = mechanism_figure(context, tight.x, tight.y, true);
    const Figure some = mechanism_with_found_turnings(context, small, tight, true);
    const std::set<std::string> without = labels_of(small), with = labels_of(some);
    EXPECT_FALSE(with.contains("ω_3 = 1.31 rad/s") && with.contains("ω_4 = −4.78 rad/s"));
    if (some.scale != any_scale) {
        EXPECT_EQ(some.scale, small.scale);
        EXPECT_TRUE(std::includes(with.begin(), with.end(), without.begin(), without.end()));
    }
}

/// The four-bar whose crank is also accelerated; it starts from rest where there is no ω.
Solution accelerated(const std::string& rates) {
    std::string text = tests::contents(tests::example_file("four_bar"));
    const std::string given = R"("omega": "-120 rpm")";
    return solved(text.replace(text.find(given), given.size(), rates));
}

/// They are data: no figure of the mechanism is too small for them.
TEST(GivenAccelerations, StandOnTheMechanism) {
    const Theme theme;
    const Spot roomy{100, 90}, tight{64, 52};
    for (const char* rates : {R"("omega": "-120 rpm", "alpha": 25)", R"("alpha": 25)"}) {
        const Solution solution = accelerated(rates);
        for (const Language language : {Language::en, Language::it}) {
            const std::string said = language == Language::en ? "α_2 = 25 rad/s^2" : "ω̇_2 = 25 rad/s^2";
            const DrawingContext context{solution, theme, fonts(), language};
            const Figure plain = mechanism_figure(context, roomy.x, roomy.y, true);
            const Figure rich = mechanism_with_found_turnings(context, plain, roomy, true);
            EXPECT_TRUE(rich.scale == any_scale || labels_of(rich).contains(said)) << said;
            EXPECT_TRUE(labels_of(plain).contains(said)) << said;
            EXPECT_TRUE(labels_of(mechanism_figure(context, tight.x, tight.y, true)).contains(said)) << said;
            EXPECT_TRUE(labels_of(accelerations_on_mechanism(context, 120, 100)).contains(said));
            EXPECT_TRUE(labels_of(exercise_figure(context, plain.scale, 130, 110)).contains(said));
            EXPECT_FALSE(labels_of(velocities_on_mechanism(context, 120, 100)).contains(said));
        }
    }
}

/// Names of the instant centres that a figure shows, by the titles of their groups.
std::set<std::string> centres_of(const Figure& figure) {
    std::set<std::string> names;
    for (const Mark& mark : figure.marks)
        if (const auto* group = std::get_if<GroupBegin>(&mark); group && group->cls == "centre")
            names.insert(group->title);
    return names;
}
/// … and those that the solution has.
std::set<std::string> centres_of(const Solution& solution, Language language) {
    std::set<std::string> names;
    for (const InstantCentre& centre : solution.centres)
        if (centre.at)
            names.insert(plain(typeset(
                centre_symbol(solution.mechanism, centre.first, centre.second, centre.at->at_infinity()), language)));
    return names;
}

TEST(MechanismFigure, says_which_centres_it_leaves_out) {
    const Theme theme;
    std::size_t left_out = 0;
    for (const std::string& name : example_names())
        for (const Language language : {Language::en, Language::it}) {
            const Solution& solution = example(name);
            if (solution.instantaneous_motion) continue;
            const std::set<std::string> all = centres_of(solution, language);
            for (const Spot room : {Spot{70, 60}, Spot{250, 180}}) {
                const Figure figure = mechanism_figure({solution, theme, fonts(), language}, room.x, room.y, true);
                const std::set<std::string> drawn = centres_of(figure);
                const std::string caption = plain(figure.caption) + ",";
                const std::size_t from = caption.find(language == Language::en ? ", without " : ", senza ");
                EXPECT_EQ(all == drawn, from == std::string::npos) << name << ": " << caption;
                constexpr std::size_t most_named = 6;
                if (all.size() > drawn.size() + most_named) continue;
                for (const std::string& centre : all) {
                    const bool is_told =
                        from != std::string::npos && caption.find(" " + centre + ",", from) != std::string::npos;
                    EXPECT_EQ(is_told, !drawn.contains(centre)) << name << ", " << centre << ": " << caption;
                    left_out += is_told ? 1 : 0;
                }
            }
        }
    EXPECT_GT(left_out, 0U);
}

TEST(CircleDiagram, has_a_chord_for_each_centre_found) {
    const Theme theme;
    const Solution& solution = example("four_bar");
    const Figure figure = circle_diagram({solution, theme, fonts()}, 60, 60);
    expect_well_grouped(figure);
    int chords = 0;
    for (const Mark& mark : figure.marks)
        if (const auto* path = std::get_if<Path>(&mark); path && path->segments.size() == 2)
            chords += std::holds_alternative<LineTo>(path->segments[1]);
    EXPECT_EQ(chords, 6);
    EXPECT_LE(figure.box.width(), 60);
}

}  // namespace
}  // namespace kinegraph::render::figure_test
