// Virtual displacements: the mechanism in grey with all forces, and an arrow for the displacement of each moving point,
// proportional to the displacement of the one free coordinate.
#include <algorithm>
#include <cmath>

#include "engine/solution/bindings.hpp"
#include "engine/solution/displacements.hpp"
#include "lang/keys/sheet.hpp"
#include "render/equations/chapters.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/figure_table.hpp"
#include "render/figures/fit.hpp"
#include "render/mechanism/symbols.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {

using namespace drawing;

namespace {

const Displacements::Freedom& freedom_of(const Solution& solution, std::size_t index) {
    return solution.displacements->freedoms[index];
}

/// A moving point, in the colour of the first body that carries it.
struct DisplacedPoint {
    std::string name;
    PointIndex point;
    BodyIndex body;
    Vector displacement;
};
std::vector<DisplacedPoint> shown_displacements(const Solution& moved) {
    std::vector<DisplacedPoint> shown;
    for (const PointMotion& motion : moved.points) {
        if (motion.point == none || !motion.velocity || motion.velocity->is_zero()) continue;
        const auto body =
            std::find_if(motion.bodies.begin(), motion.bodies.end(), [](BodyIndex each) { return each > frame; });
        if (body == motion.bodies.end()) continue;
        shown.push_back({motion.label.empty() ? moved.mechanism.point(motion.point).name : motion.label, motion.point,
                         *body, *motion.velocity});
    }
    return shown;
}

void draw_displacement(Sketch& sketch, const DisplacedPoint& shown, std::size_t freedom, double scale) {
    const Spot at = sketch.spot(shown.point), way = paper_spot(shown.displacement);
    const Spot tip = at + Spot{way.x / scale, way.y / scale};
    if (coincide(at, tip)) return;
    RichText text = typeset(Symbol{Symbol::Letter::v, shown.name, ""}, sketch.context.language);
    if (!text.empty()) text.front().text = "δr";
    const BodyColour colour = sketch.theme.colour_of(shown.body);
    const std::string name = "delta r_" + shown.name;
    const Holds held =
        arrow_between(point_binding(shown.point), displaced_binding(shown.point, freedom, scale / sketch.scale()));
    sketch.arrows.emplace_back(GroupBegin{"displacement",
                                          sketch.id("", name),
                                          plain(text),
                                          {{"data-name", name}, {"data-value", shortest(length(shown.displacement))}},
                                          none,
                                          held});
    draw_arrow(sketch.arrows, at, tip, sketch.theme.vector, colour.line);
    sketch.arrows.emplace_back(GroupEnd{});
    LabelRequest& label = sketch.add_label(text, colour.letter, middle(Bar{at, tip}), 1.4);
    label.size = sketch.theme.equation;
    label.toward = tip;
    label.holds = held;
}

/// The place about which a turn is drawn: the pivot of a body that turns about the frame, otherwise its middle.
struct Pivot {
    Spot at;
    Holds held;
};
Pivot pivot_of(const Sketch& sketch, BodyIndex body) {
    for (const Joint& joint : sketch.mechanism.joints)
        if (is_fixed_pin(joint) && joint.connects(body))
            return {sketch.spot(joint), {Holds::Form::at, {point_binding(joint.point)}}};
    const Spot middle = sketch.shape(body).middle;
    const Vector place{Exact::from_double(middle.x * sketch.scale()), Exact::from_double(-middle.y * sketch.scale())};
    return {middle, {Holds::Form::at, {place_binding(body, place)}}};
}

/// All actions have the same length in mm; their values are in the table.
constexpr double acting = 13;  // mm

void draw_force(Sketch& sketch, const Symbol& symbol, Spot at, Spot along, const Holds& held) {
    const Spot tail = at - acting * along;
    const std::string name = name_of(symbol);
    sketch.arrows.emplace_back(GroupBegin{"force", sketch.id("", name), name, {{"data-name", name}}, none, held});
    draw_arrow(sketch.arrows, tail, at, sketch.theme.vector, sketch.theme.text);
    sketch.arrows.emplace_back(GroupEnd{});
    LabelRequest& label =
        sketch.add_label(typeset(symbol, sketch.context.language), sketch.theme.text, middle(Bar{tail, at}), 1.4);
    label.size = sketch.theme.equation;
    label.toward = tail;
    label.holds = held;
}
void draw_turn(Sketch& sketch, RichText text, const Pivot& pivot, bool counter_clockwise, double radius,
               Colour colour) {
    const Spot at = pivot.at;
    const std::size_t first = sketch.arrows.size();

    constexpr double from = -0.5, by = 1.7;
    draw_arc_arrow(sketch.arrows, at, radius, counter_clockwise ? -from : from - by,
                   counter_clockwise ? -from - by : from, sketch.theme.outline, colour);
    hang(sketch.arrows, first, pivot.held);
    sketch
        .add_label(std::move(text), colour,
                   at + radius * polar_spot(counter_clockwise ? -from - by / 2 : from - by / 2), 1.2)
        .holds = pivot.held;
}

/// A balancing force at its point, along its line.
Holds along_bearing(const ForceEffort& effort) {
    const std::string at = point_binding(effort.at);
    const auto* ends = std::get_if<Bearing::Between>(&effort.along.form);
    if (ends == nullptr) return {Holds::Form::at, {at}};
    return {Holds::Form::with, {at, point_binding(ends->from), point_binding(ends->to)}};
}

/// The actions in their directions; an input force or couple as a unit.
void draw_actions(Sketch& sketch, const Solution& moved) {
    for (const VirtualWork::Entry& entry : moved.virtual_work->entries) {
        if (!entry.force.is_zero()) {
            draw_force(sketch, entry.symbol, sketch.spot(entry.at), unit(paper_spot(entry.force)),
                       {Holds::Form::with, {place_binding(entry.body, entry.at), work_binding(entry)}});
        } else if (!entry.couple.is_zero()) {
            draw_turn(sketch, typeset(entry.symbol, sketch.context.language), pivot_of(sketch, entry.body),
                      entry.couple.sign() > 0, 9, sketch.theme.text);
        }
    }
    for (const Effort& effort : moved.mechanism.efforts) {
        if (const auto* couple = std::get_if<CoupleEffort>(&effort)) {
            draw_turn(sketch, typeset(Symbol{Symbol::Letter::M, couple->name, {}}, sketch.context.language),
                      pivot_of(sketch, couple->body), true, 12, sketch.theme.text);
        } else if (const auto* force = std::get_if<ForceEffort>(&effort)) {
            draw_force(sketch, {Symbol::Letter::F, force->name, {}}, sketch.spot(force->at),
                       unit(paper_spot(direction_of(force->along, moved.pose))), along_bearing(*force));
        } else {
            const auto& actuator = std::get<ActuatorEffort>(effort);
            draw_force(sketch, {Symbol::Letter::F, actuator.name, {}},
                       sketch.spot(moved.mechanism.joint(actuator.joint)),
                       unit(paper_spot(moved.pose.guide_units[at_index(actuator.joint)])),
                       {Holds::Form::with,
                        {point_binding(moved.mechanism.joint(actuator.joint).point), guide_binding(actuator.joint)}});
        }
    }
}

Unit unit_of(const Displacements::Freedom& freedom, const Units& units) {
    if (is_turn(freedom.driver)) return {units.length.symbol + "/rad", units.length.si};
    return {units.length.symbol + "/" + units.length.symbol, 1};
}

}  // namespace

Figure displacement_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y,
                           const ScaleWish& wish) {
    const Displacements::Freedom& freedom = freedom_of(context.solution, index);
    const Solution& moved = *freedom.moved;
    const DrawingContext displaced{moved, context.theme, context.fonts, context.language, context.dimensions};
    const Subject subject(moved);
    const std::vector<DisplacedPoint> shown = shown_displacements(moved);
    double longest = 0;
    for (const DisplacedPoint& each : shown) longest = std::max(longest, length(each.displacement));
    const Unit unit = unit_of(freedom, moved.mechanism.units);
    const double first = choose_scale(subject.box.width(), subject.box.height(), std::max(room_x - 30, 10.0),
                                      std::max(room_y - 36, 10.0), std::nullopt);
    const FitPolicy policy{.room = Spot{room_x, room_y},
                           .first = std::max(first, wish.finest),
                           .asked = wish.asked,
                           .strict = wish.strict,
                           .exactly = wish.exactly,
                           .names_stay_in_room = true};
    const Figure blank = begun(context, {FigureKind::displacements, static_cast<int>(index)});
    return fit(policy, [&](const Trial& trial) {
        Sketch sketch(subject, displaced, trial.scale, blank.id);
        draw_in_grey(sketch);
        const double reach = std::clamp(0.4 * sketch.size(), 12.0, 40.0);
        const double scale = choose_scale(longest, 0, reach, reach, std::nullopt);
        for (const DisplacedPoint& each : shown) draw_displacement(sketch, each, index, scale);
        draw_actions(sketch, moved);
        if (const auto* spin = std::get_if<SpinDriver>(&freedom.driver))
            draw_turn(sketch, displaced_coordinate(moved.mechanism, freedom.driver), pivot_of(sketch, spin->body), true,
                      6, sketch.theme.colour_of(spin->body).letter);
        name_points(sketch);
        Figure figure = sketch.finish(blank, is_turn(freedom.driver) ? "m/rad" : "m/m");
        figure.scale = scale;
        append(figure.caption, one_piece(" "));
        append(figure.caption, displaced_coordinate(moved.mechanism, freedom.driver));
        sketch.close(figure, {room_x, room_y}, trial.last, scale, unit, trial.strict);
        return figure;
    });
}

namespace {

std::vector<int> freedoms(const Shown& shown, const LoadCase& /*all*/) {
    const auto& displacements = shown.solution().displacements;
    std::vector<int> found;
    for (std::size_t i = 0; displacements && i < displacements->freedoms.size(); ++i)
        found.push_back(static_cast<int>(i));
    return found;
}
void measure_displacements(const Shown& shown, FigureId id, SizeWanted& size) {
    measure_mechanism(shown, id, size);
    size.least = 48;
}
Figure draw_displacements(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    return displacement_figure(shown.context, at_index(id.of), room.x, room.y, wish);
}

}  // namespace

constinit const FigureFunctions displacements_functions{freedoms, measure_displacements, draw_displacements};

}  // namespace kinegraph::render
