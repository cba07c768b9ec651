#include "render/figures/pair_pen.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "render/figures/problem_figure.hpp"
#include "render/page/shapes.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {
using std::numbers::pi;
}  // namespace

PairPen::PairPen(const DrawingContext& context, const std::string& id, double larger)
    : context_(context), theme_(context.theme), larger_(larger) {
    figure_ = begun("pair", id.c_str(), {}, 1, "mm", context.language);
    figure_.has_scale = false;
}

const BodyColour& PairPen::colour(int body) const { return theme_.body(BodyIndex(static_cast<std::size_t>(body))); }
Pen PairPen::outline(int body) const { return {1.6 * theme_.outline, colour(body).line, {}, true}; }
std::vector<Spot> PairPen::there(std::vector<Spot> spots) const {
    for (Spot& spot : spots) spot = there(spot);
    return spots;
}
const std::vector<double>& PairPen::dashed() const {
    static const std::vector<double> kind{1.5, 0.7};
    return kind;
}

void PairPen::bar(Spot from, Spot to, int body) {
    const std::size_t first = figure_.marks.size();
    figure_.marks.emplace_back(line(there(from), there(to), {theme_.link, colour(body).line, {}, true}));
    draw_line_kind(figure_.marks, first, theme_.link, colour(body), theme_);
}
void PairPen::block(Spot middle, Spot u, Spot w, int body) {
    figure_.marks.emplace_back(
        render::panel(corners_about(there(middle), larger_ * u, larger_ * w), colour(body).tint, outline(body)));
}
void PairPen::panel(std::vector<Spot> spots, int body) {
    figure_.marks.emplace_back(render::panel(there(std::move(spots)), colour(body).tint, outline(body)));
}
void PairPen::paper(std::vector<Spot> spots, int body) {
    figure_.marks.emplace_back(render::panel(there(std::move(spots)), theme_.paper, outline(body)));
}
void PairPen::plate(std::vector<Spot> ends, int body) {
    Pen pen = outline(body);
    pen.width = theme_.link;
    const std::size_t first = figure_.marks.size();
    figure_.marks.emplace_back(render::panel(there(std::move(ends)), colour(body).tint, pen));
    draw_line_kind(figure_.marks, first, theme_.link, colour(body), theme_);
}
void PairPen::edge(std::vector<Spot> spots, int body) {
    figure_.marks.emplace_back(polyline(there(std::move(spots)), {theme_.outline, colour(body).line, {}, true}));
}
void PairPen::wheel_without_hub(Spot centre, double radius, int body) {
    figure_.marks.emplace_back(ring(there(centre), larger_ * radius, colour(body).tint, outline(body)));
}
void PairPen::wheel(Spot centre, double radius, int body) {
    wheel_without_hub(centre, radius, body);
    figure_.marks.emplace_back(ring(there(centre), 0.9, theme_.paper, {theme_.outline, colour(body).line, {}, false}));
}
void PairPen::cap(Spot centre, double radius, int body) {
    std::vector<Spot> spots;
    constexpr int pieces = 32;
    constexpr double half = 0.75;
    for (int i = 0; i <= pieces; ++i)
        spots.push_back(centre + radius * polar_spot(-pi / 2 - half + 2 * half * i / pieces));
    std::vector<Spot> area = spots;
    const double below = spots.front().y + 3.4;
    area.push_back({spots.back().x, below});
    area.push_back({spots.front().x, below});
    figure_.marks.emplace_back(tinted(filled(there(std::move(area)), colour(body).tint)));
    figure_.marks.emplace_back(polyline(there(std::move(spots)), outline(body)));
}
void PairPen::gear(Spot centre, double radius, int teeth, double phase, int body) {
    const double module = 2 * radius / teeth, pitch = 2 * pi / teeth;
    std::vector<Spot> spots;
    for (int i = 0; i < teeth; ++i) {
        const double middle = pitch * (i + phase);
        const auto corner = [&](double r, double share) {
            spots.push_back(there(centre + r * polar_spot(middle + share * pitch)));
        };
        corner(radius - 1.1 * module, -0.34);
        corner(radius + 0.9 * module, -0.14);
        corner(radius + 0.9 * module, 0.14);
        corner(radius - 1.1 * module, 0.34);
    }
    figure_.marks.emplace_back(render::panel(spots, colour(body).tint, {theme_.outline, colour(body).line, {}, true}));
    figure_.marks.emplace_back(
        circle(there(centre), larger_ * radius,
               {theme_.thin, colour(body).line, going_round(dash_dot(), 2 * pi * larger_ * radius), false}));
    figure_.marks.emplace_back(ring(there(centre), 0.9, theme_.paper, {theme_.outline, colour(body).line, {}, false}));
}
void PairPen::pin(Spot at, int body) {
    figure_.marks.emplace_back(
        ring(there(at), 1.3, theme_.paper, {1.4 * theme_.outline, colour(body).line, {}, false}));
}
void PairPen::clamp(Spot at) {
    figure_.marks.emplace_back(filled(corners_about(there(at), {1.5, 0}, {0, 1.5}), theme_.text));
}
void PairPen::dot(Spot at) { figure_.marks.emplace_back(disc(there(at), 0.7, theme_.text)); }
void PairPen::body_dot(Spot at, int body) { figure_.marks.emplace_back(disc(there(at), 1.1, colour(body).line)); }
void PairPen::stroke(Spot from, Spot to) {
    figure_.marks.emplace_back(line(there(from), there(to), {1.6 * theme_.outline, theme_.text, {}, true}));
}
void PairPen::ground(Spot from, Spot to, Spot away) {
    figure_.marks.emplace_back(line(there(from), there(to), {2 * theme_.outline, theme_.text, {}, false}));
    const Spot along = unit(to - from);
    const double whole = length(to - from);
    for (double s = 1; s <= whole; s += 2) {
        const Spot foot = there(from + s * along);
        figure_.marks.emplace_back(line(foot, foot + 1.7 * away - 1.2 * along, {theme_.thin, theme_.text, {}, false}));
    }
}
void PairPen::pivot(Spot at) {
    figure_.marks.emplace_back(
        polyline(there({at, at + Spot{-3, 5}, at + Spot{3, 5}}), {theme_.outline, theme_.text, {}, true}, true));
    ground(at + Spot{-4.5, 5}, at + Spot{4.5, 5}, {0, 1});
}
void PairPen::spring(Spot from, Spot to) {
    const Spot along = unit(to - from), aside = turned(along);
    const double whole = length(to - from);
    std::vector<Spot> spots{from, from + 0.12 * whole * along};
    constexpr int coils = 8;
    for (int i = 0; i < coils; ++i)
        spots.push_back(from + (0.12 + 0.76 * (i + 0.5) / coils) * whole * along + (i % 2 == 0 ? 2.2 : -2.2) * aside);
    spots.push_back(from + 0.88 * whole * along);
    spots.push_back(to);
    figure_.marks.emplace_back(polyline(there(std::move(spots)), {theme_.outline, theme_.text, {}, true}));
}

void PairPen::axis(Spot from, Spot to) {
    figure_.marks.emplace_back(line(there(from), there(to), {theme_.thin, theme_.secondary, dash_dot(), false}));
}
void PairPen::label(const std::string& text, Spot anchor, std::optional<Spot> toward, Colour ink) {
    figure_.labels.push_back({.text = formula(text),
                              .size = theme_.derived,
                              .colour = ink,
                              .anchor = anchor,
                              .toward = toward,
                              .clearance = 1.4});
}
void PairPen::both_ways(Spot middle, Spot reach, const std::string& name) {
    for (const double way : {1.0, -1.0})
        draw_arrow(figure_.marks, there(middle), there(middle + way * reach), 0.5, theme_.accent, dashed());
    label(name, there(middle + reach), std::nullopt, theme_.accent);
}
void PairPen::turn(Spot centre, double radius, double from, double to, const std::string& name) {
    std::vector<Spot> spots;
    constexpr int pieces = 24;
    for (int i = 0; i <= pieces; ++i) spots.push_back(centre + radius * polar_spot(from + (to - from) * i / pieces));
    curved(std::move(spots), name.size() == 1 ? "{" + name + "}" : name);
}
void PairPen::curved(std::vector<Spot> spots, const std::string& name) {
    spots = there(std::move(spots));
    const Spot tip = spots.back();
    // The head replaces the last pieces.
    constexpr double head = 2.8, wide = 1.0;
    std::vector<Spot> shaft = spots;
    while (shaft.size() > 2 && length(shaft.back() - tip) < head) shaft.pop_back();
    const Spot along = unit(tip - shaft.back()), foot = tip - head * along;
    figure_.marks.emplace_back(polyline(shaft, {0.5, theme_.accent, dashed(), false}));
    figure_.marks.emplace_back(filled({tip, foot + wide * turned(along), foot - wide * turned(along)}, theme_.accent));
    label(name, spots[spots.size() / 2], std::nullopt, theme_.accent);
}
void PairPen::force(Spot tail, Spot tip, const std::string& name, bool tied) {
    draw_arrow(figure_.marks, there(tail), there(tip), theme_.vector, tied ? theme_.secondary : theme_.text);
    label(name, there(0.5 * (tail + tip)), there(tip), tied ? theme_.secondary : theme_.text);
}
void PairPen::couple(Spot centre, double radius, double from, double to, const std::string& name) {
    draw_arc_arrow(figure_.marks, there(centre), larger_ * radius, from, to, theme_.vector, theme_.text);
    label(name, there(centre + radius * polar_spot(0.5 * (from + to))), std::nullopt, theme_.text);
}
void PairPen::couple_along(Spot tail, Spot tip, const std::string& name, bool tied) {
    const Colour ink = tied ? theme_.secondary : theme_.text;
    const Spot along = unit(tip - tail);
    draw_arrow(figure_.marks, there(tail), there(tip) - 1.8 * along, theme_.vector, ink);
    draw_arrow(figure_.marks, there(tail), there(tip), theme_.vector, ink);
    label(name, there(0.5 * (tail + tip)), there(tip), ink);
}
void PairPen::name(const std::string& text, Spot at) { label(text, there(at), std::nullopt, theme_.secondary); }
void PairPen::body_name(const std::string& text, Spot at, int body) {
    figure_.labels.push_back({.text = one_piece(text),
                              .size = theme_.label,
                              .colour = colour(body).letter,
                              .anchor = there(at),
                              .clearance = 2});
}

Figure PairPen::figure(Spot room) { return finished(std::move(figure_), context_, room); }

}  // namespace kinegraph::render
