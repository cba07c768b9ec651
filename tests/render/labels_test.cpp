// Labels: none covers a stroke, an arrowhead or another label, in crowds too, and each stays beside its own object.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <string_view>

#include "render/figures/figure.hpp"
#include "render/page/shapes.hpp"
#include "tests/support/files.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/page_checker.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::render::labels_test {
namespace {

using tests::fonts;

LabelRequest named(const std::string& text, Spot anchor) {
    LabelRequest request;
    request.text = one_piece(text, Face::italic);
    request.anchor = anchor;
    return request;
}

/// The i-th place of a grid, row by row.
Spot grid(int i, int columns, double dx, double dy) {
    const int row = i / columns;
    return {dx * (i - row * columns), dy * row};
}

/// Corners of a label's ink, grown by `margin`, turned with it.
struct Ink {
    std::string words;
    Spot centre, half, axis;
};
std::vector<Ink> labels_of(const Figure& figure, const std::vector<LabelRequest>& requests) {
    std::vector<Ink> labels;
    std::size_t next = 0;
    for (const Mark& mark : figure.marks) {
        const auto* text = std::get_if<TextMark>(&mark);
        if (!text || text->cls != "label") continue;
        const ShapedLine shaped = fonts().shape(requests[next].text, requests[next].size);
        ++next;
        // Set about its middle: the pivot.
        labels.push_back({text->words,
                          text->pivot,
                          {shaped.width / 2, (shaped.ascent + shaped.descent) / 2},
                          {std::cos(text->angle), std::sin(text->angle)}});
    }
    return labels;
}
/// Points over the label's box, dense enough that no stroke passes between them unseen.
std::vector<Spot> samples(const Ink& ink) {
    std::vector<Spot> spots;
    for (int i = -12; i <= 12; ++i)
        for (int j = -6; j <= 6; ++j)
            spots.push_back(ink.centre + (ink.half.x * i / 12) * ink.axis + (ink.half.y * j / 6) * turned(ink.axis));
    return spots;
}
bool holds(const Ink& ink, Spot spot, double margin) {
    const Spot d = spot - ink.centre;
    return std::abs(dot(d, ink.axis)) <= ink.half.x + margin && std::abs(cross(ink.axis, d)) <= ink.half.y + margin;
}

void expect_clean(const Figure& figure, const std::vector<LabelRequest>& requests,
                  const std::vector<std::pair<Spot, Spot>>& strokes, double width) {
    const std::vector<Ink> labels = labels_of(figure, requests);
    ASSERT_EQ(labels.size(), requests.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (const Spot spot : samples(labels[i])) {
            for (const auto& [from, to] : strokes)
                EXPECT_GT(distance_to_segment(spot, from, to), width / 2 + 0.3) << labels[i].words << " on a stroke";
            for (std::size_t j = 0; j < labels.size(); ++j)
                EXPECT_FALSE(i != j && holds(labels[j], spot, 0.3)) << labels[i].words << " on " << labels[j].words;
            if (::testing::Test::HasFailure()) return;
        }
    }
}

TEST(Labels, beside_a_star_of_lines_stand_in_its_sectors) {
    Figure figure;
    std::vector<std::pair<Spot, Spot>> strokes;
    for (int i = 0; i < 5; ++i) {
        const double angle = 2 * std::numbers::pi * i / 5;
        strokes.push_back({{0, 0}, 30 * Spot{std::cos(angle), std::sin(angle)}});
    }
    for (const auto& [from, to] : strokes) figure.marks.emplace_back(line(from, to, {0.7, {}, {}, false}));
    figure.labels = {named("O", {0, 0}), named("A", strokes[0].second), named("B", strokes[1].second),
                     named("C", strokes[2].second)};
    const auto requests = figure.labels;
    place_labels(figure, fonts());
    expect_clean(figure, requests, strokes, 0.7);
}

TEST(Labels, stand_on_a_tint_however_dark_but_not_on_ink) {
    for (const bool tint : {true, false}) {
        Figure figure;
        Path plate = filled({{0, 0}, {60, 0}, {60, 60}, {0, 60}}, {0x20, 0x30, 0x40});
        plate.tinted = tint;
        figure.marks.emplace_back(std::move(plate));
        figure.labels = {named("A", {30, 30})};
        place_labels(figure, fonts());
        const Spot off = std::get<TextMark>(figure.marks.back()).pivot - Spot{30, 30};
        EXPECT_EQ(std::max(std::abs(off.x), std::abs(off.y)) < 30, tint);
    }
}

/// The circle of a body's number that finds room only on a tint, of that colour.
Path balloon_on(Colour tint, const BalloonGround& ground) {
    Figure figure;
    Path wheel = filled({{0, 0}, {60, 0}, {60, 60}, {0, 60}}, tint);
    wheel.tinted = true;
    figure.marks.emplace_back(std::move(wheel));
    figure.labels = {named("2", {30, 30})};
    figure.labels.front().balloon = 2.3;
    figure.labels.front().ground = ground;
    place_labels(figure, fonts());
    return std::get<Path>(figure.marks[1]);
}

TEST(Labels, numbers_on_the_tint_of_another_body_have_the_paper_as_ground) {
    for (const std::string_view name : theme_names()) {
        const Theme theme = built_in_theme(name).value();
        const Colour tint = theme.bodies[0].tint;
        const Path own = balloon_on(tint, {theme.paper, tint});
        EXPECT_FALSE(own.filled) << name;
        // Bodies that look alike cannot be told by their tint: no number stands on it as it is.
        const Path alike = balloon_on(tint, {theme.paper, std::nullopt});
        EXPECT_TRUE(alike.filled && alike.tinted) << name;
        EXPECT_EQ(alike.fill, theme.paper) << name;
        const Path other = balloon_on(tint, {theme.paper, theme.bodies[1].tint});
        EXPECT_EQ(other.filled, tint != theme.bodies[1].tint) << name;  // in print all tints are the paper's
        EXPECT_TRUE(!other.filled || other.fill == theme.paper) << name;
    }
}

/// A leader out of it is better, if there is paper within reach.
TEST(Labels, numbers_leave_the_tint_of_another_body) {
    const Theme theme;
    Figure figure;
    Path wheel = filled({{0, 0}, {30, 0}, {30, 30}, {0, 30}}, theme.bodies[0].tint);
    wheel.tinted = true;
    figure.marks.emplace_back(std::move(wheel));
    figure.labels = {named("2", {15, 15})};
    figure.labels.front().balloon = 2.3;
    figure.labels.front().ground = {theme.paper, theme.bodies[1].tint};
    place_labels(figure, fonts());
    const Spot at = std::get<TextMark>(figure.marks.back()).pivot;
    EXPECT_TRUE(at.x < -2 || at.x > 32 || at.y < -2 || at.y > 32) << at.x << ", " << at.y;
}

/// "m = 0.5 kg" and "F" behind it would be read as one.
TEST(Labels, that_tell_values_keep_more_than_a_blank_between_them) {
    for (double apart = 4; apart <= 24; apart += 0.5) {
        Figure figure;
        figure.marks.emplace_back(line({-60, 1}, {60, 1}, {0.7, {}, {}, false}));
        figure.labels = {named("m = 0.5 kg", {0, 0}), named("F = 2500 N", {apart, 0})};
        place_labels(figure, fonts());
        std::vector<Box> boxes;
        for (const Mark& mark : figure.marks)
            if (std::holds_alternative<TextMark>(mark)) boxes.push_back(box_of(std::span(&mark, 1)));
        ASSERT_EQ(boxes.size(), 2U);
        const bool side_by_side = boxes[0].min.y < boxes[1].max.y && boxes[1].min.y < boxes[0].max.y;
        const double gap = std::max(boxes[1].min.x - boxes[0].max.x, boxes[0].min.x - boxes[1].max.x);
        EXPECT_TRUE(!side_by_side || gap > 2.5) << gap << " mm, anchors " << apart << " mm apart";
    }
}

TEST(Labels, of_a_crowd_of_points_do_not_meet) {
    Figure figure;
    std::vector<std::pair<Spot, Spot>> strokes;
    // Nine points 5 mm apart, on a grid of thin lines: leaders are wanted.
    for (int i = 0; i < 3; ++i) {
        strokes.push_back({{-10, 5.0 * i}, {20, 5.0 * i}});
        strokes.push_back({{5.0 * i, -10}, {5.0 * i, 20}});
    }
    for (const auto& [from, to] : strokes) figure.marks.emplace_back(line(from, to, {0.18, {}, {}, false}));
    for (int i = 0; i < 9; ++i) figure.labels.push_back(named("P" + std::to_string(i), grid(i, 3, 5, 5)));
    const auto requests = figure.labels;
    place_labels(figure, fonts());
    expect_clean(figure, requests, strokes, 0.18);
}

TEST(Labels, of_vectors_stand_beside_them) {
    Figure figure;
    const std::vector<std::pair<Spot, Spot>> strokes{{{0, 0}, {60, 0}}, {{60, 0}, {30, -40}}, {{0, 0}, {30, -40}}};
    for (const auto& [from, to] : strokes) {
        draw_arrow(figure.marks, from, to, 0.7, {});
        LabelRequest request = named("v", 0.5 * (from + to));
        request.toward = to;
        figure.labels.push_back(request);
    }
    const auto requests = figure.labels;
    place_labels(figure, fonts());
    expect_clean(figure, requests, strokes, 0.7);
    const auto labels = labels_of(figure, requests);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LT(distance_to_segment(labels[i].centre, strokes[i].first, strokes[i].second), 6);
}

/// Distance of a label's box from a line, by dense points of both.
double distance(const Ink& ink, Spot from, Spot to) {
    double least = 1e300;
    for (const Spot& spot : samples(ink))
        for (int i = 0; i <= 200; ++i) least = std::min(least, length(from + (i / 200.0) * (to - from) - spot));
    return least;
}

TEST(Labels, of_forces_are_nearest_to_their_own_line_or_have_a_leader) {
    for (const double apart : {3.0, 5.0, 8.0})
        for (const double high : {8.0, 16.0, 30.0}) {
            Figure figure;
            std::vector<LabelRequest> requests;
            for (int i = 0; i < 4; ++i) {
                const Spot tail{apart * i, 0}, tip{apart * i, i % 2 == 0 ? high : 0.6 * high};
                figure.marks.emplace_back(line(tail, tip, {0.5, {}, {}, false}));
                LabelRequest request = named("F" + std::to_string(i), 0.5 * (tail + tip));
                request.toward = tip;
                request.clearance = 1.5;
                request.is_of_vector = true;
                requests.push_back(request);
            }
            figure.labels = requests;
            place_labels(figure, fonts());
            const std::vector<Ink> labels = labels_of(figure, requests);
            ASSERT_EQ(labels.size(), requests.size());
            int misread = 0;
            for (std::size_t i = 0; i < labels.size(); ++i)
                for (std::size_t j = 0; j < labels.size(); ++j) {
                    const auto away = [&](const LabelRequest& of) {
                        return distance(labels[i], 2.0 * of.anchor - *of.toward, *of.toward);
                    };
                    if (i != j && away(requests[j]) < away(requests[i])) {
                        ++misread;
                        break;
                    }
                }
            EXPECT_LE(misread, figure.leaders) << apart << " mm apart, " << high << " mm high";
        }
}

TEST(Labels, along_a_line_are_never_upside_down) {
    for (int i = 0; i < 24; ++i) {
        const double angle = 2 * std::numbers::pi * i / 24;
        Figure figure;
        const Spot end = 40 * Spot{std::cos(angle), std::sin(angle)};
        figure.marks.emplace_back(line({0, 0}, end, {0.18, {}, {}, false}));
        LabelRequest request = named("∥ BC", 0.5 * end);
        request.toward = end;
        request.along = true;
        request.clearance = 1.2;
        figure.labels.push_back(request);
        const auto requests = figure.labels;
        place_labels(figure, fonts());
        const auto labels = labels_of(figure, requests);
        ASSERT_EQ(labels.size(), 1U);
        EXPECT_GT(labels[0].axis.x, -1e-9);
        EXPECT_NEAR(std::abs(cross(labels[0].axis, unit(end))), 0, 1e-9);
        expect_clean(figure, requests, {{{0, 0}, end}}, 0.18);
    }
}

TEST(Labels, stay_within_the_figures_group_and_box) {
    Figure figure;
    figure.marks = {GroupBegin{"figure", GroupId("f"), "", {}}, line({0, 0}, {10, 0}, {}), GroupEnd{}};
    figure.box = {{0, 0}, {10, 0.1}};
    figure.labels = {named("A", {10, 0})};
    place_labels(figure, fonts());
    EXPECT_TRUE(std::holds_alternative<GroupEnd>(figure.marks.back()));
    EXPECT_TRUE(figure.labels.empty());
    for (const Mark& mark : figure.marks)
        if (const auto* text = std::get_if<TextMark>(&mark)) {
            EXPECT_GE(text->pivot.x, figure.box.min.x);
            EXPECT_LE(text->pivot.x, figure.box.max.x);
            EXPECT_GE(text->pivot.y, figure.box.min.y);
            EXPECT_LE(text->pivot.y, figure.box.max.y);
        }
}

/// A field of strokes with no room in it for a letter, and points all over: what finds no place beside it either is in
/// the key.
TEST(Labels, without_a_place_are_listed_below_the_figure) {
    for (const bool strict : {false, true}) {
        Figure figure;
        figure.marks.emplace_back(GroupBegin{"figure", GroupId("field"), "", {{"data-figure", "mechanism"}}});
        figure.marks.emplace_back(GroupBegin{"links", {}, "", {}});
        for (int i = 0; i <= 80; ++i)
            figure.marks.emplace_back(line({1.0 * i, 0}, {1.0 * i, 60}, {0.18, {0, 0, 0}, {}, false}));
        figure.marks.emplace_back(GroupEnd{});
        figure.marks.emplace_back(GroupEnd{});
        std::multiset<std::string> asked;
        for (int i = 0; i < 60; ++i) {
            figure.labels.push_back(named("N" + std::to_string(i), grid(i, 10, 8, 10) + Spot{4, 5}));
            asked.insert("N" + std::to_string(i));
        }
        const Spot room{90, 110};
        place_labels(figure, fonts(), room, strict ? Labelling::strict : Labelling::free);
        Page page;
        figure.move(60, 30);
        page.marks.emplace_back(
            polyline({{0, 0}, {page.width, 0}, {page.width, page.height}, {0, page.height}}, {}, true));
        page.marks.insert(page.marks.end(), figure.marks.begin(), figure.marks.end());
        std::multiset<std::string> shown;
        int numbers = 0;
        for (const Mark& mark : page.marks)
            if (const auto* text = std::get_if<TextMark>(&mark); text && text->cls == "label") {
                if (text->words.ends_with(")"))
                    ++numbers;
                else
                    shown.insert(text->words);
            }
        EXPECT_EQ(shown, asked);
        EXPECT_GT(numbers, 0);
        for (const Fault& fault : faults_of(page, fonts())) ADD_FAILURE() << said(fault);
        EXPECT_EQ(pixels_in_common(page, fonts(), 150), 0U);
        EXPECT_LE(figure.box.width(), strict ? room.x : 200.0);
        EXPECT_GT(figure.box.height(), 65);
        EXPECT_LE(figure.box.height(), strict ? room.y : 200.0);
    }
}

TEST(Labels, are_placed_alike_twice) {
    const auto once = [] {
        Figure figure;
        for (int i = 0; i < 20; ++i) {
            const Spot at = grid(i, 5, 7, 6);
            figure.marks.emplace_back(disc(at, 0.8, {}));
            figure.labels.push_back(named("Q" + std::to_string(i), at));
        }
        place_labels(figure, fonts());
        std::string places;
        for (const Mark& mark : figure.marks)
            if (const auto* text = std::get_if<TextMark>(&mark))
                places += std::to_string(text->pivot.x) + "," + std::to_string(text->pivot.y) + ";";
        return places;
    };
    EXPECT_EQ(once(), once());
}

/// A label's ink, from its outlines.
Box ink_of(const TextMark& text) {
    std::vector<Mark> dots;
    for (const Glyph& glyph : text.glyphs)
        for (const Segment& segment : fonts().outline(glyph.face, glyph.index).segments) {
            const auto add = [&](Spot s) {
                const Spot at = glyph.origin + glyph.size * Spot{s.x, -s.y};
                dots.emplace_back(Axis{at, at});
            };
            if (const auto* m = std::get_if<MoveTo>(&segment)) add(m->to);
            if (const auto* l = std::get_if<LineTo>(&segment)) add(l->to);
            if (const auto* c = std::get_if<CurveTo>(&segment)) {
                add(c->control_1);
                add(c->control_2);
                add(c->to);
            }
        }
    return box_of(dots);
}

/// What the labels of a finished figure cover: strokes (sampled every tenth of a mm) and each other.
std::vector<std::string> covered(const Figure& figure) {
    struct Label {
        std::string words;
        Box box;  // of the ink as if it were not turned
        double angle;
        Spot pivot;
        Spot unturned(Spot spot) const {
            const Spot d = spot - pivot;
            const double c = std::cos(angle), n = std::sin(angle);
            return pivot + Spot{d.x * c + d.y * n, d.y * c - d.x * n};
        }
        bool holds(Spot spot, double reach) const {
            const Spot at = unturned(spot);
            return at.x > box.min.x - reach && at.x < box.max.x + reach && at.y > box.min.y - reach &&
                   at.y < box.max.y + reach;
        }
    };
    std::vector<Label> labels;
    std::vector<std::pair<Spot, double>> ink;
    const auto stroke = [&](Spot from, Spot to, double half) {
        const int steps = static_cast<int>(length(to - from) / 0.1) + 1;
        for (int i = 0; i <= steps; ++i) ink.emplace_back(from + (static_cast<double>(i) / steps) * (to - from), half);
    };
    for (const Mark& mark : figure.marks) {
        if (const auto* text = std::get_if<TextMark>(&mark); text && text->cls == "label")
            labels.push_back({text->words, ink_of(*text), text->angle, text->pivot});
        const auto* path = std::get_if<Path>(&mark);
        if (!path) continue;
        // The ring of a body's number is part of its label.
        const auto* ring = path->segments.size() == 3 ? std::get_if<ArcTo>(&path->segments[1]) : nullptr;
        if (ring && (!path->filled || path->tinted) && ring->radius == 2.3) continue;
        const double half = path->stroked ? path->pen.width / 2 : 0;
        Spot pen, start;
        for (const Segment& segment : path->segments) {
            if (const auto* m = std::get_if<MoveTo>(&segment)) pen = start = m->to;
            if (const auto* l = std::get_if<LineTo>(&segment)) stroke(pen, l->to, half), pen = l->to;
            if (std::holds_alternative<Close>(segment)) stroke(pen, start, half);
            if (const auto* a = std::get_if<ArcTo>(&segment))
                for (int i = 0; i <= 400; ++i) {
                    const double angle = a->from + (a->to - a->from) * i / 400;
                    ink.emplace_back(a->centre + a->radius * Spot{std::cos(angle), std::sin(angle)}, half);
                }
        }
    }
    std::vector<std::string> faults;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const bool on_stroke = std::any_of(ink.begin(), ink.end(), [&](const std::pair<Spot, double>& dot) {
            return labels[i].holds(dot.first, dot.second + 0.1);
        });
        if (on_stroke) faults.push_back(labels[i].words + " on a stroke");
        for (std::size_t j = 0; j < labels.size(); ++j) {
            if (i == j) continue;
            bool met = false;
            const Label turned_back{labels[j].words, labels[j].box, -labels[j].angle, labels[j].pivot};
            for (int a = 0; a <= 20; ++a)
                for (int b = 0; b <= 8; ++b) {
                    const Box& box = labels[j].box;
                    met = met || labels[i].holds(turned_back.unturned({box.min.x + box.width() * a / 20,
                                                                       box.min.y + box.height() * b / 8}),
                                                 0.1);
                }
            if (met) faults.push_back(labels[i].words + " on " + labels[j].words);
        }
    }
    return faults;
}

TEST(Labels, of_every_example_cover_nothing) {
    const Theme theme;
    std::size_t letters = 0;
    for (const std::string& name : tests::example_names()) {
        const Solution& solution = tests::example(name);
        const DrawingContext context{solution, theme, fonts()};
        for (const Spot room : {Spot{185, 150}, Spot{125, 90}}) {
            std::vector<Figure> figures{mechanism_figure(context, room.x, room.y, true),
                                        velocities_on_mechanism(context, room.x, room.y),
                                        circle_diagram(context, 60, 60)};
            for (std::size_t p = 0; p < solution.protocol.polygons.size(); ++p)
                figures.push_back(polygon_figure(context, static_cast<int>(p), room.x, room.y));
            for (const Figure& figure : figures) {
                EXPECT_EQ(covered(figure), std::vector<std::string>{}) << name << " " << figure.id << " " << room.x;
                letters += static_cast<std::size_t>(
                    std::count_if(figure.marks.begin(), figure.marks.end(),
                                  [](const Mark& mark) { return std::holds_alternative<TextMark>(mark); }));
            }
        }
    }
    EXPECT_GT(letters, 1000U);
}

}  // namespace
}  // namespace kinegraph::render::labels_test
