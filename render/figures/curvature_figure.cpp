// The curvature of the motion of a body: pole and pole tangent with their construction lines, the inflection circle,
// Bresse's second circle and the acceleration pole, and the osculating circles of the paths of its points, to scale.
// All positions come from the Solution.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/number/functions.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "engine/solution/bindings.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/figure_table.hpp"
#include "render/figures/fit.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

using namespace drawing;
using Form = Holds::Form;

constexpr double past_ends = 6;      // mm; of a line beyond the points it joins
constexpr double shortest_arc = 16;  // mm; of an osculating circle, on each side of its point
constexpr double tick = 14;          // mm; half of a straight path

/// A position in m; empty at infinity or out of the range of doubles.
std::optional<Spot> known_spot(const Recorded<ProjectivePoint>& place) {
    if (!place || place->at_infinity()) return std::nullopt;
    return paper_spot(place->place());
}
std::optional<Spot> known_spot(const Recorded<Vector>& place) {
    if (!place) return std::nullopt;
    return paper_spot(*place);
}

bool is_near(const Box& mechanism, Spot place) {
    const double size = std::max(mechanism.width(), mechanism.height());
    return contains(grown(mechanism, 0.9 * size), place);
}

/// A circle by the ends of a diameter, m.
struct Round {
    Spot centre;
    double radius = 0;
};
Round between(Spot a, Spot b) { return {0.5 * (a + b), 0.5 * length(b - a)}; }
void include(Box& box, const Round& round) {
    box.include(round.centre - Spot{round.radius, round.radius});
    box.include(round.centre + Spot{round.radius, round.radius});
}

/// The mechanism, the inflection circle and every centre that is near.
Box extent_of_curvature(const Subject& subject, const Curvature& found) {
    Box extent = subject.box;
    const auto take = [&](std::optional<Spot> place) {
        if (place && is_near(subject.box, *place)) extent.include(*place);
    };
    // The construction needs the pole, so that it is included at a greater distance than centres.
    if (const auto pole = known_spot(found.pole); pole && contains(grown(subject.box, 1.6 * subject.size()), *pole))
        extent.include(*pole);
    take(known_spot(found.inflection_pole));
    take(known_spot(found.acceleration_pole));
    for (const PathCentre& path : found.points)
        if (!path.is_pin) take(known_spot(path.centre));
    for (const EnvelopeCentre& envelope : found.envelopes) take(known_spot(envelope.centre));
    const auto pole = known_spot(found.pole), end = known_spot(found.inflection_pole);
    if (pole && end && length(*end - *pole) < 1.5 * subject.size()) include(extent, between(*pole, *end));
    return extent;
}

class CurvatureSketch {
public:
    CurvatureSketch(Sketch& sketch, const Curvature& found, const Box& extent)
        : sketch_(sketch), found_(found), theme_(sketch.theme), colour_(sketch.theme.colour_of(found.body)) {
        view_ = {(1 / sketch.scale()) * extent.min, (1 / sketch.scale()) * extent.max};
        view_ = grown(view_, 5);
    }

    void draw() {
        draw_in_grey(sketch_);
        draw_body();
        draw_rays();
        draw_tangent();
        draw_circles();
        for (const PathCentre& path : found_.points) draw_path(path);
        for (const EnvelopeCentre& envelope : found_.envelopes) draw_envelope(envelope);
        std::swap(sketch_.construction, sketch_.over_bodies);
        draw_pole();
        name_points(sketch_);
    }

    std::vector<DrawnAxis> axes;  ///< axes of the radii in the figure

private:
    std::optional<Spot> on_paper(std::optional<Spot> place) const {
        if (!place || !std::isfinite(place->x) || !std::isfinite(place->y)) return std::nullopt;
        return (1 / sketch_.scale()) * *place;
    }
    bool shows(std::optional<Spot> spot) const { return spot && contains(view_, *spot); }
    std::string held(const std::string& what) const { return curvature_binding(found_.body, what); }
    static std::string held_of(const PathCentre& path) { return "of " + path.label; }
    void stroke(Path path, StatementIndex statement, const Holds& holds = {}) {
        sketch_.construction.emplace_back(std::move(path));
        hang(sketch_.construction, sketch_.construction.size() - 1, holds);
        belong(sketch_.construction, sketch_.construction.size() - 1, statement);
    }
    /// The part of the line through two points that is within the figure.
    void draw_line(Spot a, Spot b, const Pen& pen, StatementIndex statement, const Holds& holds = {}) {
        if (length(b - a) < same_place) return;
        const Interval seen = within(view_, a, unit(b - a));
        if (seen.from < seen.to)
            stroke(line(a + seen.from * unit(b - a), a + seen.to * unit(b - a), pen), statement, holds);
    }
    /// The segment from a to b with a short extension, within the figure.
    void draw_segment(Spot a, Spot b, const Pen& pen, StatementIndex statement, std::string from_place,
                      std::string to_place) {
        if (length(b - a) < same_place) return;
        const Spot along = unit(b - a);
        const Interval seen = within(view_, a, along);
        const double from = std::max(-past_ends, seen.from), to = std::min(length(b - a) + past_ends, seen.to);
        // Only the visible part is drawn; in another position of the mechanism the segment may be visible as a whole.
        if (from < to)
            stroke(line(a + from * along, a + to * along, pen), statement,
                   {Form::segment, {std::move(from_place), std::move(to_place)}, past_ends});
    }
    void name(RichText text, Spot at, StatementIndex statement, const std::string& place) {
        sketch_.add_label(std::move(text), theme_.text, at, 1.6, statement).holds = {Form::at, {place}};
    }
    /// For a point outside the figure: an arrow at the edge, on the line to it, with its name and its distance from
    /// where the line begins.
    void point_out(const RichText& text, Spot place, const RichText& from_name, Spot from, StatementIndex statement) {
        constexpr double head = 3;
        if (!contains(view_, from) || length(place - from) < same_place) return;
        const Spot along = unit(place - from), tip = from + within(view_, from, along).to * along;
        const std::size_t first = sketch_.construction.size();
        draw_arrow(sketch_.construction, tip - head * along, tip, theme_.thin, theme_.secondary);
        belong(sketch_.construction, first, statement);
        RichText words = text;
        append(words, how_far(sketch_, from_name, text, length(place - from)));
        sketch_.add_label(std::move(words), theme_.text, tip, 1.2, statement);
    }
    RichText point(const std::string& name) const {
        return typeset(Symbol{Symbol::Letter::point, name, ""}, sketch_.context.language);
    }
    void draw_dot(Spot at, StatementIndex statement, const std::string& place) {
        const std::size_t first = sketch_.centres.size();
        sketch_.centres.emplace_back(tinted(disc(at, 1.0, theme_.paper)));
        sketch_.centres.emplace_back(disc(at, 0.65, theme_.text));
        belong(sketch_.centres, first, statement);
        hang(sketch_.centres, first, {Form::at, {place}});
    }

    /// The body is drawn in colour over the grey mechanism.
    void draw_body() {
        const Shape& shape = sketch_.shape(found_.body);
        const std::size_t first = sketch_.bodies.size();
        for (const Bar& bar : shape.strokes)
            sketch_.bodies.emplace_back(line(bar.from, bar.to, sketch_.pen_of(found_.body, 2.5 * theme_.outline)));
        hang(sketch_.bodies, first, {Form::body, {std::to_string(found_.body.number())}});
    }

    /// Bobillier's construction: the two rays, the line through their points, the line through their centres, the axis.
    void draw_rays() {
        const auto pole = on_paper(known_spot(found_.pole));
        if (!pole || found_.rays.size() != 2) return;
        std::array<Spot, 2> points;
        std::array<std::optional<Spot>, 2> centres;
        std::array<std::string, 2> at, to;  // bindings
        for (std::size_t i = 0; i < 2; ++i) {
            const Curvature::Ray& ray = found_.rays[i];
            points[i] = *on_paper(known_spot(ray.at));
            centres[i] = on_paper(known_spot(ray.centre));
            at[i] = held("ray " + std::to_string(i));
            to[i] = held("ray centre " + std::to_string(i));
            draw_segment(*pole, points[i], sketch_.thin(), found_.pole_statement, held("pole"), at[i]);
            if (centres[i])
                draw_segment(*pole, *centres[i], sketch_.thin(), found_.pole_statement, held("pole"), to[i]);
        }
        const Pen pen{theme_.thin, theme_.secondary, dashes(), false};
        const auto meet = on_paper(known_spot(found_.axis_point));
        draw_line(points[0], points[1], pen, found_.tangent_statement, {Form::through, {at[0], at[1]}});
        if (centres[0] && centres[1])
            draw_line(*centres[0], *centres[1], pen, found_.tangent_statement, {Form::through, {to[0], to[1]}});
        if (meet) draw_line(*pole, *meet, pen, found_.tangent_statement, {Form::through, {held("pole"), held("axis")}});
        if (!meet) draw_line(*pole, *pole + unit(points[1] - points[0]), pen, found_.tangent_statement);
        if (shows(meet)) draw_dot(*meet, found_.tangent_statement, held("axis"));
        const RichText of_meet = point(free_name(sketch_.mechanism, "Q"));
        if (shows(meet)) name(of_meet, *meet, found_.tangent_statement, held("axis"));
        if (meet && !shows(meet)) point_out(of_meet, *meet, name_of_pole(), *pole, found_.tangent_statement);
    }

    void draw_tangent() {
        const auto pole = on_paper(known_spot(found_.pole)), end = on_paper(known_spot(found_.inflection_pole));
        if (!pole || !end) return;
        const Spot normal = unit(*end - *pole), along{-normal.y, normal.x};
        draw_line(*pole, *pole + along, {theme_.outline, theme_.text, dash_dot(), false}, found_.tangent_statement,
                  {Form::normal, {held("pole"), held("inflection")}});
        draw_segment(*pole, *end, sketch_.axis(), found_.inflection_statement, held("pole"), held("inflection"));
        const Interval seen = within(view_, *pole, along);
        if (!(seen.from < seen.to)) return;
        const bool ahead = seen.to > -seen.from;
        LabelRequest& label = sketch_.add_label(one_piece("t", Face::italic), theme_.text,
                                                *pole + (ahead ? 0.85 * seen.to : 0.85 * seen.from) * along, 1.2,
                                                found_.tangent_statement);
        label.toward = label.anchor + along;
        label.holds = {Form::normal, {held("pole"), held("inflection")}};
    }

    void draw_circles() {
        const auto pole = on_paper(known_spot(found_.pole)), end = on_paper(known_spot(found_.inflection_pole)),
                   second = on_paper(known_spot(found_.tangential_pole)),
                   still = on_paper(known_spot(found_.acceleration_pole));
        if (!pole || !end) return;
        const Round inflection = between(*pole, *end);
        draw_circle(inflection, {theme_.outline, theme_.accent, {}, false}, "inflection", found_.inflection_statement);
        if (shows(end)) draw_dot(*end, found_.inflection_statement, held("inflection"));
        if (shows(end) && shows(pole)) axes.push_back({kinegraph::name_of(symbol_of_diameter()), *pole, *end, ""});
        if (shows(end))
            name(point(found_.inflection_name), *end, found_.inflection_statement, held("inflection"));
        else
            point_out(point(found_.inflection_name), *end, name_of_pole(), *pole, found_.inflection_statement);
        if (second) {
            const Pen pen{theme_.outline, theme_.secondary, dashes(), false};
            draw_circle(between(*pole, *second), pen, "tangential", found_.bresse_statement);
            draw_segment(*end, *second, sketch_.thin(), found_.bresse_statement, held("inflection"),
                         held("tangential"));
            const RichText of_second = point(found_.tangential_name), of_end = point(found_.inflection_name);
            if (shows(second))
                name(of_second, *second, found_.bresse_statement, held("tangential"));
            else
                point_out(of_second, *second, of_end, *end, found_.bresse_statement);
        }
        if (!shows(still) || found_.acceleration_name == found_.inflection_name) return;
        sketch_.centres.emplace_back(ring(*still, 1.0, theme_.paper, {theme_.outline, theme_.text, {}, false}));
        belong(sketch_.centres, sketch_.centres.size() - 1, found_.bresse_statement);
        hang(sketch_.centres, sketch_.centres.size() - 1, {Form::at, {held("acceleration")}});
        name(point(found_.acceleration_name), *still, found_.bresse_statement, held("acceleration"));
    }
    /// The whole circle if it fits into the figure, otherwise its arcs.
    void draw_circle(const Round& round, const Pen& pen, const char* what, StatementIndex statement) {
        const std::size_t first = sketch_.construction.size();
        sketch_.construction.emplace_back(
            GroupBegin{what, {}, "", {}, statement, {Form::circle, {held("pole"), held(what)}}});
        draw_arcs(round, pen);
        sketch_.construction.emplace_back(GroupEnd{});
        belong(sketch_.construction, first, statement);
    }
    /// The arcs of a circle within the figure.
    void draw_arcs(const Round& round, const Pen& pen) {
        constexpr int pieces = 720;
        const auto spot = [&](int i) {
            const double angle = 2 * std::numbers::pi * i / pieces;
            return round.centre + round.radius * Spot{nearest::cos(angle), nearest::sin(angle)};
        };
        int outside = -1;
        for (int i = 0; i < pieces && outside < 0; ++i)
            if (!contains(view_, spot(i))) outside = i;
        if (outside < 0) {
            sketch_.construction.emplace_back(circle(round.centre, round.radius, pen));
            return;
        }
        int start = -1;
        for (int i = outside; i <= outside + pieces; ++i) {
            const bool inside = contains(view_, spot(i));
            if (inside && start < 0) start = i;
            if (inside || start < 0) continue;
            if (i - 1 > start)
                sketch_.construction.emplace_back(arc(round.centre, round.radius, 2 * std::numbers::pi * start / pieces,
                                                      2 * std::numbers::pi * (i - 1) / pieces, pen));
            start = -1;
        }
    }

    void draw_path(const PathCentre& path) {
        const auto pole = on_paper(known_spot(found_.pole));
        if (path.is_pin || !path.centre) return;
        const Spot at = sketch_.spot(path.point);
        if (path.centre->at_infinity()) {
            const Spot ray = paper_direction(path.centre->place()), along{-ray.y, ray.x};
            if (pole) draw_segment(*pole, at, sketch_.thin(), path.statement, held("pole"), point_binding(path.point));
            stroke(line(at - tick * along, at + tick * along, {theme_.outline, colour_.line, {}, false}),
                   path.statement);
            return;
        }
        const auto centre = on_paper(known_spot(path.centre));
        if (!centre) return;
        const std::string here = point_binding(path.point), about = held(held_of(path));
        if (pole) draw_segment(*pole, at, sketch_.thin(), path.statement, held("pole"), here);
        draw_segment(at, *centre, sketch_.thin(), path.statement, here, about);
        draw_osculating(path, at, *centre);
        if (shows(centre)) {
            draw_dot(*centre, path.statement, about);
            name(point(path.name), *centre, path.statement, about);
            axes.push_back({kinegraph::name_of(symbol_of(path)), at, *centre, ""});
        }
    }
    Symbol symbol_of_diameter() const {
        return {Symbol::Letter::diameter, sketch_.mechanism.body(found_.body).name, ""};
    }
    static Symbol symbol_of(const PathCentre& path) { return {Symbol::Letter::radius, path.label, ""}; }

    /// An arc about the point: a quarter of the circle, with a minimum length.
    void draw_osculating(const PathCentre& path, Spot at, Spot centre) {
        const double radius = length(at - centre), value = radius * sketch_.scale();
        const Unit& unit_of = sketch_.mechanism.units.length;
        const Pen pen{1.4 * theme_.outline, colour_.line, {}, false};
        const std::size_t first = sketch_.construction.size();
        const Holds holds{Form::arc, {held(held_of(path)), point_binding(path.point)}};
        sketch_.construction.emplace_back(GroupBegin{"osculating",
                                                     sketch_.id("osculating", path.label),
                                                     "",
                                                     {{"data-name", path.label},
                                                      {"data-value", shortest(value / unit_of.si.to_double())},
                                                      {"data-unit", unit_of.symbol}},
                                                     path.statement,
                                                     holds});
        const bool whole =
            contains(view_, centre - Spot{radius, radius}) && contains(view_, centre + Spot{radius, radius});
        const double half = std::min(std::numbers::pi, std::max(shortest_arc / radius, 0.4)),
                     towards = nearest::atan2(at.y - centre.y, at.x - centre.x);
        if (whole)
            sketch_.construction.emplace_back(circle(centre, radius, pen));
        else
            sketch_.construction.emplace_back(arc(centre, radius, towards - half, towards + half, pen));
        sketch_.construction.emplace_back(GroupEnd{});
        belong(sketch_.construction, first, path.statement);
        RichText text = typeset(symbol_of(path), sketch_.context.language);
        append(text, with_powers(" = " + number(value / unit_of.si.to_double(), 4, sketch_.context.language) + " " +
                                 unit_of.symbol));
        LabelRequest& label = sketch_.add_label(std::move(text), colour_.letter, at, 1.4, path.statement);
        const double aside = towards + (whole ? 0.6 : 0.7 * half);
        label.anchor = centre + radius * Spot{nearest::cos(aside), nearest::sin(aside)};
        label.holds = holds;
        label.holds.unit = unit_of.si.to_double();
    }

    /// The foot on the line, and the centre beyond the pole.
    void draw_envelope(const EnvelopeCentre& envelope) {
        const auto touches = on_paper(known_spot(envelope.touches)), centre = on_paper(known_spot(envelope.centre));
        if (!touches || !centre) return;
        const std::string joint = std::to_string(envelope.joint.number()), about = held("envelope " + joint);
        draw_segment(*touches, *centre, sketch_.thin(), envelope.statement, held("touches " + joint), about);
        if (!shows(centre)) return;
        draw_dot(*centre, envelope.statement, about);
        name(point(envelope.name), *centre, envelope.statement, about);
    }

    void draw_pole() {
        const auto pole = on_paper(known_spot(found_.pole));
        if (!shows(pole)) return;
        draw_dot(*pole, found_.pole_statement, held("pole"));
        name(name_of_pole(), *pole, found_.pole_statement, held("pole"));
    }
    RichText name_of_pole() const {
        return typeset(centre_symbol(sketch_.mechanism, frame, found_.body, false), sketch_.context.language);
    }

    Sketch& sketch_;
    const Curvature& found_;
    const Theme& theme_;
    BodyColour colour_;
    Box view_;  ///< mm
};

}  // namespace

namespace {

/// False if the body only turns about a point at rest.
bool has_curvature_figure(const Curvature& found) {
    const auto is_free = [](const PathCentre& path) {
        return !path.is_pin && path.centre && !path.centre->at_infinity();
    };
    return found.kind == Curvature::Kind::general || (found.kind == Curvature::Kind::translation &&
                                                      std::any_of(found.points.begin(), found.points.end(), is_free));
}

}  // namespace

Figure curvature_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y,
                        const ScaleWish& wish) {
    const Curvature& found = context.solution.curvature[index];
    const Subject subject(context.solution);
    const Mechanism& mechanism = subject.mechanism;
    const Box extent = extent_of_curvature(subject, found);
    const double first = choose_scale(extent.width(), extent.height(), std::max(room_x - 24, 10.0),
                                      std::max(room_y - 30, 10.0), std::nullopt);
    const FitPolicy policy{.room = Spot{room_x, room_y},
                           .first = std::max(first, wish.finest),
                           .asked = wish.asked,
                           .strict = wish.strict,
                           .exactly = wish.exactly,
                           .names_stay_in_room = true};
    const Figure blank = begun(context, {FigureKind::curvature, static_cast<int>(index)});
    return fit(policy, [&](const Trial& trial) {
        Sketch sketch(subject, context, trial.scale, blank.id);
        CurvatureSketch drawn(sketch, found, extent);
        drawn.draw();
        Figure figure = sketch.finish(blank, "m");
        figure.caption.back().text += " " + mechanism.body(found.body).name;
        figure.axes = std::move(drawn.axes);
        sketch.close(figure, {room_x, room_y}, trial.last, trial.scale, mechanism.units.length, trial.strict);
        return figure;
    });
}

namespace {

std::vector<int> curvatures(const Shown& shown, const LoadCase& /*all*/) {
    const std::vector<Curvature>& all = shown.solution().curvature;
    std::vector<int> found;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (has_curvature_figure(all[i])) found.push_back(static_cast<int>(i));
    return found;
}
void measure_curvature(const Shown& shown, FigureId id, SizeWanted& size) {
    size.take(extent_of_curvature(Subject(shown.solution()), shown.solution().curvature[at_index(id.of)]));
}
Figure draw_curvature(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    return curvature_figure(shown.context, at_index(id.of), room.x, room.y, wish);
}

}  // namespace

constinit const FigureFunctions curvature_functions{curvatures, measure_curvature, draw_curvature};

}  // namespace kinegraph::render
