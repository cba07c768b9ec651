// Force figures: the mechanism with its lines of action, and every body cut free. Owns what such a figure shows and where its
// arrows stand; takes every force and place from the Solution, computes no statics.
#include <algorithm>
#include <cmath>
#include <set>

#include "render/figures/clutter.hpp"
#include "render/figures/mechanism_sketch.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/force_tables.hpp"
#include "render/tables/tables.hpp"

namespace kinegraph::render {

namespace drawing {

/// The body cut free: one outline for all that it is made of, tinted, so that arrows stand out from it.
void Sketch::draw_alone(BodyIndex body) {
    const Shape& shape = shapes_[at_index(body)];
    const double width = 0.9 * theme_.link, edge = theme_.outline;
    const Colour colour = line_colour(body), tint = tint_colour(body);
    bodies.emplace_back(GroupBegin{"link", id("link", m_.bodies[at_index(body)].name), m_.bodies[at_index(body)].name, {}});
    std::vector<Mark> profiles;
    draw_profiles(body, profiles);
    construction.clear();
    const auto is_heavy = [&](const Mark& mark) {
        const auto* path = std::get_if<Path>(&mark);
        return path && path->stroked && path->pen.width == theme_.link;
    };
    for (const Mark& mark : profiles)
        if (!is_heavy(mark)) bodies.push_back(mark);
    // Once wide in the colour, once narrower in the tint: the outline of all together.
    for (const bool outside : {true, false}) {
        const Pen pen{outside ? width + 2 * edge : width, outside ? colour : tint, {}, true};
        if (!outside && !shape.plate.empty()) bodies.emplace_back(tinted(filled(shape.plate, tint)));
        draw_strokes(shape, pen, bodies);
        for (const Mark& mark : profiles)
            if (is_heavy(mark)) {
                Path path = std::get<Path>(mark);
                path.pen = pen;
                bodies.emplace_back(std::move(path));
            }
    }
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        if (joint.kind == JointKind::prismatic && joint.bodies.size() == 2 && joint.bodies[0] == body)
            draw_block(joint, j, bodies);
        if (joint.kind == JointKind::pin_slot && joint.arc >= 0 && joint.bodies.size() == 2 && joint.bodies[1] == body)
            draw_curved_slot(joint, bodies);
    }
    for (const Bar& slot : shape.slots) draw_slot(slot, body, bodies);
    bodies.emplace_back(GroupEnd{});
    std::vector<Spot> done;
    const auto once = [&](Spot at) {
        if (std::any_of(done.begin(), done.end(), [&](Spot other) { return length(other - at) < same_place; })) return false;
        done.push_back(at);
        return true;
    };
    for (const Joint& joint : m_.joints) {
        if (std::find(joint.bodies.begin(), joint.bodies.end(), body) == joint.bodies.end()) continue;
        const Spot at = spot(joint.point);
        if (joint.kind == JointKind::prismatic || !once(at)) continue;
        if (joint.kind == JointKind::revolute || joint.kind == JointKind::pin_slot)
            pins.emplace_back(ring(at, 0.8 * pin_radius_, theme_.paper, {theme_.outline, theme_.text, {}, false}));
        else
            draw_dot(at);
    }
    for (std::size_t p = 0; p < spots_.size(); ++p) {
        if (!s_.shown[p] || !once(spots_[p])) continue;
        if (s_.mass_centre[p])
            draw_mass_centre(spots_[p]);
        else
            draw_dot(spots_[p]);
    }
}

}  // namespace drawing

namespace {

using namespace drawing;

constexpr double line_overshoot = 10;  // of a line of action past what it joins, mm

/// How many forces of a body pass through a place (m, y downwards), `near` being what counts as through.
int lines_through(const FreeBody& body, Spot place, double near) {
    int count = 0;
    for (const AppliedForce& applied : body.forces)
        if (!applied.force.is_zero() && std::abs(cross(paper_direction(applied.force), place - paper_spot(applied.at))) < near)
            ++count;
    return count;
}

using Meets = std::vector<FreeBody::Meet>;

/// Points of concurrency worth showing: a meet of partial reactions (superposition) is none of the forces drawn.
Meets shown_meets(const Solution& solution, const FreeBody& body) {
    Meets shown;
    const double near = 1e-7 * solution.pose.size.to_double();
    for (const auto& meet : body.meets)
        if (lines_through(body, paper_spot(meet.place), near) >= 2) shown.push_back(meet);
    return shown;
}

/// What a free body wants to show: its points, where its forces act, points of concurrency not too far away (m, y downwards).
struct FreeExtent {
    Box own, all;
};
FreeExtent extent_of(const Subject& subject, const FreeBody& body) {
    const Mechanism& mechanism = subject.mechanism;
    Box box;
    bool any = false;
    const auto include = [&](Spot spot, double radius) {
        const Box around{{spot.x - radius, spot.y - radius}, {spot.x + radius, spot.y + radius}};
        if (!any) box = around;
        any = true;
        box.min = {std::min(box.min.x, around.min.x), std::min(box.min.y, around.min.y)};
        box.max = {std::max(box.max.x, around.max.x), std::max(box.max.y, around.max.y)};
    };
    if (body.body >= 0) {
        const Body& data = mechanism.bodies[at_index(body.body)];
        for (const PointIndex p : data.points) include(subject.points[at_index(p)], 0);
        for (const Joint& joint : mechanism.joints)
            if (std::find(joint.bodies.begin(), joint.bodies.end(), body.body) != joint.bodies.end())
                include(subject.points[at_index(joint.point)], 0);
        if (data.circle) include(subject.points[at_index(data.circle->centre)], data.circle->radius.to_double());
    } else {
        include(subject.points[at_index(body.pin)], 0);
    }
    const Box own = box;
    const double size = std::max(own.width(), own.height());
    for (const AppliedForce& applied : body.forces)
        if (const Spot at = paper_spot(applied.at);
            length(at - 0.5 * (own.min + own.max)) < 2 * std::max(size, 0.1 * subject.size()))
            include(at, 0);
    // A point of concurrency is shown where it does not make the body tiny.
    const Box near = grown(box, 0.9 * std::max(size, 0.05 * subject.size()));
    for (const auto& [letter, place, statement] : shown_meets(subject.solution, body))
        if (const Spot at = paper_spot(place); contains(near, at)) include(at, 0);
    return {own, box};
}

// --- arrows on a body --------------------------------------------------------------------------------------------------------

/// A line of action: a direction and the places that it joins, mm.
struct ActionLine {
    Spot at, along;
    std::vector<Spot> marks;
    int statement = -1;                  // that knows it first
    std::vector<std::string> far_meets;  // points of concurrency outside of the drawing that it leads to
};

void add_line(std::vector<ActionLine>& lines, ActionLine added) {
    for (ActionLine& known : lines)
        if (std::abs(cross(known.along, added.along)) < 1e-6 && std::abs(cross(known.along, added.at - known.at)) < 0.05) {
            known.marks.insert(known.marks.end(), added.marks.begin(), added.marks.end());
            known.far_meets.insert(known.far_meets.end(), added.far_meets.begin(), added.far_meets.end());
            known.statement = std::min(known.statement, added.statement);
            return;
        }
    lines.push_back(std::move(added));
}

/// The line of a force with the points of concurrency on it, as far as there are any.
ActionLine line_of(const Sketch& sketch, const AppliedForce& applied, const Meets& meets, const Box& view, int statement = -1) {
    ActionLine action{sketch.spot(applied.at), paper_direction(applied.force), {sketch.spot(applied.at)}, statement, {}};
    for (const FreeBody::Meet& meet : meets) {
        const Spot place = sketch.spot(meet.place);
        if (std::abs(cross(action.along, place - action.at)) > 0.05 + 1e-9 * length(place - action.at)) continue;
        if (contains(view, place))
            action.marks.push_back(place);
        else
            action.far_meets.push_back(meet.name);
    }
    return action;
}

void draw_action_line(std::vector<Mark>& marks, const Theme& theme, const ActionLine& action, const Box& view) {
    double from = 1e300, to = -1e300;
    for (const Spot mark : action.marks) {
        from = std::min(from, dot(mark - action.at, action.along));
        to = std::max(to, dot(mark - action.at, action.along));
    }
    if (from > to) return;
    from -= line_overshoot, to += line_overshoot;
    const Interval seen = within(view, action.at, action.along);
    from = std::max(from, seen.from), to = std::min(to, seen.to);
    if (to - from < 1) return;
    marks.emplace_back(
        line(action.at + from * action.along, action.at + to * action.along, {theme.thin, theme.secondary, dash_dot(), false}));
    belong(marks, marks.size() - 1, action.statement);
}

void draw_meet(Sketch& sketch, const DrawingContext& context, const std::string& name, Spot at, int statement = -1) {
    for (LabelRequest& label : sketch.labels) {
        if (label.balloon > 0 || label.toward || length(label.anchor - at) > 0.3) continue;
        // The lines meet in a point that has a name already.
        append(label.text, one_piece(" ≡ "));
        append(label.text, typeset(Symbol{Symbol::Letter::point, name, ""}, context.language));
        return;
    }
    sketch.centres.emplace_back(ring(at, 1.0, context.theme.paper, {context.theme.outline, context.theme.text, {}, false}));
    sketch.centres.emplace_back(disc(at, 0.45, context.theme.text));
    belong(sketch.centres, sketch.centres.size() - 2, statement);
    LabelRequest label;
    label.statement = statement;
    label.names = {name};
    label.text = typeset(Symbol{Symbol::Letter::point, name, ""}, context.language);
    label.size = context.theme.label;
    label.colour = context.theme.text;
    label.anchor = at;
    label.clearance = 2.0;
    sketch.labels.push_back(std::move(label));
}

/// A point of concurrency outside of the drawing: the lines that meet there run to the edge of the view and point to it, and one
/// says how far it is.
void draw_far_meet(Sketch& sketch, const DrawingContext& context, const std::string& name, const Vector& place,
                   std::vector<ActionLine>& lines, const Box& view, int statement = -1) {
    constexpr double broken_end = 9;
    const Theme& theme = context.theme;
    const Spot meet = sketch.spot(place);
    if (!std::isfinite(meet.x) || !std::isfinite(meet.y)) return;  // past the range of doubles
    bool named = false;
    for (ActionLine& action : lines) {
        if (std::find(action.far_meets.begin(), action.far_meets.end(), name) == action.far_meets.end()) continue;
        const Interval seen = within(view, action.at, action.along);
        const double sense = dot(meet - action.at, action.along) > 0 ? 1 : -1;
        const Spot edge = action.at + (sense > 0 ? seen.to : seen.from) * action.along;
        const Spot tip = edge + sense * broken_end * action.along;
        action.marks.push_back(edge);
        draw_arrow(sketch.construction, edge, tip, theme.thin, theme.secondary, dashes());
        belong(sketch.construction, sketch.construction.size() - 2, std::max(statement, action.statement));
        if (named) continue;
        named = true;
        LabelRequest label;
        label.statement = statement;
        label.names = {name};
        label.text = typeset(Symbol{Symbol::Letter::point, name, ""}, context.language);
        if (const auto from = sketch.name_of_point_at(action.at)) {
            // "H (AH = 2.31 m)": what the drawing cannot hold.
            const Unit& unit = context.solution.mechanism.units.length;
            const double metres = length(meet - action.at) * sketch.scale();
            const RichText letter = label.text;
            append(label.text, one_piece("  ("));
            append(label.text, *from);
            append(label.text, letter);
            append(label.text,
                   with_powers(" = " + number(metres / unit.si.to_double(), 3, context.language) + " " + unit.symbol + ")"));
        }
        label.size = theme.label;
        label.colour = theme.text;
        label.anchor = tip;
        label.clearance = 1.2;
        sketch.labels.push_back(std::move(label));
    }
}

void draw_couple(Sketch& sketch, const DrawingContext& context, Clutter& clutter, const RichText& text, Spot at, bool positive,
                 const BodyColour& colour, int statement = -1) {
    // On paper y runs down: counter-clockwise is the negative turn.
    const double turn = positive ? -1 : 1;
    constexpr double sweep = 2.4;
    double radius = 7, start = 0, least = 1e300;
    for (const double tried : {7.0, 8.5, 10.5})
        for (int step = 0; step < 12; ++step) {
            const double from = step * pi_number / 6;
            double price = 0.15 * (tried - 7) / 3.5;
            price += 4 * clutter.along_arc(at, tried, from, turn * sweep);
            if (price < least - 1e-9) least = price, radius = tried, start = from;
        }
    const std::size_t first = sketch.arrows.size();
    draw_arc_arrow(sketch.arrows, at, radius, start, start + turn * sweep, 0.5, colour.line);
    belong(sketch.arrows, first, statement);
    for (int i = 0; i < 6; ++i)
        clutter.add(at + radius * polar_spot(start + turn * sweep * i / 6),
                    at + radius * polar_spot(start + turn * sweep * (i + 1) / 6));
    LabelRequest label;
    label.statement = statement;
    label.text = text;
    label.size = context.theme.label;
    label.colour = colour.letter;
    label.anchor = at + radius * polar_spot(start + turn * sweep / 2);
    label.toward = label.anchor + 4.0 * turned(polar_spot(start + turn * sweep / 2));
    label.clearance = 1.5;
    sketch.labels.push_back(std::move(label));
}

RichText couple_words(const DrawingContext& context, const AppliedForce& applied) {
    const Unit& unit = context.solution.mechanism.units.moment;
    RichText text = typeset(couple_symbol(applied), context.language);
    const double value = std::abs((applied.couple / unit.si).to_double());
    append(text, with_powers(" = " + number(value, 4, context.language) + " " + unit.symbol));
    return text;
}

/// Draws at ever smaller scales until everything, labels too, is within the room.
template <class Draw>
Figure fitted(double first, bool fixed, double room_x, double room_y, Draw draw) {
    constexpr int most_tries = 12;
    double scale = first;
    for (int tries = 0;; ++tries) {
        Figure figure = draw(scale, tries == most_tries);
        const bool fits = figure.box.width() <= room_x && figure.box.height() <= room_y;
        if (fixed || fits || tries == most_tries) return figure;
        scale = next_scale(scale);
    }
}

}  // namespace

Box extent_of_free_body(const Solution& solution, std::size_t index) {
    return extent_of(Subject(solution), solution.free_bodies[index]).all;
}

Figure free_body_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y) {
    const Solution& solution = context.solution;
    const Mechanism& mechanism = solution.mechanism;
    const Theme& theme = context.theme;
    const FreeBody& body = solution.free_bodies[index];
    const std::string name =
        body.body >= 0 ? mechanism.bodies[at_index(body.body)].name : mechanism.points[at_index(body.pin)].name;
    const std::string id = legal_id(body.body >= 0 ? "body-" + name : "pin-" + name);

    // The body's own points and places only.
    Subject subject(solution);
    std::fill(subject.shown.begin(), subject.shown.end(), false);
    const auto show = [&](PointIndex point) {
        if (point >= 0) subject.shown[at_index(point)] = true;
    };
    if (body.body >= 0) {
        for (const PointIndex p : mechanism.bodies[at_index(body.body)].points) show(p);
        for (const Mass& mass : mechanism.masses)
            if (mass.body == body.body) show(mass.centre);
        for (const Joint& joint : mechanism.joints)
            if (std::find(joint.bodies.begin(), joint.bodies.end(), body.body) != joint.bodies.end()) show(joint.point);
    } else {
        show(body.pin);
    }
    double longest = 0;
    for (const AppliedForce& applied : body.forces) longest = std::max(longest, kinegraph::length(applied.force));
    const auto [own_box, box] = extent_of(subject, body);
    const double own = std::max(own_box.width(), own_box.height());
    const auto meets = shown_meets(solution, body);
    subject.box = box;

    const Unit& unit = mechanism.units.force;
    const double si = unit.si.to_double();
    const auto asked = asked_scale(mechanism, "body");
    const double reach = std::clamp(0.42 * std::min(room_x, room_y), 20.0, 38.0);
    const double force_scale = asked ? *asked / si : longest > 0 ? choose_scale(longest / si, 0, reach, reach, std::nullopt) : 1;
    const double around = std::min(30.0, longest / si / force_scale);
    const double first = choose_scale(std::max(box.width(), 1e-9), std::max(box.height(), 1e-9), std::max(room_x - around, 10.0),
                                      std::max(room_y - around - 12, 10.0), std::nullopt);
    // A lone block has no length of its own: the mechanism's scale would do, whatever it is.
    const double least = choose_scale(subject.size() > 0 ? subject.size() : 1, 0, 120, 120, std::nullopt);
    const double start = own > 0 ? first : least;
    return fitted(start, false, room_x, room_y, [&](double scale, bool last) {
        Sketch sketch(subject, context, scale, id + "-");
        const BodyColour colour = theme.colour_of(body.body);
        if (body.body >= 0) {
            sketch.draw_alone(body.body);
        } else {
            sketch.pins.emplace_back(ring(sketch.spot(body.pin), 1.8, theme.paper, {theme.outline, theme.text, {}, false}));
        }
        sketch.draw_points(true);
        Clutter clutter;
        clutter.add(sketch.bodies);
        const Spot middle = body.body >= 0 ? sketch.shape(body.body).middle : sketch.spot(body.pin);
        const Box view = grown(sketch.mechanism_box(), line_overshoot + 3);

        std::vector<ActionLine> lines;
        struct Standing {
            Spot tail, tip;
        };
        std::vector<Standing> standing;
        std::set<std::string> names;
        std::set<JointIndex> joints_remarked;
        // Two forces: one line, or with a couple two, and their distance is its arm.
        const bool two_forces =
            std::count_if(body.forces.begin(), body.forces.end(), [](const AppliedForce& f) { return !f.force.is_zero(); }) == 2;
        for (const AppliedForce& applied : body.forces) {
            const Spot at = sketch.spot(applied.at);
            if (!applied.couple.is_zero())
                draw_couple(sketch, context, clutter, couple_words(context, applied), at, applied.couple.sign() > 0, colour);
            if (applied.force.is_zero()) continue;
            const Spot along = paper_direction(applied.force);
            const double value = kinegraph::length(Vector{applied.force.x / unit.si, applied.force.y / unit.si});
            // Too small for its own arrowhead, a force shows its sense by a thin arrow and says its size.
            constexpr double least_to_scale = 4, only_sense = 9;
            const bool to_scale = value / force_scale >= least_to_scale;
            const Spot d = (to_scale ? value / force_scale : only_sense) * along;
            // Tail or tip at its place; slid along its line where another arrow is there already.
            const bool at_centre = applied.kind == AppliedForce::Kind::weight || applied.kind == AppliedForce::Kind::inertia;
            const bool outwards = at_centre || dot(along, at - middle) >= -1e-6;
            Standing best{at, at + d};
            double least_price = 1e300;
            for (const double slid : {0.0, 1.0})
                for (const bool pulls : {outwards, !outwards}) {
                    Standing tried = pulls ? Standing{at, at + d} : Standing{at - d, at};
                    double price = (pulls == outwards ? 0 : 0.35) + slid * 0.5 +
                                   0.8 * clutter.along(tried.tail + 0.1 * d, tried.tip - 0.1 * d);
                    if (slid > 0) {
                        double beyond = 0;
                        for (const Standing& other : standing) {
                            if (std::abs(cross(along, other.tail - at)) > 1.5 || std::abs(cross(along, other.tip - at)) > 1.5)
                                continue;
                            for (const Spot end : {other.tail, other.tip})
                                beyond = std::max(beyond, (pulls ? 1 : -1) * dot(end - at, along));
                        }
                        if (beyond <= 0) continue;
                        const Spot shift = ((pulls ? 1 : -1) * (beyond + 2.5)) * along;
                        tried = {tried.tail + shift, tried.tip + shift};
                    }
                    for (const Standing& other : standing) {
                        if (std::abs(cross(along, other.tail - at)) > 1.5 || std::abs(cross(along, other.tip - at)) > 1.5)
                            continue;
                        const double a = dot(other.tail - at, along), b = dot(other.tip - at, along);
                        const double c = dot(tried.tail - at, along), e = dot(tried.tip - at, along);
                        if (std::min(std::max(a, b), std::max(c, e)) - std::max(std::min(a, b), std::min(c, e)) > 0.5) price += 3;
                    }
                    if (price < least_price - 1e-9) least_price = price, best = tried;
                }
            standing.push_back(best);
            clutter.add(best.tail, best.tip);

            const std::string base = name_of(applied.symbol);
            std::string unique = base;
            for (int n = 2; !names.insert(unique).second; ++n) unique = base + "-" + std::to_string(n);
            sketch.arrows.emplace_back(GroupBegin{to_scale ? "vector" : "sense",
                                                  sketch.id("", unique),
                                                  unique + " = " + shortest(value) + " " + unit.symbol,
                                                  {{"data-name", unique}, {"data-value", shortest(value)}}});
            if (to_scale) sketch.arrows.emplace_back(Axis{best.tail, best.tip});
            draw_arrow(sketch.arrows, best.tail, best.tip, to_scale ? theme.vector : theme.outline, colour.line, colour.dashes);
            sketch.arrows.emplace_back(GroupEnd{});
            LabelRequest label;
            label.text = typeset(applied.symbol, context.language);
            // In a narrow room the words would cost the body its scale; the table of results has the value.
            constexpr double roomy = 80;
            if (!to_scale && room_x >= roomy)
                append(label.text, with_powers(" = " + number(value, 4, context.language) + " " + unit.symbol));
            label.size = theme.equation;
            label.colour = colour.letter;
            label.anchor = 0.5 * (best.tail + best.tip);
            label.toward = best.tip;
            label.clearance = 1.5;
            sketch.labels.push_back(std::move(label));

            ActionLine action = line_of(sketch, applied, meets, view);
            if (action.marks.size() > 1 || !action.far_meets.empty() || two_forces ||
                (applied.joint >= 0 && applied.line_by_construction))
                add_line(lines, std::move(action));
            if (applied.joint >= 0 && joints_remarked.insert(applied.joint).second) {
                const RichText words = beside_guide(context, body, applied);
                if (!words.empty()) {
                    LabelRequest remark;
                    remark.text = words;
                    remark.size = theme.small;
                    remark.colour = theme.secondary;
                    remark.anchor = at;
                    remark.clearance = 3;
                    sketch.labels.push_back(std::move(remark));
                }
            }
        }
        for (const auto& [letter, place, statement] : meets)
            if (const Spot meet = sketch.spot(place); contains(view, meet))
                draw_meet(sketch, context, letter, meet);
            else
                draw_far_meet(sketch, context, letter, place, lines, view);
        for (const ActionLine& action : lines) draw_action_line(sketch.over_bodies, theme, action, view);

        Figure figure = sketch.finish("body", id, unit.symbol);
        figure.scale = force_scale;
        figure.caption = one_piece(word(body.body >= 0 ? "free body" : "free pin", context.language) + " " + name);
        if (body.body >= 0)
            if (const std::string& label = in(mechanism.bodies[at_index(body.body)].label, context.language); !label.empty())
                figure.caption.back().text += ": " + label;
        sketch.close(figure, {room_x, room_y}, last, force_scale * si, unit);
        return figure;
    });
}

Figure mechanism_with_forces(const DrawingContext& context, double room_x, double room_y) {
    const Solution& solution = context.solution;
    const Mechanism& mechanism = solution.mechanism;
    const Theme& theme = context.theme;
    const Subject subject(solution);
    const auto asked = asked_scale(mechanism, "mechanism");
    // A point of concurrency is what the figure is for: it may make the mechanism smaller.
    const Box near = grown(subject.box, 0.7 * subject.size());
    Box extent = subject.box;
    // A meet of bodies taken together has lines on several of them.
    Meets shown;
    for (const FreeBody& body : solution.free_bodies)
        for (const auto& meet : body.meets) {
            const bool listed = std::any_of(shown.begin(), shown.end(), [&](const auto& m) { return m.name == meet.name; });
            int count = 0;
            for (const FreeBody& other : solution.free_bodies)
                count = std::max(count, lines_through(other, paper_spot(meet.place), 1e-7 * solution.pose.size.to_double()));
            if (!listed && count >= 2) shown.push_back(meet);
        }
    {
        for (const auto& [letter, place, statement] : shown)
            if (const Spot at = paper_spot(place); contains(near, at)) {
                extent.min = {std::min(extent.min.x, at.x), std::min(extent.min.y, at.y)};
                extent.max = {std::max(extent.max.x, at.x), std::max(extent.max.y, at.y)};
            }
    }
    const double first =
        choose_scale(extent.width(), extent.height(), std::max(room_x - 14, 10.0), std::max(room_y - 24, 10.0), asked);
    return fitted(first, asked.has_value(), room_x, room_y, [&](double scale, bool last) {
        Sketch sketch(subject, context, scale, "");
        sketch.draw_in_colour();
        sketch.draw_points(true);
        Clutter clutter;
        clutter.add(sketch.bodies);
        clutter.add(sketch.ground);

        const Box drawn{(1 / scale) * extent.min, (1 / scale) * extent.max};
        const Box view = grown(drawn, line_overshoot + 4);
        std::vector<ActionLine> lines;
        for (const FreeBody& body : solution.free_bodies) {
            for (const AppliedForce& applied : body.forces) {
                if (applied.force.is_zero()) continue;
                ActionLine action = line_of(sketch, applied, shown_meets(solution, body), view, applied.line_statement);
                if (action.marks.size() > 1 || !action.far_meets.empty() || applied.line_by_construction)
                    add_line(lines, std::move(action));
            }
        }
        for (const auto& [letter, place, statement] : shown)
            if (const Spot at = sketch.spot(place); contains(view, at))
                draw_meet(sketch, context, letter, at, statement);
            else
                draw_far_meet(sketch, context, letter, place, lines, view, statement);
        for (const ActionLine& action : lines) draw_action_line(sketch.construction, theme, action, view);

        // Loads, efforts and what the frame gives: their sense only.
        for (const FreeBody& body : solution.free_bodies) {
            const BodyColour colour = theme.colour_of(body.body);
            for (const AppliedForce& applied : body.forces) {
                if (applied.kind == AppliedForce::Kind::reaction && applied.from != 0) continue;
                // An actuator between two bodies shows once.
                if (applied.kind == AppliedForce::Kind::effort && applied.from > 0 && applied.from < body.body) continue;
                const Spot at = sketch.spot(applied.at);
                const int statement = applied.force_statement;
                if (!applied.couple.is_zero()) {
                    draw_couple(sketch, context, clutter, typeset(couple_symbol(applied), context.language), at,
                                applied.couple.sign() > 0, colour, statement);
                }
                if (applied.force.is_zero()) continue;
                const Spot along = paper_direction(applied.force);
                const bool at_centre = applied.kind == AppliedForce::Kind::weight || applied.kind == AppliedForce::Kind::inertia;
                constexpr double whole = 20;
                Spot tail = at, tip = at + whole * along;
                double least_price = 1e300;
                const std::vector<double> gaps = at_centre ? std::vector<double>{2.2} : std::vector<double>{2.4, 7.0};
                for (const double stand_off : gaps)
                    for (const bool pulls : {true, false}) {
                        const Spot a = pulls ? at + stand_off * along : at - (stand_off + whole) * along;
                        const Spot b = a + whole * along;
                        double price = clutter.along(a, b) + 0.03 * stand_off;
                        if (at_centre && !pulls) price += 0.6;
                        if (applied.kind == AppliedForce::Kind::reaction && pulls) price += 0.15;
                        if (price < least_price - 1e-9) least_price = price, tail = a, tip = b;
                    }
                const std::size_t arrow = sketch.arrows.size();
                draw_arrow(sketch.arrows, tail, tip, theme.vector, colour.line, colour.dashes);
                belong(sketch.arrows, arrow, statement);
                clutter.add(tail, tip);
                LabelRequest label;
                label.statement = statement;
                label.names = {name_of(applied.symbol)};
                label.text = typeset(applied.symbol, context.language);
                label.size = theme.equation;
                label.colour = colour.letter;
                label.anchor = 0.5 * (tail + tip);
                label.toward = tip;
                label.clearance = 1.5;
                sketch.labels.push_back(std::move(label));
            }
        }
        Figure figure = sketch.finish("mechanism", "mechanism", "m");
        figure.caption = one_piece(word("mechanism and lines of action", context.language));
        sketch.close(figure, {room_x, room_y}, last || asked.has_value(), scale, mechanism.units.length);
        return figure;
    });
}

}  // namespace kinegraph::render
