// The mechanism to scale, and the velocities on it. Owns the layers, the scale and the use of the room; all positions
// come from the Solution.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "engine/sentences/result_catalogue.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/figure_table.hpp"
#include "render/figures/fit.hpp"
#include "render/figures/plot_figure.hpp"
#include "render/mechanism/near_places.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/drawn_by.hpp"

namespace kinegraph::render {

using namespace drawing;

namespace {

/// Optional content of a mechanism figure.
struct Shows {
    bool centres = false;
    MotionWish arrows{};
    const std::vector<Way>* ways = nullptr;
    Box without_ways{};  ///< extent of the mechanism alone, m; only with ways
};

/// On paper, at a scale in m per mm.
std::vector<Spot> spots_of(const Way& way, double scale) {
    std::vector<Spot> spots;
    for (const auto& place : way.places) spots.push_back({place.x / scale, -place.y / scale});
    return spots;
}

/// The pieces of a polyline within a box.
std::vector<std::vector<Spot>> pieces_within(const Box& box, const std::vector<Spot>& spots) {
    std::vector<std::vector<Spot>> pieces(1);
    for (std::size_t i = 0; i + 1 < spots.size(); ++i) {
        const double whole = length(spots[i + 1] - spots[i]);
        if (!(whole > 0)) continue;
        const Spot along = unit(spots[i + 1] - spots[i]);
        const Interval seen = within(box, spots[i], along);
        const double from = std::max(seen.from, 0.0), to = std::min(seen.to, whole);
        if (!(from < to)) continue;
        if (from > 0 && !pieces.back().empty()) pieces.emplace_back();
        if (pieces.back().empty()) pieces.back().push_back(spots[i] + from * along);
        pieces.back().push_back(spots[i] + to * along);
        if (to < whole) pieces.emplace_back();
    }
    if (pieces.back().empty()) pieces.pop_back();
    return pieces;
}

/// The area in which a centrode is drawn; smaller if it extends to infinity.
Box room_of(const Way& way, const Box& mechanism) {
    const double share = way.comes_from_infinity || way.goes_to_infinity ? 0.45 : 1.5;
    return grown(mechanism, share * std::max(mechanism.width(), mechanism.height()));
}

/// The fixed centrode is solid, the moving one dashed, with an arrow where it goes to infinity. The pole is a dot with
/// its name. `ends`: positions of the arrows drawn so far, because a path may be traversed in both directions.
void draw_centrode(Sketch& sketch, const Way& way, const Box& mechanism, std::vector<Spot>& ends) {
    const Theme& theme = sketch.theme;
    if (way.kind == Way::Kind::pole) {
        const Spot at = spots_of(way, sketch.scale()).front();
        if (!contains(room_of(way, mechanism), at)) return;
        sketch.centres.emplace_back(tinted(disc(at, 1.15, theme.paper)));
        sketch.centres.emplace_back(disc(at, 0.8, theme.text));
        sketch.add_label(typeset(Symbol{Symbol::Letter::centre, way.name, ""}, sketch.context.language), theme.text, at,
                         1.7);
        return;
    }
    const bool is_fixed = way.kind == Way::Kind::fixed_centrode;
    const Pen pen{1.2 * theme.outline, theme.text, is_fixed ? std::vector<double>{} : dashes(), false};
    const auto pieces = pieces_within(room_of(way, mechanism), spots_of(way, sketch.scale()));
    sketch.construction.emplace_back(
        GroupBegin{"centrode", {}, "", {{"data-name", way.name}, {"data-on", is_fixed ? "fixed" : "moving"}}, none});
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::vector<Spot>& spots = pieces[i];
        sketch.construction.emplace_back(polyline(spots, pen));
        const auto arrow = [&](Spot before, Spot end) {
            constexpr double apart = 1.5;
            if (std::any_of(ends.begin(), ends.end(), [&](Spot other) { return length(other - end) < apart; })) return;
            ends.push_back(end);
            draw_arrow(sketch.construction, end - 5 * unit(end - before), end, theme.outline, pen.colour);
            sketch.add_label(one_piece("∞"), pen.colour, end, 1.2);
        };
        if (i == 0 && way.comes_from_infinity) arrow(spots[1], spots[0]);
        if (i + 1 == pieces.size() && way.goes_to_infinity) arrow(spots[spots.size() - 2], spots.back());
    }
    sketch.construction.emplace_back(GroupEnd{});
}

/// Each centrode is named once, at its longest piece; with its pair if there are several.
void name_centrodes(Sketch& sketch, const std::vector<Way>& ways, const Box& mechanism) {
    std::map<std::pair<std::string, Way::Kind>, std::vector<Spot>> longest;
    std::set<std::string> pairs;
    for (const Way& way : ways) {
        if (way.kind != Way::Kind::fixed_centrode && way.kind != Way::Kind::moving_centrode) continue;
        pairs.insert(way.name);
        std::vector<Spot>& kept = longest[{way.name, way.kind}];
        for (auto& spots : pieces_within(room_of(way, mechanism), spots_of(way, sketch.scale())))
            if (spots.size() > kept.size()) kept = std::move(spots);
    }
    for (const auto& [key, spots] : longest) {
        if (spots.size() < 2) continue;
        const bool is_fixed = key.second == Way::Kind::fixed_centrode;
        const std::string words =
            word(is_fixed ? lang::sheet::fixed_centrode : lang::sheet::moving_centrode, sketch.context.language);
        const std::size_t at = is_fixed ? spots.size() / 4 : (3 * spots.size()) / 4;
        LabelRequest& label = sketch.add_label(one_piece(pairs.size() > 1 ? words + " " + key.first : words),
                                               sketch.theme.text, spots[at], 1.4);
        label.toward = spots[std::min(at + 1, spots.size() - 1)];
    }
}

/// All bodies in another position, each a group.
void draw_position(Sketch& sketch, const Way& way) {
    const Pen thin{sketch.theme.thin, sketch.theme.skeleton, {}, false};
    for (const BodyIndex body : sketch.mechanism.moving_bodies()) {
        sketch.construction.emplace_back(
            GroupBegin{"position", {}, "", {{"data-name", sketch.mechanism.body(body).name}}, none});
        for (Path& outline : moved_outlines(sketch, body, way.bodies.at(at_index(body)), thin))
            sketch.construction.emplace_back(std::move(outline));
        sketch.construction.emplace_back(GroupEnd{});
    }
}

/// Other positions are thin, paths of points slightly stronger. `mechanism`: its extent, mm.
void draw_ways(Sketch& sketch, const std::vector<Way>& ways, const Box& mechanism) {
    std::vector<Spot> ends;
    for (const Way& way : ways) {
        if (way.kind == Way::Kind::position) {
            draw_position(sketch, way);
            continue;
        }
        if (way.kind != Way::Kind::plain) draw_centrode(sketch, way, mechanism, ends);
        if (way.kind != Way::Kind::plain || way.places.size() < 2) continue;
        const Theme& theme = sketch.theme;
        if (way.outline != none) {
            const std::vector<Spot> spots = spots_of(way, sketch.scale());
            sketch.tints.emplace_back(tinted(filled(spots, theme.colour_of(way.outline).tint)));
            sketch.bodies.emplace_back(GroupBegin{"path", {}, "", {{"data-name", way.name}}, none});
            sketch.bodies.emplace_back(polyline(spots, sketch.pen_of(way.outline, theme.vector), true));
            sketch.bodies.emplace_back(GroupEnd{});
            continue;
        }
        sketch.construction.emplace_back(
            GroupBegin{way.is_path ? "path" : "position", {}, "", {{"data-name", way.name}}, none});
        sketch.construction.emplace_back(polyline(
            spots_of(way, sketch.scale()), way.is_path && !way.is_thin ? Pen{theme.outline, theme.accent, {}, false}
                                                                       : Pen{theme.thin, theme.skeleton, {}, false}));
        sketch.construction.emplace_back(GroupEnd{});
    }
}

/// The labels of the ways.
void name_ways(Sketch& sketch, const std::vector<Way>& ways) {
    for (const Way& way : ways) {
        if (way.label.empty()) continue;
        LabelRequest& label =
            sketch.add_label(way.label, sketch.theme.secondary, spots_of(way, sketch.scale()).at(way.label_at), 1);
        label.size = sketch.theme.small;
    }
}

/// The extent of the mechanism with the centres that are near enough to be shown, m.
Box extent_with_centres(const Subject& subject) {
    std::vector<Spot> places;
    for (const InstantCentre& centre : subject.solution.centres)
        if (centre.at && !centre.at->at_infinity()) places.push_back(paper_spot(centre.at->place()));
    return with_near_places(subject.box, std::move(places), growth_for_places * subject.size());
}

/// A figure of the mechanism with optional content; draws it at several scales.
struct MechanismFigure {
    const DrawingContext& context;
    Spot room;
    Shows shows;
    Subject subject{context.solution};

    Figure fitted(const ScaleWish& wish) const {
        // The first scale leaves a minimum of space for symbols and names.
        const Box extent = shows.centres ? extent_with_centres(subject) : subject.box;
        const double first = choose_scale(extent.width(), extent.height(), std::max(room.x - 10, 10.0),
                                          std::max(room.y - 18, 10.0), std::nullopt);
        const FitPolicy policy{.room = room,
                               .first = std::max(first, wish.finest),
                               .asked = wish.asked,
                               .strict = wish.strict,
                               .exactly = wish.exactly,
                               .names_stay_in_room = true};
        const auto fitted_with = [&](const MotionWish& arrows) {
            return fit(policy,
                       [&](const Trial& trial) { return drawn(trial, arrows, room_for_labels(room), nullptr); });
        };
        Figure figure = fitted_with(shows.arrows);
        if (!shows.arrows.accelerations_of_drivers || accelerations_given() == 0) return figure;
        // Given accelerations are shown only if the mechanism does not become smaller. With a key for names it is small
        // anyway.
        const bool is_finest = !wish.asked && figure.scale <= policy.first;
        if (figure.has_key || is_finest) return figure;
        Figure without = fitted_with({.found = shows.arrows.found});
        return without.scale < figure.scale ? without : figure;
    }

    /// The same with ω and α of all bodies, or with ω of those where it can be read. Empty and at any_scale if the
    /// scale or a name would be lost.
    Figure with_more_arrows(const Figure& plain) const {
        using enum Symbol::Letter;
        MotionWish all{.accelerations_of_drivers = true, .most_without_room = 2, .found = {omega, alpha}};
        constexpr std::size_t most = 6;       // with more, any figure is crowded
        constexpr double room_of_each = 900;  // mm²; in less space no label found a position
        const std::size_t count = count_of(all);
        Spot names = room;
        if (count <= most && room.x * room.y >= room_of_each * static_cast<double>(count))
            if (Figure figure = with(all, plain, names);
                figure.leaders <= plain.leaders && is_as_readable(figure, plain, count))
                return figure;  // with a leader, a name would be read at one of the two arcs of its body
        all.found = {omega};
        all.only_readable = true;
        all.most_without_room = 1;
        // Without the names that stand badly the others mostly find better places.
        constexpr int attempts = 6;
        for (int attempt = 0; attempt < attempts; ++attempt) {
            Figure figure = with(all, plain, names);
            if (is_as_readable(figure, plain, count_of(all))) return figure;
            if (!leave_out_the_worst(all, figure, plain)) break;
        }
        return Figure::empty_at(any_scale);
    }

private:
    static std::ptrdiff_t astray(const Figure& figure) {
        return std::count_if(figure.leader_lines.begin(), figure.leader_lines.end(),
                             [](const DrawnLeader& leader) { return leader.is_astray; });
    }
    static double longest(const Figure& figure) {
        double most = 0;
        for (const DrawnLeader& leader : figure.leader_lines) most = std::max(most, length(leader.to - leader.from));
        return most;
    }
    /// Drawn at the scale of the plain figure, whose dimensions it keeps. Empty if arrows find no place. `names`: the
    /// room of names; the scale bar mostly finds a place beside the mechanism, and if it does not, names leave it the
    /// room below, from then on.
    Figure with(const MotionWish& arrows, const Figure& plain, Spot& names) const {
        if (count_of(arrows) == accelerations_given()) return Figure::empty_at(any_scale);
        const Trial trial{.scale = plain.scale, .strict = true};
        Figure figure = drawn(trial, arrows, names, &plain);
        const Spot above_the_bar = room_for_labels(room);
        if (has_room(figure) || names.y == above_the_bar.y) return figure;
        names = above_the_bar;
        return drawn(trial, arrows, names, &plain);
    }
    /// A name with a leader is hard to find, and may stand beside another arc: how many more there may be.
    static std::size_t leaders_for(std::size_t arcs) { return std::max<std::size_t>(1, (arcs + 3) / 4); }
    static constexpr double short_leader = 15, seen_apart = 0.3;  // mm
    bool is_as_readable(const Figure& figure, const Figure& plain, std::size_t arcs) const {
        return !figure.marks.empty() && has_room(figure) && !figure.has_key &&
               figure.leaders <= plain.leaders + leaders_for(arcs) && astray(figure) <= astray(plain) &&
               longest(figure) <= std::max(short_leader, longest(plain) + seen_apart);
    }
    /// Leaves out the body to which the worst new leader belongs: one that goes astray, or else the longest. If it is
    /// of another name, that has made way for an arc: that of the nearest body, most likely. False if none is left.
    bool leave_out_the_worst(MotionWish& wish, const Figure& figure, const Figure& plain) const {
        const auto badness = [](const DrawnLeader& leader) {
            constexpr double worse_than_any_length = 1e3;
            return length(leader.to - leader.from) + (leader.is_astray ? worse_than_any_length : 0);
        };
        const auto is_new = [&](const DrawnLeader& leader) {
            return std::none_of(plain.leader_lines.begin(), plain.leader_lines.end(), [&](const DrawnLeader& before) {
                return length(leader.from - figure.origin - (before.from - plain.origin)) < seen_apart &&
                       badness(leader) < badness(before) + seen_apart;
            });
        };
        const DrawnLeader* worst = nullptr;
        for (const DrawnLeader& leader : figure.leader_lines)
            if (is_new(leader) && (worst == nullptr || badness(leader) > badness(*worst))) worst = &leader;
        if (worst == nullptr) return false;
        const BodyIndex out = nearest_of_found(wish, *worst, figure.origin, figure.scale);
        if (out != none) wish.left_out.push_back(out);
        return out != none;
    }
    /// The body to which a leader belongs, or else the nearest of those whose ω is found and not left out.
    BodyIndex nearest_of_found(const MotionWish& wish, const DrawnLeader& leader, Spot origin, double scale) const {
        const auto is_wished = [&](BodyIndex body) {
            const auto& omega = context.solution.bodies[at_index(body)].omega;
            return omega && !omega->is_zero() &&
                   statement_of_turning(context.solution, turning_of(body, Symbol::Letter::omega)) != none &&
                   std::find(wish.left_out.begin(), wish.left_out.end(), body) == wish.left_out.end();
        };
        if (leader.body != none && is_wished(leader.body)) return leader.body;
        Cheapest<BodyIndex> nearest{none};
        for (const BodyStroke& stroke : Layout(subject, context.theme, scale).strokes_of_bodies())
            if (const double away = distance_to_segment(leader.to - origin, stroke.from, stroke.to);
                away < nearest.price && is_wished(stroke.body))
                nearest.offer(away, stroke.body);
        return nearest.choice;
    }

    /// Automatic dimensions are added last, so that they change neither the scale nor the position of a name. Those of
    /// a figure that has been drawn before are kept.
    Figure drawn(const Trial& trial, const MotionWish& arrows, Spot room_of_names, const Figure* before) const {
        Sketch sketch(subject, context, trial.scale, "");
        constexpr Spot overhang{0.2, 0.2};  // of letters beyond their boxes
        sketch.space = room_of_names - overhang;
        const Box alone{(1 / trial.scale) * shows.without_ways.min, (1 / trial.scale) * shows.without_ways.max};
        if (shows.ways != nullptr) draw_ways(sketch, *shows.ways, alone);
        draw_compass(sketch);
        draw_in_colour(sketch);
        std::vector<RichText> left_out;
        if (shows.centres) left_out = draw_centres(sketch);
        draw_equivalent_linkages(sketch);
        const bool adds_dimensions = context.dimensions == Dimensions::automatic;
        if (adds_dimensions && before != nullptr) keep_dimensions(sketch, *before);
        if (!draw_arrows_of_motion(sketch, arrows)) return Figure::empty_at(any_scale);
        if (context.dimensions == Dimensions::on) draw_dimensions(sketch, room, {.all = true});
        if (shows.ways != nullptr) name_centrodes(sketch, *shows.ways, alone);
        name_points(sketch);
        if (shows.ways != nullptr) name_ways(sketch, *shows.ways);
        Figure figure =
            sketch.finish(begun(context, {shows.centres ? FigureKind::centres : FigureKind::mechanism}), "m");
        figure.strokes = sketch.strokes_of_bodies();
        if (shows.ways != nullptr)
            figure.caption = one_piece(word(lang::sheet::mechanism_and_its_way, context.language));
        if (!left_out.empty()) append(figure.caption, without(left_out));
        sketch.close(figure, room, trial.last || trial.asked, trial.scale, subject.mechanism.units.length,
                     trial.strict);
        if (adds_dimensions && has_room(figure) && !figure.has_key)
            add_dimensions(sketch, figure, room, {.left_out = dimensions_of(figure)});
        return figure;
    }

    /// ", without P_24, P_25". If there are many, only the first are named, since the list of centres is complete.
    RichText without(const std::vector<RichText>& centres) const {
        constexpr std::size_t most = 6;
        RichText text = one_piece(word(lang::sheet::without_centres, context.language) + " ");
        for (std::size_t i = 0; i < std::min(centres.size(), most); ++i) {
            if (i > 0) append(text, one_piece(", "));
            append(text, centres[i]);
        }
        if (centres.size() > most) append(text, one_piece(" … (" + std::to_string(centres.size()) + ")"));
        return text;
    }

    std::size_t accelerations_given() const {
        const auto is_given = [](const Driver& driver) {
            return std::visit(
                [](const auto& one) {
                    if constexpr (requires { one.alpha; })
                        return !one.alpha.is_zero();
                    else
                        return !one.acceleration.is_zero();
                },
                driver);
        };
        const std::vector<Driver>& drivers = subject.mechanism.drivers;
        return static_cast<std::size_t>(std::count_if(drivers.begin(), drivers.end(), is_given));
    }
    /// With the rates of the drivers, which also need space.
    std::size_t count_of(const MotionWish& arrows) const {
        std::size_t count = arrows.accelerations_of_drivers ? accelerations_given() : 0;
        for (const BodyMotion& motion : context.solution.bodies)
            for (const Symbol::Letter letter : arrows.found) {
                const auto& value = letter == Symbol::Letter::omega ? motion.omega : motion.alpha;
                count += value && !value->is_zero() ? 1 : 0;
            }
        return count;
    }
    /// … and all its names are placed.
    bool has_room(const Figure& figure) const {
        return figure.labels.empty() && figure.box.width() <= room.x && figure.box.height() <= room.y;
    }
};

// --- velocities and accelerations on the mechanism

/// The quantities on this mechanism figure: vectors of points and rates of bodies.
struct OnMechanism {
    FigureKind figure;
    Symbol::Letter of_points, of_bodies;
    Quantity::Kind kind;  // of the vectors of points
    const char* si;
    Recorded<Vector> PointMotion::*vector;
    Unit Units::*unit;
};
constexpr OnMechanism velocities{
    FigureKind::velocities, Symbol::Letter::v, Symbol::Letter::omega, Quantity::Kind::velocity, "m/s",
    &PointMotion::velocity, &Units::velocity};
constexpr OnMechanism accelerations{
    FigureKind::accelerations,  Symbol::Letter::a,   Symbol::Letter::alpha, Quantity::Kind::acceleration, "m/s²",
    &PointMotion::acceleration, &Units::acceleration};

struct ShownVector {
    const PointMotion* motion;
    std::string name;  // of the point
    BodyIndex body;    // whose colour it has
    Spot value;
};

/// The body whose colour the vector has in the polygon; if it is not drawn there, the first moving body of the point.
BodyIndex body_of(const Solution& solution, const PointMotion& motion, const Symbol& symbol) {
    for (const DrawnVector& drawn : solution.protocol.vectors)
        if (drawn.role == DrawnVector::Role::absolute && drawn.symbol.letter == symbol.letter &&
            drawn.symbol.about == symbol.about && drawn.body != none)
            return drawn.body;
    const auto moving =
        std::find_if(motion.bodies.begin(), motion.bodies.end(), [](BodyIndex body) { return body > frame; });
    return moving == motion.bodies.end() ? none : *moving;
}

std::vector<ShownVector> shown_vectors(const Solution& solution, const OnMechanism& what) {
    std::vector<ShownVector> shown;
    for (const PointMotion& motion : solution.points) {
        const auto& vector = motion.*what.vector;
        if (motion.point == none || !vector || vector->is_zero()) continue;
        const std::string name = motion.label.empty() ? solution.mechanism.point(motion.point).name : motion.label;
        shown.push_back({&motion, name, body_of(solution, motion, {what.of_points, name, ""}), paper_spot(*vector)});
    }
    return shown;
}

struct Ray {
    Bar bar;
    StatementIndex statement;
};
/// From a point towards a centre, within the view.
Ray draw_ray(Sketch& sketch, const InstantCentre& centre, Spot at, Spot pole, const Box& view) {
    const Interval seen = within(view, at, unit(pole - at));
    const double whole = length(pole - at);
    if (whole <= seen.to) draw_pole(sketch, centre);
    return {{at, at + std::clamp(whole, 0.0, std::max(seen.to, 8.0)) * unit(pole - at)}, centre.statement};
}

/// Rays from a point to the absolute centres of its bodies, perpendicular to its velocity.
void draw_rays(Sketch& sketch, const PointMotion& motion, Spot tip, const Box& view, std::vector<Ray>& rays) {
    const Spot at = sketch.spot(motion.point);
    bool squared_off = false;
    for (const InstantCentre& centre : sketch.subject.solution.centres) {
        if (!centre.at || centre.first != frame || centre.everywhere || centre.at->at_infinity()) continue;
        if (std::find(motion.bodies.begin(), motion.bodies.end(), centre.second) == motion.bodies.end()) continue;
        const Spot pole = sketch.spot(centre.at->place());
        const double whole = length(pole - at);
        if (!std::isfinite(whole) || whole < 0.1) continue;
        rays.push_back(draw_ray(sketch, centre, at, pole, view));
        // The right angle between ray and velocity, once for each point.
        constexpr double corner = 1.8;
        if (squared_off || length(tip - at) <= 3 * corner) continue;
        const Spot r = corner * unit(pole - at), v = corner * unit(tip - at);
        sketch.construction.emplace_back(polyline({at + r, at + r + v, at + v}, sketch.thin()));
        squared_off = true;
    }
}

void draw_shown_vector(Sketch& sketch, const OnMechanism& what, const ShownVector& shown, const Bar& arrow) {
    const Symbol symbol{what.of_points, shown.name, ""};
    const BodyColour colour = sketch.theme.colour_of(shown.body);
    const std::string name = name_of(symbol);
    const RichText text = typeset(symbol, sketch.context.language);
    const StatementIndex statement =
        statement_of_motion(sketch.subject.solution, what.kind, shown.motion->bodies.front(), shown.motion->point);
    sketch.arrows.emplace_back(GroupBegin{"vector",
                                          sketch.id("", name),
                                          plain(text),
                                          {{"data-name", name}, {"data-value", shortest(length(shown.value))}},
                                          statement});
    draw_arrow(sketch.arrows, arrow.from, arrow.to, sketch.theme.vector, colour.line);
    sketch.arrows.emplace_back(Axis{arrow.from, arrow.to});
    sketch.arrows.emplace_back(GroupEnd{});
    LabelRequest& label = sketch.add_label(text, colour.letter, middle(arrow), 1.6, statement);
    label.size = sketch.theme.equation;
    label.toward = arrow.to;
}

/// The mechanism in grey. `with_rays`: with rays to the centres, which the vectors are perpendicular to.
Figure drawn_on_mechanism(const DrawingContext& context, const OnMechanism& what, Spot room, bool with_rays,
                          const ScaleWish& wish) {
    const Solution& solution = context.solution;
    const Subject subject(solution);
    const std::vector<ShownVector> shown = shown_vectors(solution, what);
    double longest = 0;
    for (const ShownVector& one : shown) longest = std::max(longest, length(one.value));
    const double first = choose_scale(subject.box.width(), subject.box.height(), std::max(room.x - 30, 10.0),
                                      std::max(room.y - 36, 10.0), std::nullopt);
    const FitPolicy policy{.room = room,
                           .first = std::max(first, wish.finest),
                           .strict = wish.strict,
                           .exactly = wish.exactly,
                           .names_stay_in_room = true};
    const Figure blank = begun(context, {what.figure});
    return fit(policy, [&](const Trial& trial) {
        Sketch sketch(subject, context, trial.scale, blank.id);
        draw_in_grey(sketch);
        const double reach = std::clamp(0.5 * sketch.size(), 15.0, 50.0);
        const double scale = longest > 0 ? choose_scale(longest, 0, reach, reach, std::nullopt) : 1;
        const Box view = grown(sketch.mechanism_box(), 0.25 * sketch.size());
        std::vector<Ray> rays;
        for (const ShownVector& one : shown) {
            const Spot at = sketch.spot(one.motion->point), tip = at + (1 / scale) * one.value;
            if (with_rays) draw_rays(sketch, *one.motion, tip, view, rays);
            draw_shown_vector(sketch, what, one, {at, tip});
        }
        draw_arrows_of_motion(
            sketch, {.accelerations_of_drivers = what.of_bodies == Symbol::Letter::alpha, .found = {what.of_bodies}});
        for (const auto& [bar, statement] : rays) {
            sketch.construction.emplace_back(line(bar.from, bar.to, sketch.thin()));
            belong(sketch.construction, sketch.construction.size() - 1, statement);
        }
        Figure figure = sketch.finish(blank, what.si);
        figure.scale = scale;
        sketch.close(figure, room, trial.last, scale, solution.mechanism.units.*what.unit, trial.strict);
        return figure;
    });
}

}  // namespace

Figure mechanism_figure(const DrawingContext& context, double room_x, double room_y, bool with_centres,
                        const ScaleWish& wish) {
    return MechanismFigure{
        context, {room_x, room_y}, {.centres = with_centres, .arrows = {.accelerations_of_drivers = true}}}
        .fitted(wish);
}

Figure mechanism_with_found_turnings(const DrawingContext& context, const Figure& plain, Spot room, bool with_centres) {
    return MechanismFigure{context, room, {.centres = with_centres}}.with_more_arrows(plain);
}

Box extent_of_mechanism(const Solution& solution, bool with_centres) {
    const Subject subject(solution);
    return with_centres ? extent_with_centres(subject) : subject.box;
}

Figure mechanism_with_ways(const DrawingContext& context, const std::vector<Way>& ways, double room_x, double room_y) {
    MechanismFigure figure{context, {room_x, room_y}, {.ways = &ways}};
    const Box mechanism = figure.shows.without_ways = figure.subject.box;
    for (const Way& way : ways)
        for (const Spot spot : spots_of(way, 1))
            if (way.kind == Way::Kind::plain || way.kind == Way::Kind::position ||
                contains(room_of(way, mechanism), spot))
                figure.subject.box.include(spot);
    return figure.fitted({});
}

Figure mechanism_with_turnings(const DrawingContext& context, Symbol::Letter letter, double room_x, double room_y) {
    return MechanismFigure{context,
                           {room_x, room_y},
                           {.arrows = {.accelerations_of_drivers = letter == Symbol::Letter::alpha, .found = {letter}}}}
        .fitted({});
}

Figure velocities_on_mechanism(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish) {
    return drawn_on_mechanism(context, velocities, {room_x, room_y}, true, wish);
}

Figure accelerations_on_mechanism(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish) {
    return drawn_on_mechanism(context, accelerations, {room_x, room_y}, false, wish);
}

/// Symbols and letters keep their size, so that a small mechanism is crowded.
void measure_mechanism(const Shown& shown, FigureId id, SizeWanted& size) {
    const Solution& solution = shown.solution();
    // The figure of an instantaneous motion shows its centre, too.
    const bool with_centres = id.kind == FigureKind::centres || (id.kind == FigureKind::mechanism &&
                                                                 solution.instantaneous_motion && shown.has_centres());
    const Box extent = extent_of_mechanism(solution, with_centres);
    size.take(extent);
    // Distant centres may take most of the figure; the links need a minimum size, and theirs is the figure's score.
    constexpr double least_of_links = 30;
    const Box links = with_centres ? extent_of_mechanism(solution, false) : extent;
    const double of_links = std::max(links.width(), links.height());
    size.subject = of_links;
    size.least = of_links > 0 ? least_of_links * size.extent() / of_links : least_of_links;
    size.weight = solution.instantaneous_motion ? 2 : 1.35;
}

namespace {

bool lists_motion(const Solution& solution) { return has_motion(solution) || !has_forces(solution); }
bool lists_centres(const Shown& shown) { return shown.has_centres() && !shown.solution().instantaneous_motion; }

std::vector<int> mechanism_alone(const Shown& shown, const LoadCase& /*all*/) {
    return once(lists_motion(shown.solution()) && !lists_centres(shown));
}
std::vector<int> mechanism_with_centres(const Shown& shown, const LoadCase& /*all*/) {
    return once(lists_motion(shown.solution()) && lists_centres(shown));
}
Figure draw_mechanism(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    if (shown.solution().instantaneous_motion) return instantaneous_motion_figure(shown.context, room.x, room.y, wish);
    return mechanism_figure(shown.context, room.x, room.y, id.kind == FigureKind::centres, wish);
}
Figure with_turnings(const Shown& shown, FigureId id, const Figure& plain, Spot room) {
    if (shown.solution().instantaneous_motion || shown.is_brief) return Figure::empty_at(any_scale);
    return mechanism_with_found_turnings(shown.context, plain, room, id.kind == FigureKind::centres);
}

template <Recorded<Vector> PointMotion::*vector>
std::vector<int> on_mechanism(const Shown& shown, const LoadCase& /*all*/) {
    const std::vector<PointMotion>& points = shown.solution().points;
    return once(!shown.solution().instantaneous_motion &&
                std::any_of(points.begin(), points.end(), [](const PointMotion& motion) {
                    return motion.point != none && motion.*vector && !(motion.*vector)->is_zero();
                }));
}
Figure draw_velocities(const Shown& shown, FigureId /*one*/, Spot room, const ScaleWish& wish) {
    return velocities_on_mechanism(shown.context, room.x, room.y, wish);
}
Figure draw_accelerations(const Shown& shown, FigureId /*one*/, Spot room, const ScaleWish& wish) {
    return accelerations_on_mechanism(shown.context, room.x, room.y, wish);
}

}  // namespace

constinit const FigureFunctions mechanism_functions{mechanism_alone, measure_mechanism, draw_mechanism, with_turnings};
constinit const FigureFunctions centres_functions{mechanism_with_centres, measure_mechanism, draw_mechanism,
                                                  with_turnings};
constinit const FigureFunctions velocities_functions{on_mechanism<&PointMotion::velocity>, measure_mechanism,
                                                     draw_velocities};
constinit const FigureFunctions accelerations_functions{on_mechanism<&PointMotion::acceleration>, measure_mechanism,
                                                        draw_accelerations};

}  // namespace kinegraph::render
