// The parts of a relative motion: the moving axes on the mechanism in grey; at the point the relative velocity with its
// components along them; and Coriolis' term, which has the direction of v_rel turned with ω.
#include <algorithm>
#include <cmath>

#include "engine/solution/bindings.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/figure_table.hpp"
#include "render/figures/fit.hpp"
#include "render/mechanism/symbols.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {

using namespace drawing;

namespace {

using Apart = RelativeMotion::Apart;

RichText letter(const char* text, const std::string& superscript, const std::string& sub) {
    Piece piece;
    piece.text = text;
    piece.face = Face::bold_italic;
    piece.sub = sub;
    piece.sup = superscript;
    return {piece};
}

/// The axes O′x′y′, as long as there is space.
void draw_axes(Sketch& sketch, const Apart& apart, BodyIndex observer, Spot along) {
    const Spot at = sketch.spot(apart.origin), across{along.y, -along.x};  // y downwards: counter-clockwise on paper
    const double reach = std::clamp(0.3 * sketch.size(), 12.0, 26.0);
    const Colour colour = sketch.theme.colour_of(observer).letter;
    // Without a second point the axes keep their directions.
    const std::string origin = point_binding(apart.origin);
    const Holds held = apart.towards == none ? Holds{Holds::Form::at, {origin}}
                                             : Holds{Holds::Form::with, {origin, origin, point_binding(apart.towards)}};
    const auto axis = [&](Spot direction, const char* name) {
        sketch.arrows.emplace_back(
            GroupBegin{"axis", sketch.id("axis", name), name, {{"data-name", name}}, none, held});
        draw_arrow(sketch.arrows, at, at + reach * direction, sketch.theme.outline, colour);
        sketch.arrows.emplace_back(GroupEnd{});
        sketch.add_label(one_piece(name, Face::italic), colour, at + reach * direction, 1.2).holds = held;
    };
    axis(along, "x′");
    axis(across, "y′");
}

/// The scale of a vector: value for each mm. And the names that it has in the record.
struct VectorScale {
    double per_millimetre;
    const char* unit;
    std::string held;
};

/// A vector at a point, with its two components dashed.
void draw_letter_vector(Sketch& sketch, const RichText& text, const std::string& name, Spot at, Spot along, Spot across,
                        double value, const VectorScale& scale, PointIndex point, Colour colour) {
    const Spot tip = at + along + across;
    if (coincide(at, tip)) return;
    const std::string from = point_binding(point);
    const auto to = [&](const char* part) {
        return tip_binding(from, scale.held + part, scale.per_millimetre / sketch.scale());
    };
    if (length(along) > 1 && length(across) > 1) {
        const Pen pen{sketch.theme.thin, colour, dashes(), false};
        const auto side = [&](Spot a, Spot b, std::string held_a, std::string held_b) {
            Path stroke = line(a, b, pen);
            stroke.holds = {Holds::Form::segment, {std::move(held_a), std::move(held_b)}};
            sketch.construction.emplace_back(std::move(stroke));
        };
        side(at, at + along, from, to(" along"));
        side(at + along, tip, to(" along"), to(""));
        side(at, at + across, from, to(" across"));
        side(at + across, tip, to(" across"), to(""));
    }
    const Holds held = arrow_between(from, to(""));
    sketch.arrows.emplace_back(GroupBegin{"vector",
                                          sketch.id("", name),
                                          plain(text),
                                          {{"data-name", name},
                                           {"data-value", shortest(value)},
                                           {"data-scale", shortest(scale.per_millimetre)},
                                           {"data-unit", scale.unit}},
                                          none,
                                          held});
    sketch.arrows.emplace_back(Axis{at, tip});
    draw_arrow(sketch.arrows, at, tip, sketch.theme.vector, colour);
    sketch.arrows.emplace_back(GroupEnd{});
    LabelRequest& label = sketch.add_label(text, colour, middle(Bar{at, tip}), 1.4);
    label.size = sketch.theme.equation;
    label.toward = tip;
    label.holds = held;
}

/// The sense of ω: a quarter turn from v_rel to Coriolis' term.
void draw_turning_sense(Sketch& sketch, const RelativeMotion& motion, Spot at, Spot v) {
    if (motion.apart->no_coriolis != Apart::NoCoriolis::there_is || length(v) < 5) return;
    const bool counter_clockwise = motion.apart->omega->sign() > 0;
    const double from = angle_of(v), radius = std::min(0.45 * length(v), 7.0);
    constexpr double quarter = 1.5707963267948966, margin = 0.12;
    const double turn = counter_clockwise ? -1 : 1;
    const Colour colour = sketch.theme.colour_of(motion.query.observer).letter;
    draw_arc_arrow(sketch.arrows, at, radius, from + turn * margin, from + turn * (quarter - margin), sketch.theme.thin,
                   colour);
    sketch.add_label(typeset(Symbol{Symbol::Letter::omega, sketch.mechanism.body(motion.query.observer).name, ""},
                             sketch.context.language),
                     colour, at + radius * polar_spot(from + turn * quarter / 2), 0.9);
}

void draw_seen(Sketch& sketch, const RelativeMotion& motion, std::size_t index, double velocity_scale,
               double acceleration_scale) {
    const Apart& apart = *motion.apart;
    const Notation& own_notation = notation(sketch.context.language);
    const Spot at = sketch.spot(motion.query.point);
    const auto on_paper = [](const Vector& v, double scale) { return (1 / scale) * paper_spot(v); };
    const Colour dark = sketch.theme.text, own = sketch.theme.colour_of(motion.query.observer).letter;
    const Spot v = on_paper(*motion.relative_velocity, velocity_scale);
    const PointIndex point = motion.query.point;
    const VectorScale speeds{velocity_scale, "m/s", relative_binding(index, "v")},
        rates_of_change{acceleration_scale, "m/s²", relative_binding(index, "a")},
        of_turning{acceleration_scale, "m/s²", relative_binding(index, "cor")};
    draw_letter_vector(sketch, letter("v", own_notation.relative, sketch.mechanism.point(motion.query.point).name),
                       "v_rel", at, on_paper(*apart.velocity_along, velocity_scale),
                       on_paper(*apart.velocity_across, velocity_scale), length(*motion.relative_velocity), speeds,
                       point, dark);
    draw_letter_vector(sketch, letter("a", own_notation.relative, sketch.mechanism.point(motion.query.point).name),
                       "a_rel", at, on_paper(*apart.acceleration_along, acceleration_scale),
                       on_paper(*apart.acceleration_across, acceleration_scale), length(*motion.relative_acceleration),
                       rates_of_change, point, sketch.theme.secondary);
    if (apart.no_coriolis != Apart::NoCoriolis::there_is) return;
    draw_letter_vector(sketch, letter("a", own_notation.coriolis, sketch.mechanism.point(motion.query.point).name),
                       "a_cor", at, on_paper(*motion.coriolis, acceleration_scale), Spot{0, 0},
                       length(*motion.coriolis), of_turning, point, own);
    draw_turning_sense(sketch, motion, at, v);
}

}  // namespace

bool has_moving_axes(const RelativeMotion& motion) { return motion.apart.has_value(); }

Figure moving_axes_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y,
                          const ScaleWish& wish) {
    const Solution& solution = context.solution;
    const RelativeMotion& motion = solution.relative_motion[index];
    const Apart& apart = *motion.apart;
    const Subject subject(solution);
    const Spot along = apart.towards == none
                           ? Spot{1, 0}
                           : unit(paper_spot(solution.pose.at(apart.towards) - solution.pose.at(apart.origin)));
    const double speed = length(*motion.relative_velocity),
                 acceleration = std::max(length(*motion.relative_acceleration), length(*motion.coriolis));
    const double first = choose_scale(subject.box.width(), subject.box.height(), std::max(room_x - 30, 10.0),
                                      std::max(room_y - 36, 10.0), std::nullopt);
    const FitPolicy policy{.room = Spot{room_x, room_y},
                           .first = std::max(first, wish.finest),
                           .asked = wish.asked,
                           .strict = wish.strict,
                           .exactly = wish.exactly,
                           .names_stay_in_room = true};
    const Figure blank = begun(context, {FigureKind::moving_axes, static_cast<int>(index)});
    return fit(policy, [&](const Trial& trial) {
        Sketch sketch(subject, context, trial.scale, blank.id);
        draw_in_grey(sketch);
        const double reach = std::clamp(0.35 * sketch.size(), 12.0, 32.0);
        const double velocity_scale = speed > 0 ? choose_scale(speed, 0, reach, reach, std::nullopt) : 1;
        const double acceleration_scale =
            acceleration > 0 ? choose_scale(acceleration, 0, reach, reach, std::nullopt) : 1;
        draw_axes(sketch, apart, motion.query.observer, along);
        draw_seen(sketch, motion, index, velocity_scale, acceleration_scale);
        name_points(sketch);
        Figure figure = sketch.finish(blank, "m/s");
        figure.scale = velocity_scale;
        figure.has_scale = speed > 0;
        if (acceleration > 0)
            figure.further_scale = "1 mm ≙ " + shortest(acceleration_scale, context.language) + " m/s²";
        figure.caption.back().text += " " + solution.mechanism.body(motion.query.observer).name;
        sketch.close(figure, {room_x, room_y}, trial.last, trial.scale, solution.mechanism.units.length, trial.strict);
        return figure;
    });
}

namespace {

std::vector<int> axes_of(const Shown& shown, const LoadCase& /*all*/) {
    const std::vector<RelativeMotion>& all = shown.solution().relative_motion;
    std::vector<int> found;
    for (std::size_t i = 0; !shown.is_brief && i < all.size(); ++i)
        if (has_moving_axes(all[i])) found.push_back(static_cast<int>(i));
    return found;
}
void measure_axes(const Shown& shown, FigureId id, SizeWanted& size) {
    measure_mechanism(shown, id, size);
    size.least = 32;
}
Figure draw_moving_axes(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    return moving_axes_figure(shown.context, at_index(id.of), room.x, room.y, wish);
}

}  // namespace

constinit const FigureFunctions moving_axes_functions{axes_of, measure_axes, draw_moving_axes};

}  // namespace kinegraph::render
