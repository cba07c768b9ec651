// The loops on the mechanism: each side as a vector, head to tail, with its letter and its angle.
#include <algorithm>
#include <cmath>
#include <set>

#include "engine/equations/equations.hpp"
#include "engine/equations/equations_values.hpp"
#include "engine/solution/bindings.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/figure_table.hpp"
#include "render/figures/fit.hpp"
#include "render/mechanism/symbols.hpp"
#include "render/page/shapes.hpp"
#include "render/text/math.hpp"

namespace kinegraph::render {

using namespace drawing;

namespace {

using Side = Equations::Side;

/// Each vector once, even if several loops share it.
std::vector<Side> sides_of(const Equations& equations) {
    std::vector<Side> all;
    const auto add = [&](const std::vector<Side>& sides) {
        for (const Side& side : sides) {
            const bool known =
                std::any_of(all.begin(), all.end(), [&](const Side& each) { return each.length == side.length; });
            if (!known) all.push_back(side);
        }
    };
    for (const Equations::Loop& loop : equations.loops) add(loop.sides);
    for (const Equations::Reach& reach : equations.reaches) add(reach.sides);
    return all;
}

RichText text_of(const Equations::Letter& letter) {
    Piece piece;
    piece.text = unicode_letter(letter.symbol);
    piece.face = Face::italic;
    piece.sub = letter.sub;
    piece.sub_face = Face::regular;
    return {piece};
}
RichText text_of(const Equations& equations, const Equations::Angle& angle) {
    RichText text;
    for (const Equations::LetterIndex letter : angle.letters) {
        if (!text.empty()) append(text, one_piece("\u2009+\u2009"));
        append(text, text_of(equations.letter(letter)));
    }
    return text;
}

/// What the marks of a side move with, if bodies carry both of its ends.
struct HeldSide {
    std::string from, to;
    explicit operator bool() const { return !from.empty(); }
    Holds arrow() const { return from.empty() ? Holds{} : arrow_between(from, to); }
    Holds angle(double radius) const { return from.empty() ? Holds{} : Holds{Holds::Form::arc, {from, to}, radius}; }
};
/// The slide of a guide, or a link that replaces a contact, leads from a place of one body to a place of another; any
/// other side is a body's own. Where an offset varies too, its foot is no body's place.
HeldSide held_by(const Equations& equations, const Side& side) {
    const Equations::Letter& letter = equations.letter(side.body == none ? side.angle.letters.front() : side.length);
    if (letter.joint == none && side.body == none) return {};
    if (letter.joint == none) return {place_binding(side.body, side.from), place_binding(side.body, side.to)};
    const auto varies = std::count_if(equations.letters.begin(), equations.letters.end(), [&](const auto& each) {
        return !each.is_angle && each.joint == letter.joint && each.body == letter.body;
    });
    if (varies > 1 || letter.body == none || letter.against == none) return {};
    return {place_binding(letter.against, side.from), place_binding(letter.body, side.to)};
}

/// An arc from a thin ray along +x to the side. On paper counter-clockwise is the negative sense.
void draw_angle(Sketch& sketch, const Equations& equations, const Side& side, Spot tail, double longest, Colour colour,
                double shrink) {
    const HeldSide ends = held_by(equations, side);
    const double angle = value_of(equations, side.angle);
    constexpr double widest = 8, least = 3.5, beyond = 2.5;
    const double radius = std::clamp(0.3 * longest, least, widest) * shrink;
    sketch.construction.emplace_back(line(tail, tail + Spot{radius + beyond, 0}, sketch.thin()));
    const std::size_t first = sketch.arrows.size();
    draw_arc_arrow(sketch.arrows, tail, radius, 0, -angle, sketch.theme.thin, colour);
    const Holds held = ends.angle(radius);
    hang(sketch.arrows, first, held);
    LabelRequest& label =
        sketch.add_label(text_of(equations, side.angle), colour, tail + radius * polar_spot(-angle / 2), 0.8);
    if (!ends) return;
    hang(sketch.construction, sketch.construction.size() - 1, {Holds::Form::at, {ends.from}});
    label.holds = held;
}

void draw_side(Sketch& sketch, const Equations& equations, const Side& side, std::set<std::string>& angles,
               std::vector<Spot>& tails) {
    const Spot tail = sketch.spot(side.from), tip = sketch.spot(side.to);
    const BodyColour colour = sketch.theme.colour_of(side.body);
    const std::string name = spelt(equations.letter(side.length));
    sketch.arrows.emplace_back(
        GroupBegin{"side",
                   sketch.id("side", name),
                   name,
                   {{"data-name", name}, {"data-value", shortest(equations.letter(side.length).value)}},
                   none,
                   held_by(equations, side).arrow()});
    if (!coincide(tail, tip)) draw_arrow(sketch.arrows, tail, tip, sketch.theme.vector, colour.line);
    sketch.arrows.emplace_back(GroupEnd{});
    LabelRequest& label =
        sketch.add_label(text_of(equations.letter(side.length)), colour.letter, middle(Bar{tail, tip}), 1.3);
    label.size = sketch.theme.equation;
    label.holds = held_by(equations, side).arrow();
    if (!coincide(tail, tip)) label.toward = tip;
    if (side.angle.letters.empty() || length(tip - tail) < 4 ||
        !angles.insert(plain(text_of(equations, side.angle))).second)
        return;
    // Angles at the same point have different radii.
    const auto before = std::count_if(tails.begin(), tails.end(), [&](Spot each) { return coincide(each, tail); });
    tails.push_back(tail);
    draw_angle(sketch, equations, side, tail, length(tip - tail), colour.letter,
               1 + 0.45 * static_cast<double>(before));
}

Box extent_of_loops(const Solution& solution) {
    Box extent = Subject(solution).box;
    for (const Side& side : sides_of(*solution.equations))
        for (const Vector& place : {side.from, side.to}) extent.include(paper_spot(place));
    return extent;
}

}  // namespace

Figure loops_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish) {
    const Equations& equations = *context.solution.equations;
    Subject subject(context.solution);
    subject.box = extent_of_loops(context.solution);
    const std::vector<Side> sides = sides_of(equations);
    const double first = choose_scale(subject.box.width(), subject.box.height(), std::max(room_x - 14, 10.0),
                                      std::max(room_y - 22, 10.0), std::nullopt);
    const FitPolicy policy{.room = Spot{room_x, room_y},
                           .first = std::max(first, wish.finest),
                           .asked = wish.asked,
                           .strict = wish.strict,
                           .exactly = wish.exactly,
                           .names_stay_in_room = true};
    return fit(policy, [&](const Trial& trial) {
        Sketch sketch(subject, context, trial.scale, "loops");
        draw_in_grey(sketch);
        std::set<std::string> angles;
        std::vector<Spot> tails;
        for (const Side& side : sides) draw_side(sketch, equations, side, angles, tails);
        name_points(sketch);
        Figure figure = sketch.finish(begun(context, {FigureKind::loops}), "m");
        sketch.close(figure, {room_x, room_y}, trial.last, trial.scale, subject.mechanism.units.length, trial.strict);
        return figure;
    });
}

namespace {

std::vector<int> has_loops(const Shown& shown, const LoadCase& /*all*/) {
    return once(shown.solution().equations && !sides_of(*shown.solution().equations).empty());
}
void measure_loops(const Shown& shown, FigureId /*one*/, SizeWanted& size) {
    size.take(extent_of_loops(shown.solution()));
}
Figure draw_loops(const Shown& shown, FigureId /*one*/, Spot room, const ScaleWish& wish) {
    return loops_figure(shown.context, room.x, room.y, wish);
}

}  // namespace

constinit const FigureFunctions loops_functions{has_loops, measure_loops, draw_loops};

}  // namespace kinegraph::render
