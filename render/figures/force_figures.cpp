// Force figures: the mechanism with lines of action, and free bodies. Owns the content of these figures and the
// positions of arrows; all forces and points of application come from the Solution.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <set>

#include "engine/number/functions.hpp"
#include "engine/solution/bindings.hpp"
#include "engine/solution/forces.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/figures/caption.hpp"
#include "render/figures/figure.hpp"
#include "render/figures/figure_table.hpp"
#include "render/figures/fit.hpp"
#include "render/figures/strings.hpp"
#include "render/mechanism/clutter.hpp"
#include "render/mechanism/near_places.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/mechanism/symbols.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/load_case.hpp"
#include "render/tables/force_tables.hpp"

namespace kinegraph::render {

namespace {

using namespace drawing;

constexpr double line_overshoot = 10;  // mm; of a line of action beyond the points it joins

using Form = Holds::Form;
Holds at_place(std::string place) { return {Form::at, {std::move(place)}}; }
/// Binds to position and direction of a force.
Holds on_force(Form form, const std::string& force) { return {form, {force, force}}; }

double near_a_line(const Solution& solution) { return 1e-7 * solution.pose.size.to_double(); }
double near_a_line(const Sketch& sketch) { return near_a_line(sketch.subject.solution); }

/// The number of forces of a body whose lines pass within `near` of a point (m, y downwards).
int lines_through(const FreeBody& body, Spot place, double near) {
    const auto passes = [&](const AppliedForce& applied) {
        return !applied.force.is_zero() &&
               std::abs(cross(paper_direction(applied.force), place - paper_spot(applied.at))) < near;
    };
    return static_cast<int>(std::count_if(body.forces.begin(), body.forces.end(), passes) +
                            std::count_if(body.sums.begin(), body.sums.end(), passes));
}
/// The same for the resultants of bodies taken together.
bool passes_sum_of_several(const LoadCase& loads, Spot place) {
    return std::any_of(loads.together().begin(), loads.together().end(), [&](const TakenTogether& together) {
        FreeBody as_one;
        as_one.sums = together.sums;
        return lines_through(as_one, place, near_a_line(loads.solution())) > 0;
    });
}
using Meets = std::vector<FreeBody::Meet>;

/// Whether it is the intersection of the outer strings of a funicular polygon, on the line of the resultant.
bool is_meet_of_strings(const FreeBody& body, const FreeBody::Meet& meet) {
    return body.funicular && body.funicular->resultant && *body.funicular->resultant == meet.place;
}

/// The points of concurrency to be shown. Those of partial reactions (superposition) are omitted, because these forces
/// are not drawn.
Meets shown_meets(const Solution& solution, const FreeBody& body) {
    Meets shown;
    for (const auto& meet : body.meets)
        if (is_meet_of_strings(body, meet) || lines_through(body, paper_spot(meet.place), near_a_line(solution)) >= 2)
            shown.push_back(meet);
    return shown;
}

/// Those of all bodies, without repetition. A point of bodies taken together has lines on several bodies.
Meets all_shown_meets(const LoadCase& loads) {
    Meets shown;
    for (const FreeBody& body : loads.bodies())
        for (const auto& meet : body.meets) {
            const bool listed =
                std::any_of(shown.begin(), shown.end(), [&](const auto& m) { return m.name == meet.name; });
            const bool met = std::any_of(loads.bodies().begin(), loads.bodies().end(), [&](const FreeBody& other) {
                return lines_through(other, paper_spot(meet.place), near_a_line(loads.solution())) >= 2;
            });
            if (!listed && (met || passes_sum_of_several(loads, paper_spot(meet.place)))) shown.push_back(meet);
        }
    return shown;
}

/// The points of a body and of its joints; for a free pin its own point.
std::vector<PointIndex> points_of(const Mechanism& mechanism, const FreeBody& body) {
    if (body.body == none) return {body.pin};
    std::vector<PointIndex> points = mechanism.body(body.body).points;
    for (const Joint& joint : mechanism.joints)
        if (joint.connects(body.body)) points.push_back(joint.point);
    return points;
}

/// The extent of a free body: its points, points of application, and points of concurrency that are near (m, y
/// downwards).
struct FreeExtent {
    Box own, all;
    Box reach;  ///< the body with the places of all forces and arms
};
FreeExtent extent_of_body(const Subject& subject, const FreeBody& body) {
    const std::vector<PointIndex> points = points_of(subject.mechanism, body);
    Box box;
    if (!points.empty()) box = {subject.points[at_index(points.front())], subject.points[at_index(points.front())]};
    for (const PointIndex point : points) box.include(subject.points[at_index(point)]);
    if (body.body != none)
        if (const auto& circle = subject.mechanism.body(body.body).circle) {
            const Spot centre = subject.points[at_index(circle->centre)];
            const Box around = grown({centre, centre}, circle->radius.to_double());
            box = points.empty() ? around : box;
            box.include(around);
        }
    const Box own = box;
    Box reach = own;
    const double size = std::max(own.width(), own.height());
    for (const AppliedForce& applied : body.forces) {
        const Spot at = paper_spot(applied.at);
        if (!applied.force.is_zero()) reach.include(at);
        if (length(at - own.middle()) < 2 * std::max(size, 0.1 * subject.size())) box.include(at);
    }
    // Points of concurrency are the purpose of the figure: it may become smaller for them, but not too small.
    constexpr double growth = 1.8;
    std::vector<Spot> places;
    for (const FreeBody::Meet& meet : shown_meets(subject.solution, body)) places.push_back(paper_spot(meet.place));
    for (const FreeBody::Arm& arm : body.arms)
        for (const Spot end : {paper_spot(arm.about), paper_spot(arm.foot)}) {
            places.push_back(end);
            reach.include(end);
        }
    for (const AppliedForce& sum : body.sums) reach.include(paper_spot(sum.at));
    const Box near = grown(box, 0.9 * std::max(size, 0.05 * subject.size()));
    box = with_near_places(box, std::move(places), growth * std::max(size, 0.1 * subject.size()));
    if (body.funicular) include_strings(box, *body.funicular, near);
    return {own, box, reach};
}

// --- lines of action and their intersections

/// A line of action: its direction and the points that it joins, mm.
struct ActionLine {
    Spot at, along;
    std::vector<Spot> marks;
    StatementIndex statement = none;     // the first that determines it
    std::vector<std::string> far_meets;  // points of concurrency outside the drawing
    std::vector<std::string> forces{};   // bindings of its forces
    std::vector<std::string> places{};   // bindings of its points
    std::vector<LabelRequest> names{};   // of resultants, which have no arrow here

    /// Whether it joins its point of application with another point.
    bool joins() const { return marks.size() > 1 || !far_meets.empty(); }
    void reach(Spot mark, std::string place) {
        marks.push_back(mark);
        places.push_back(std::move(place));
    }
};

/// Extends a line to the feet of the arms that are measured from it.
void reach_feet(ActionLine& action, const Sketch& sketch, const FreeBody& body, const std::string& load) {
    for (std::size_t i = 0; i < body.arms.size(); ++i) {
        const FreeBody::Arm& arm = body.arms[i];
        const Spot foot = sketch.spot(arm.foot);
        if (std::abs(cross(action.along, foot - action.at)) > 0.05) continue;
        action.reach(foot, arm_binding(load, body, i, true));
        action.statement = action.statement == none ? arm.statement : std::min(action.statement, arm.statement);
    }
}

LabelRequest label_of_meet(const Sketch& sketch, const std::string& name, Spot at, double clearance,
                           StatementIndex statement, const std::string& place) {
    return {.text = typeset(Symbol{Symbol::Letter::point, name, ""}, sketch.context.language),
            .size = sketch.theme.label,
            .colour = sketch.theme.text,
            .anchor = at,
            .clearance = clearance,
            .statement = statement,
            .names = {name},
            .in_file = sketch.mechanism.point_named(name) ? name : "",
            .holds = at_place(place)};
}

void draw_meet(Sketch& sketch, const std::string& name, Spot at, StatementIndex statement, const std::string& place) {
    LabelRequest own = label_of_meet(sketch, name, at, 2.0, statement, place);
    for (LabelRequest& label : sketch.labels) {
        if (label.size < sketch.theme.label || label.balloon > 0 || label.toward ||
            length(label.anchor - at) > near_a_line(sketch) / sketch.scale())
            continue;
        // The intersection coincides with a named point, not only on paper.
        label.add_name(own.text);
        return;
    }
    sketch.centres.emplace_back(ring(at, 1.0, sketch.theme.paper, sketch.outline()));
    sketch.centres.emplace_back(disc(at, 0.45, sketch.theme.text));
    belong(sketch.centres, sketch.centres.size() - 2, statement);
    hang(sketch.centres, sketch.centres.size() - 2, own.holds);
    sketch.labels.push_back(std::move(own));
}

/// The lines of action of a drawing within a view, without repetition.
class ActionLines {
public:
    /// `load`: that acts alone; empty: all loads.
    ActionLines(Sketch& sketch, const Box& view, std::string load)
        : sketch_(sketch), view_(view), load_(std::move(load)) {}

    /// The arrows that point to what is outside the drawing.
    const std::vector<Bar>& pointers() const { return pointers_; }

    /// The line of a force with its points of concurrency.
    ActionLine line_of(const AppliedForce& applied, const Meets& meets, std::string held) const {
        const Spot at = sketch_.spot(applied.at);
        ActionLine action{at, paper_direction(applied.force), {at}, applied.line_statement, {}};
        action.forces.push_back(std::move(held));
        for (const FreeBody::Meet& meet : meets) {
            const Spot place = sketch_.spot(meet.place);
            if (std::abs(cross(action.along, place - at)) > 0.05 + 1e-9 * length(place - at)) continue;
            if (contains(view_, place))
                action.marks.push_back(place);
            else
                action.far_meets.push_back(meet.name);
            action.places.push_back(meet_binding(load_, meet.name));
        }
        return action;
    }

    void add(ActionLine added) {
        for (ActionLine& known : lines_)
            if (std::abs(cross(known.along, added.along)) < 1e-6 &&
                std::abs(cross(known.along, added.at - known.at)) < 0.05) {
                known.marks.insert(known.marks.end(), added.marks.begin(), added.marks.end());
                known.far_meets.insert(known.far_meets.end(), added.far_meets.begin(), added.far_meets.end());
                known.statement = std::min(known.statement, added.statement);
                known.forces.insert(known.forces.end(), added.forces.begin(), added.forces.end());
                known.places.insert(known.places.end(), added.places.begin(), added.places.end());
                known.names.insert(known.names.end(), added.names.begin(), added.names.end());
                return;
            }
        lines_.push_back(std::move(added));
    }

    /// Extends the line of a force to the strings that end on it.
    void add_to_strings(const AppliedForce& applied, const std::string& held, const Meets& meets,
                        const FreeBody::Funicular& funicular) {
        ActionLine action = line_of(applied, meets, held);
        for (std::size_t i = 0; i < funicular.vertices.size(); ++i)
            if (const Spot at = sketch_.spot(*funicular.vertices[i]);
                std::abs(cross(action.along, at - action.at)) < 0.05)
                action.reach(at, string_binding(load_, funicular, i));
        action.statement =
            std::min(action.statement == none ? funicular.statement : action.statement, funicular.statement);
        if (action.marks.size() > 1) add(std::move(action));
    }

    void draw_meets(const Meets& meets) {
        for (const FreeBody::Meet& meet : meets)
            if (const Spot at = sketch_.spot(meet.place); contains(view_, at))
                draw_meet(sketch_, meet.name, at, meet.statement, meet_binding(load_, meet.name));
            else
                draw_far_meet(meet.name, at, meet.statement);
    }

    void draw(std::vector<Mark>& layer) const {
        for (const ActionLine& action : lines_) draw(action, layer);
    }

private:
    /// For a point of concurrency outside the drawing: its lines extend to the edge of the view, and one of them shows
    /// the distance.
    void draw_far_meet(const std::string& name, Spot meet, StatementIndex statement) {
        constexpr double broken_end = 9;
        if (!std::isfinite(meet.x) || !std::isfinite(meet.y)) return;  // out of the range of doubles
        bool named = false;
        for (ActionLine& action : lines_) {
            if (std::find(action.far_meets.begin(), action.far_meets.end(), name) == action.far_meets.end()) continue;
            const Interval seen = within(view_, action.at, action.along);
            if (seen.from > seen.to) continue;  // all of the line is outside
            const double sense = dot(meet - action.at, action.along) > 0 ? 1 : -1;
            const Spot edge = action.at + (sense > 0 ? seen.to : seen.from) * action.along;
            const Spot tip = edge + sense * broken_end * action.along;
            action.marks.push_back(edge);
            pointers_.push_back({edge, tip});
            draw_arrow(sketch_.construction, edge, tip, sketch_.theme.thin, sketch_.theme.secondary);
            belong(sketch_.construction, sketch_.construction.size() - 2, std::max(statement, action.statement));
            if (named) continue;
            named = true;
            LabelRequest label = label_of_meet(sketch_, name, tip, 1.2, statement, meet_binding(load_, name));
            label.holds = {};  // the label at the edge shows the distance
            if (const auto from = name_of_point_at(sketch_, action.at))
                append(label.text, how_far(sketch_, *from, label.text, length(meet - action.at)));
            sketch_.labels.push_back(std::move(label));
        }
    }

    void draw(const ActionLine& action, std::vector<Mark>& layer) const {
        double from = 1e300, to = -1e300;
        for (const Spot mark : action.marks) {
            from = std::min(from, dot(mark - action.at, action.along));
            to = std::max(to, dot(mark - action.at, action.along));
        }
        if (from > to) return;
        const Interval seen = within(view_, action.at, action.along);
        from = std::max(from - line_overshoot, seen.from), to = std::min(to + line_overshoot, seen.to);
        if (to - from < 1) return;
        layer.emplace_back(line(action.at + from * action.along, action.at + to * action.along, sketch_.axis()));
        belong(layer, layer.size() - 1, action.statement);
        hang(layer, layer.size() - 1, held(action));
        // Beyond the points that it joins, towards which the force acts.
        for (LabelRequest name : action.names) {
            name.toward = action.at + to * action.along;
            name.anchor = *name.toward - std::min(0.5 * line_overshoot, 0.5 * (to - from)) * action.along;
            sketch_.labels.push_back(std::move(name));
        }
    }
    static Holds held(const ActionLine& action) {
        Holds holds{Form::line, action.forces, line_overshoot};
        holds.on.emplace_back();
        holds.on.insert(holds.on.end(), action.places.begin(), action.places.end());
        return holds;
    }

    Sketch& sketch_;
    Box view_;
    std::string load_;
    std::vector<ActionLine> lines_;
    std::vector<Bar> pointers_;
};

/// Where teeth mesh: the common tangent of the pitch curves, and the pressure angle between it and the line of action.
void draw_pressure_angle(Sketch& sketch, const AppliedForce& applied) {
    if (applied.joint == none || applied.force.is_zero()) return;
    const Joint& joint = sketch.mechanism.joint(applied.joint);
    if (!joint.pair().meshes()) return;
    constexpr double reach = 20, radius = 16;  // outside the teeth
    const Spot at = sketch.spot(joint), force = paper_direction(applied.force);
    Spot tangent = paper_direction(sketch.subject.solution.pose.tangents[at_index(applied.joint)]);
    if (dot(tangent, force) < 0) tangent = -1.0 * tangent;
    const double from = angle_of(tangent), by = nearest::atan2(cross(tangent, force), dot(tangent, force));
    if (std::abs(by) < 1e-9) return;
    const std::size_t first = sketch.construction.size();
    sketch.construction.emplace_back(line(at - reach * tangent, at + reach * tangent, sketch.thin()));
    sketch.construction.emplace_back(line(at, at + reach * force, sketch.axis()));
    sketch.construction.emplace_back(render::arc(at, radius, from, from + by, sketch.thin()));
    belong(sketch.construction, first, applied.line_statement);
    LabelRequest& label =
        sketch.add_label(one_piece(given_number(std::abs(by) * 180 / pi_number, sketch.context.language) + "°"),
                         sketch.theme.secondary, at + radius * polar_spot(from + by / 2), 0.8, applied.line_statement);
    label.toward = at + (radius + 4) * polar_spot(from + by / 2);
    label.size = sketch.theme.small;
}

// --- arrows

/// The arc of a couple, and the line that its name takes beside the middle of it.
struct CoupleArc {
    Arc arc;
    Bar name;
};

/// About the point of application, where arc and name cross least.
CoupleArc free_couple_arc(const Sketch& sketch, const Clutter& clutter, const RichText& text, Spot at, bool positive) {
    constexpr double sweep = 2.4;
    // y is downwards on paper: counter-clockwise is the negative sense.
    const double by = positive ? -sweep : sweep;
    constexpr double of_crossing = 4, of_covered_name = 2, of_millimetre = 0.02;
    const double half = 0.5 * sketch.context.fonts.shape(text, sketch.theme.label).width;
    const auto room_of_name = [&](double radius, double from) {
        constexpr double gap = 3;
        const Spot out = polar_spot(from + by / 2);
        const Spot middle = at + (radius + gap) * out + Spot{half * std::clamp(2 * out.x, -1.0, 1.0), 0};
        return Bar{middle - Spot{half, 0}, middle + Spot{half, 0}};
    };
    const auto past_the_side = [view = sketch.mechanism_box()](const Bar& name) {
        return std::max(0.0, view.min.x - name.from.x) + std::max(0.0, name.to.x - view.max.x);
    };
    Cheapest<CoupleArc> best;
    for (const double radius : {7.0, 8.5, 10.5})
        for (int step = 0; step < 12; ++step) {
            const double from = step * pi_number / 6;
            const Bar name = room_of_name(radius, from);
            double price = 0.15 * (radius - 7) / 3.5 + of_millimetre * past_the_side(name);
            if (price < best.price) price += of_covered_name * clutter.along(name.from, name.to);
            if (price >= best.price) continue;
            const double enough = (best.price - price) / of_crossing;
            best.offer(price + of_crossing * clutter.along_arc(at, radius, from, by, enough),
                       {{at, radius, from, from + by}, name});
        }
    return best.choice;
}

/// `held`: bindings of point and couple; `unit`: of the moment in the text, in SI; 0: no value.
void draw_couple(Sketch& sketch, Clutter& clutter, const RichText& text, const CoupleArc& at, const BodyColour& colour,
                 StatementIndex statement, std::vector<std::string> held, double unit) {
    const Arc& arc = at.arc;
    const std::size_t first = sketch.arrows.size();
    draw_arc_arrow(sketch.arrows, arc.centre, arc.radius, arc.from, arc.to, 0.5, colour.line);
    belong(sketch.arrows, first, statement);
    hang(sketch.arrows, first, {Form::couple, held});
    clutter.add_arc(arc.centre, arc.radius, arc.from, arc.to - arc.from);
    clutter.add(at.name.from, at.name.to);
    const Spot out = polar_spot(0.5 * (arc.from + arc.to)), middle = arc.centre + arc.radius * out;
    LabelRequest& label = sketch.add_label(text, colour.letter, middle, 1.5, statement);
    label.toward = middle + 4.0 * turned(out);
    label.holds = {Form::couple, std::move(held), 0, unit};
}

RichText couple_words(const DrawingContext& context, const AppliedForce& applied) {
    const Unit& unit = context.solution.mechanism.units.moment;
    RichText text = typeset(couple_symbol(applied), context.language);
    // With its sign, as in the table of results and at an angular velocity.
    const double value = (applied.couple / unit.si).to_double();
    append(text, with_powers(" = " + number(value, 4, context.language) + " " + unit.symbol));
    return text;
}

/// A thin line from the moment centre to the line of a force, with its length.
void draw_arm(Sketch& sketch, const FreeBody& body, std::size_t index, const std::string& load,
              std::vector<Bar>& drawn) {
    const FreeBody::Arm& arm = body.arms[index];
    const Spot about = sketch.spot(arm.about), foot = sketch.spot(arm.foot);
    const Box view = grown(sketch.mechanism_box(), line_overshoot + 3);
    if (!contains(view, about) || !contains(view, foot) || length(foot - about) < 1) return;
    const auto same = [&](const Bar& other) {
        return length(other.from - about) < 0.05 && length(other.to - foot) < 0.05;
    };
    if (std::any_of(drawn.begin(), drawn.end(), same)) return;
    drawn.push_back({about, foot});
    sketch.over_bodies.emplace_back(line(about, foot, sketch.thin()));
    belong(sketch.over_bodies, sketch.over_bodies.size() - 1, arm.statement);
    const Holds held{Form::segment, {arm_binding(load, body, index, false), arm_binding(load, body, index, true)}};
    hang(sketch.over_bodies, sketch.over_bodies.size() - 1, held);
    if (!name_of_point_at(sketch, about) && !arm.name.empty())
        draw_meet(sketch, arm.name, about, arm.statement, held.on.front());
    const Unit& unit = sketch.mechanism.units.length;
    RichText text = one_piece(arm.is_shift ? "d" : "b", Face::italic);
    append(text, with_powers(
                     " = " +
                     number(kinegraph::length(arm.foot - arm.about) / unit.si.to_double(), 4, sketch.context.language) +
                     " " + unit.symbol));
    LabelRequest& label =
        sketch.add_label(std::move(text), sketch.theme.secondary, 0.5 * (about + foot), 1.0, arm.statement);
    label.size = sketch.theme.small;
    label.holds = held;
    label.holds.unit = unit.si.to_double();
}

constexpr double beside_an_arrow = 2.2;  // mm; distance from another arrow on the same line

/// Whether two arrows would be read as one: they overlap on one line, or leave one point in opposite directions.
bool reads_as_one(const Bar& one, const Bar& other) {
    const double size = length(one.to - one.from);
    if (!(size > 0)) return false;
    const Spot along = (1 / size) * (one.to - one.from);
    constexpr double on_line = 1.5, least = 0.5, apart = 1;
    for (const Spot end : {other.from, other.to})
        if (std::abs(cross(along, end - one.from)) > on_line) return false;
    const double from = dot(other.from - one.from, along), to = dot(other.to - one.from, along);
    if (to < from && std::abs(from) < apart) return true;
    return std::min(size, std::max(from, to)) - std::max(0.0, std::min(from, to)) > least;
}
bool reads_as_one(const Bar& arrow, const std::vector<Bar>& others) {
    return std::any_of(others.begin(), others.end(), [&](const Bar& other) { return reads_as_one(arrow, other); });
}
Bar moved(const Bar& arrow, Spot by) { return {arrow.from + by, arrow.to + by}; }

/// A resultant acts on nothing, so it has the colour of no body, and two heads.
BodyColour colour_of(const AppliedForce& applied, const Theme& theme, const BodyColour& body) {
    return applied.is_resultant() ? theme.colour_of(none) : body;
}
void draw_force_arrow(std::vector<Mark>& marks, const AppliedForce& applied, const Bar& arrow, double width,
                      Colour colour) {
    if (applied.is_resultant())
        draw_double_arrow(marks, arrow.from, arrow.to, width, colour);
    else
        draw_arrow(marks, arrow.from, arrow.to, width, colour);
}

/// Moves a resultant along its line to a place where the line passes the body, if its components meet elsewhere.
AppliedForce beside_body(const Sketch& sketch, const FreeBody& body, AppliedForce sum) {
    const std::vector<PointIndex> points = points_of(sketch.mechanism, body);
    if (points.empty() || contains(grown(sketch.mechanism_box(), 3), sketch.spot(sum.at))) return sum;
    Vector middle;
    for (const PointIndex point : points) middle = middle + sketch.subject.solution.pose.at(point);
    const Exact count(static_cast<int>(points.size()));
    const Vector away = Vector{middle.x / count, middle.y / count} - sum.at;
    const Exact share = dot(away, sum.force) / dot(sum.force, sum.force);
    sum.at = {sum.at.x + share * sum.force.x, sum.at.y + share * sum.force.y};
    return sum;
}
/// The resultants of a body whose lines pass so near it that both can be seen in one figure. A couple moves a small
/// force far away; its value and its distance stand in the sentences.
std::vector<AppliedForce> near_sums(const Sketch& sketch, const FreeBody& body) {
    constexpr double sizes = 20;
    const Box box = sketch.mechanism_box();
    const double size = std::max({box.width(), box.height(), line_overshoot});
    std::vector<AppliedForce> near;
    for (const AppliedForce& sum : body.sums)
        if (AppliedForce moved = beside_body(sketch, body, sum);
            contains(grown(box, sizes * size), sketch.spot(moved.at)))
            near.push_back(std::move(moved));
    return near;
}

/// Whether the drawing uses the line of a resultant of a body: for a point of concurrency, an arm, a string, or a
/// further resultant.
bool is_line_used(const Sketch& sketch, const FreeBody& body, const AppliedForce& sum) {
    const Spot along = paper_direction(sum.force), at = paper_spot(sum.at);
    const auto passes = [&](const Vector& place) {
        return std::abs(cross(along, paper_spot(place) - at)) < near_a_line(sketch);
    };
    return body.funicular ||
           std::any_of(body.meets.begin(), body.meets.end(), [&](const auto& meet) { return passes(meet.place); }) ||
           std::any_of(body.arms.begin(), body.arms.end(),
                       [&](const auto& arm) { return !arm.is_shift && passes(arm.foot); }) ||
           std::any_of(body.sums.begin(), body.sums.end(),
                       [&](const auto& other) { return other.symbol != sum.symbol && passes(other.at); });
}
/// The resultants of a body that its lines of action show. A force with its couple, moved aside: where its new line is
/// used there; else its free body shows it, beside the sentence.
std::vector<AppliedForce> sums_on_mechanism(const Sketch& sketch, const FreeBody& body) {
    std::vector<AppliedForce> shown = near_sums(sketch, body);
    const auto idle = [&](const AppliedForce& sum) {
        return is_moved_aside(sum.symbol) && !is_line_used(sketch, body, sum);
    };
    shown.erase(std::remove_if(shown.begin(), shown.end(), idle), shown.end());
    return shown;
}

/// The name of a resultant, for its line; its place is found with the line.
LabelRequest label_of_line(const Sketch& sketch, const AppliedForce& sum, const std::string& held) {
    return {.text = typeset(sum.symbol, sketch.context.language),
            .size = sketch.theme.equation,
            .colour = sketch.theme.colour_of(none).letter,
            .is_of_vector = true,
            .clearance = 1.5,
            .statement = sum.force_statement,
            .names = {name_of(sum.symbol)},
            .holds = on_force(Form::with, held)};
}

bool acts_at_centre(const AppliedForce& applied) {
    return applied.kind == Quantity::Kind::weight || applied.kind == Quantity::Kind::inertia;
}

// --- free bodies

/// The scale of forces, and which values are shown.
struct ForceScale {
    double si = 1;          // SI value of the unit
    double per_millimetre;  // in the unit
    bool says_values;       // where they have room; the table of results has them
    bool at_pairs;          // also shows force and couple of a sleeve at its pair
};

class FreeBodyDrawing {
public:
    FreeBodyDrawing(Sketch& sketch, const LoadCase& loads, const FreeBody& body, const ForceScale& scale)
        : sketch_(sketch),
          body_(body),
          scale_(scale),
          unit_(sketch.mechanism.units.force),
          colour_(sketch.theme.colour_of(body.body)),
          load_(loads.load()),
          meets_(shown_meets(sketch.subject.solution, body)),
          sums_(near_sums(sketch, body)),
          lines_(sketch, view_of(sketch, sums_), load_) {}

    /// Whether a force is shorter than its arrow's head, so that its arrow is thin and says the value.
    bool draw() {
        if (body_.body != none)
            draw_alone(sketch_, body_.body);
        else
            sketch_.pins.emplace_back(ring(sketch_.spot(body_.pin), 1.8, sketch_.theme.paper, sketch_.outline()));
        if (body_.body == none) hang(sketch_.pins, sketch_.pins.size() - 1, at_place(point_binding(body_.pin)));
        name_points(sketch_);
        for (const Load& load : sketch_.mechanism.loads)
            if (const auto* distributed = std::get_if<DistributedLoad>(&load);
                distributed != nullptr && distributed->body == body_.body)
                draw_distributed(sketch_, *distributed, sketch_.over_bodies);
        clutter_.add(sketch_.bodies);
        // Where no force is seen, the figure is narrow: the couples have their names only, the table their values.
        const bool says_couples =
            scale_.says_values && std::any_of(body_.forces.begin(), body_.forces.end(),
                                              [this](const AppliedForce& each) { return is_seen(each.force); });
        for (const AppliedForce& applied : body_.forces)
            if (!applied.force.is_zero()) draw_force(applied, force_binding(load_, body_, applied));
        // An arc goes round what stands about its point.
        for (const AppliedForce& applied : body_.forces) {
            if (applied.couple.is_zero()) continue;
            const std::string couple = couple_of(force_binding(load_, body_, applied));
            const RichText text = says_couples ? couple_words(sketch_.context, applied)
                                               : typeset(couple_symbol(applied), sketch_.context.language);
            draw_couple(sketch_, clutter_, text,
                        free_couple_arc(sketch_, clutter_, text, sketch_.spot(applied.at), applied.couple.sign() > 0),
                        colour_, applied.force_statement, {couple, couple}, says_couples ? unit_of_moment() : 0);
        }
        // What acts is drawn with an arrow, once. A resultant has its line and its name; the polygon has its arrow. One
        // force moved by a couple has none there.
        for (const AppliedForce& sum : sums_) {
            const std::string held = sum_binding(load_, body_, sum);
            if (std::any_of(body_.forces.begin(), body_.forces.end(),
                            [&](const AppliedForce& f) { return f.force == sum.force; }))
                draw_force(sum, held);
            else
                add_line_of(sum, held, label_of_line(sketch_, sum, held));
        }
        for (std::size_t i = 0; i < body_.arms.size(); ++i) draw_arm(sketch_, body_, i, load_, arms_);
        if (body_.funicular) draw_strings_of_body(*body_.funicular);
        lines_.draw_meets(meets_);
        lines_.draw(sketch_.over_bodies);
        for (const AppliedForce& applied : body_.forces) draw_pressure_angle(sketch_, applied);
        return !thin_.empty();
    }

private:
    /// Of the lines of action: with the places of the resultants, or their lines would end before them.
    static Box view_of(const Sketch& sketch, const std::vector<AppliedForce>& sums) {
        Box view = sketch.mechanism_box();
        for (const AppliedForce& sum : sums) view.include(sketch.spot(sum.at));
        return grown(view, line_overshoot + 3);
    }
    /// Whether the arrow is longer than a line is thick.
    bool is_seen(const Vector& force) const {
        return length(force) / unit_.si.to_double() > 0.5 * scale_.per_millimetre;
    }
    double unit_of_moment() const { return sketch_.mechanism.units.moment.si.to_double(); }
    void draw_force(const AppliedForce& applied, const std::string& held) {
        const double value = kinegraph::length(Vector{applied.force.x / unit_.si, applied.force.y / unit_.si});
        // A force shorter than its arrowhead is drawn as a thin arrow of fixed length with its value.
        constexpr double least_to_scale = 4, only_sense = 9;
        const bool to_scale = value / scale_.per_millimetre >= least_to_scale;
        const Bar arrow = free_stand(applied, to_scale ? value / scale_.per_millimetre : only_sense);
        standing_.push_back(arrow);
        clutter_.add(arrow.from, arrow.to);
        draw_arrow_of(applied, held, arrow, value, to_scale);
        add_line_of(applied, held);
        if (applied.is_component) return;
        // The forces at the pairs are those of all loads.
        bool is_dimensioned = false;
        if (scale_.at_pairs && load_.empty())
            if (const JointForce* pair = at_the_pair(sketch_.subject.solution, body_, applied))
                is_dimensioned = draw_at_pair(applied, *pair, arrow);
        if (applied.joint != none && joints_remarked_.insert(applied.joint).second)
            remark_guide(applied, arrow, is_dimensioned);
    }

    /// The arrow with its tail or tip at the point of application, or moved along its line if another arrow is there.
    Bar free_stand(const AppliedForce& applied, double size) const {
        const Spot at = sketch_.spot(applied.at), along = paper_direction(applied.force), d = size * along;
        const Spot middle = body_.body != none ? sketch_.shape(body_.body).middle : sketch_.spot(body_.pin);
        const bool outwards = acts_at_centre(applied) || dot(along, at - middle) >= -1e-6;
        Cheapest<Bar> best;
        for (const bool slid : {false, true})
            for (const bool pulls : {outwards, !outwards}) {
                Bar tried = pulls ? Bar{at, at + d} : Bar{at - d, at};
                double price = (pulls == outwards ? 0 : 0.35) + (slid ? 0.5 : 0) +
                               0.8 * clutter_.along(tried.from + 0.1 * d, tried.to - 0.1 * d);
                if (slid) {
                    const double sense = pulls ? 1 : -1, beyond = beyond_others(at, sense * along);
                    if (beyond <= 0) continue;
                    const Spot shift = (sense * (beyond + 2.5)) * along;
                    tried = {tried.from + shift, tried.to + shift};
                }
                best.offer(price + 3 * overlaps(tried, at, along), tried);
                if (slid || pulls != outwards || !reads_as_one(tried, standing_)) continue;
                for (const double side : {beside_an_arrow, -beside_an_arrow})
                    if (const Bar beside = moved(tried, side * turned(along));
                        !reads_as_one(beside, standing_) && keeps_its_side(applied, side * turned(along)))
                        best.offer(price + 0.3, beside);
            }
        return best.choice;
    }
    /// Whether an arrow moved aside turns about the points of the body, and those where other forces act, in the sense
    /// in which its force does.
    bool keeps_its_side(const AppliedForce& applied, Spot aside) const {
        const Spot along = paper_direction(applied.force), at = paper_spot(applied.at);
        const auto keeps = [&](Spot point) {
            const double arm = cross(along, point - at);
            return std::abs(arm) < near_a_line(sketch_) || arm * (arm - sketch_.scale() * cross(along, aside)) > 0;
        };
        const std::vector<PointIndex> points = points_of(sketch_.mechanism, body_);
        return std::all_of(points.begin(), points.end(),
                           [&](PointIndex point) { return keeps(sketch_.subject.points[at_index(point)]); }) &&
               std::all_of(body_.forces.begin(), body_.forces.end(),
                           [&](const AppliedForce& other) { return keeps(paper_spot(other.at)); });
    }
    std::vector<Bar> standing_on(Spot at, Spot along) const {
        std::vector<Bar> there;
        for (const Bar& other : standing_)
            if (std::abs(cross(along, other.from - at)) <= 1.5 && std::abs(cross(along, other.to - at)) <= 1.5)
                there.push_back(other);
        return there;
    }
    /// How far along a line the arrows on it extend from the point.
    double beyond_others(Spot at, Spot along) const {
        double beyond = 0;
        for (const Bar& other : standing_on(at, along))
            for (const Spot end : {other.from, other.to}) beyond = std::max(beyond, dot(end - at, along));
        return beyond;
    }
    int overlaps(const Bar& tried, Spot at, Spot along) const {
        const auto run = [&](const Bar& bar) {
            const double a = dot(bar.from - at, along), b = dot(bar.to - at, along);
            return Interval{std::min(a, b), std::max(a, b)};
        };
        int count = 0;
        for (const Bar& other : standing_on(at, along))
            if (std::min(run(other).to, run(tried).to) - std::max(run(other).from, run(tried).from) > 0.5 ||
                reads_as_one(tried, other))
                ++count;
        return count;
    }

    std::string unique_name(const std::string& base) {
        std::string unique = base;
        for (int n = 2; !names_.insert(unique).second; ++n) unique = base + "-" + std::to_string(n);
        return unique;
    }
    void draw_arrow_of(const AppliedForce& applied, const std::string& held, const Bar& arrow, double value,
                       bool to_scale) {
        const Theme& theme = sketch_.theme;
        const StatementIndex statement = applied.force_statement;
        const std::string unique = unique_name(name_of(applied.symbol));
        sketch_.arrows.emplace_back(GroupBegin{to_scale ? "vector" : "sense",
                                               sketch_.id("", unique),
                                               unique + " = " + shortest(value) + " " + unit_.symbol,
                                               {{"data-name", unique}, {"data-value", shortest(value)}},
                                               statement,
                                               on_force(to_scale ? Form::arrow : Form::with, held)});
        if (to_scale) sketch_.arrows.emplace_back(Axis{arrow.from, arrow.to});
        const BodyColour colour = colour_of(applied, theme, colour_);
        draw_force_arrow(sketch_.arrows, applied, arrow, to_scale ? theme.vector : theme.outline, colour.line);
        sketch_.arrows.emplace_back(GroupEnd{});
        RichText text = typeset(applied.symbol, sketch_.context.language);
        // Nothing else at the figure says how long such an arrow would be. A force that is drawn again where a couple
        // moves it has its value once.
        const bool says_value = !to_scale && thin_.insert(name_of(where_it_acts(applied.symbol))).second;
        if (says_value)
            append(text, with_powers(" = " + number(value, 4, sketch_.context.language) + " " + unit_.symbol));
        LabelRequest& label = sketch_.add_label(std::move(text), colour.letter, middle(arrow), 1.5, statement);
        label.size = theme.equation;
        label.toward = arrow.to;
        label.is_of_vector = true;
        label.holds = on_force(to_scale ? Form::arrow : Form::with, held);
        if (says_value) label.holds.unit = unit_.si.to_double();
    }

    /// Two forces on one line; with a couple on two parallel lines, whose distance is the arm.
    bool carries_two_forces() const {
        return std::count_if(body_.forces.begin(), body_.forces.end(),
                             [](const AppliedForce& f) { return !f.force.is_zero(); }) == 2;
    }
    void add_line_of(const AppliedForce& applied, const std::string& held, std::optional<LabelRequest> name = {}) {
        ActionLine action = lines_.line_of(applied, meets_, held);
        if (name) action.names.push_back(std::move(*name));
        reach_feet(action, sketch_, body_, load_);
        // Extends the line to where the force is added to another.
        for (const AppliedForce& sum : body_.sums)
            if (const Spot at = sketch_.spot(sum.at);
                &sum != &applied && std::abs(cross(action.along, at - action.at)) < 0.05 &&
                contains(sketch_.mechanism_box(), at) && length(at - action.at) > 1) {
                action.reach(at, sum_binding(load_, body_, sum));
                action.statement =
                    action.statement == none ? sum.force_statement : std::min(action.statement, sum.force_statement);
            }
        const bool found = applied.joint != none || applied.is_resultant();
        if (action.joins() || carries_two_forces() || (found && applied.line_by_construction))
            lines_.add(std::move(action));
    }

    /// Each string ends on the lines of its two forces.
    void draw_strings_of_body(const FreeBody::Funicular& funicular) {
        draw_strings(sketch_, funicular, load_);
        for (const AppliedForce& applied : body_.forces)
            if (!applied.force.is_zero())
                lines_.add_to_strings(applied, force_binding(load_, body_, applied), meets_, funicular);
    }

    /// Force and couple at the point of the pair, thin, and their distance from the equivalent single force: d = M/F.
    /// Whether the distance is drawn.
    bool draw_at_pair(const AppliedForce& applied, const JointForce& pair, const Bar& arrow) {
        const Spot at = sketch_.spot(sketch_.mechanism.joint(pair.joint).point), foot = sketch_.spot(applied.at);
        const double aside = length(foot - at);
        AppliedForce couple = applied;
        couple.couple = *pair.couple;
        const std::string point = point_binding(sketch_.mechanism.joint(pair.joint).point), held = pair_binding(pair);
        const RichText words = couple_words(sketch_.context, couple);
        draw_couple(sketch_, clutter_, words, free_couple_arc(sketch_, clutter_, words, at, pair.couple->sign() > 0),
                    colour_, applied.force_statement, {point, couple_of(held)}, unit_of_moment());
        constexpr double least = 2;
        if (aside < least || !contains(grown(sketch_.mechanism_box(), line_overshoot), foot)) return false;
        const std::size_t first = sketch_.arrows.size();
        const Bar there{at, at + (arrow.to - arrow.from)};
        // Grey: with its couple it stands for the single force, and does not act beside it.
        draw_arrow(sketch_.arrows, there.from, there.to, sketch_.theme.thin, sketch_.theme.secondary);
        belong(sketch_.arrows, first, applied.force_statement);
        hang(sketch_.arrows, first, {Form::arrow, {point, held}});
        LabelRequest& label = sketch_.add_label(typeset(applied.symbol, sketch_.context.language),
                                                sketch_.theme.secondary, middle(there), 1.5, applied.force_statement);
        label.toward = there.to;
        label.is_of_vector = true;
        label.holds = {Form::arrow, {point, held}};
        const Unit& unit = sketch_.mechanism.units.length;
        const double metres =
            kinegraph::length(applied.at - sketch_.subject.solution.pose.at(sketch_.mechanism.joint(pair.joint).point));
        const Spot off = -6.0 * unit_along_arrow(arrow);
        sketch_.construction.emplace_back(line(at + off, foot + off, sketch_.thin()));
        for (const Spot end : {at, foot}) sketch_.construction.emplace_back(line(end, end + 1.2 * off, sketch_.thin()));
        RichText text = one_piece("d", Face::italic);
        append(text, with_powers(" = " + number(metres / unit.si.to_double(), 4, sketch_.context.language) + " " +
                                 unit.symbol));
        sketch_
            .add_label(std::move(text), sketch_.theme.secondary, 0.5 * (at + foot) + off, 1.0, applied.force_statement)
            .size = sketch_.theme.small;
        return true;
    }
    static Spot unit_along_arrow(const Bar& arrow) {
        return (1 / length(arrow.to - arrow.from)) * (arrow.to - arrow.from);
    }

    /// It speaks of the force, and stands beside its arrow.
    void remark_guide(const AppliedForce& applied, const Bar& arrow, bool is_dimensioned) {
        const RichText words = beside_guide(sketch_.context, body_, applied, is_dimensioned);
        if (words.empty()) return;
        LabelRequest& label = sketch_.add_label(words, sketch_.theme.secondary, middle(arrow), 1.5);
        label.toward = arrow.to;
        label.size = sketch_.theme.small;
    }

    Sketch& sketch_;
    const FreeBody& body_;
    ForceScale scale_;
    const Unit& unit_;
    BodyColour colour_;
    std::string load_;
    Meets meets_;
    Clutter clutter_;
    std::vector<AppliedForce> sums_;
    ActionLines lines_;
    std::vector<Bar> standing_;  // the arrows drawn
    std::vector<Bar> arms_;
    std::set<std::string> names_;
    std::set<std::string> thin_;  // forces of which an arrow is not to scale
    std::set<JointIndex> joints_remarked_;
};

/// Shows only the points of the body.
void show_only(Subject& subject, const FreeBody& body) {
    std::fill(subject.shown.begin(), subject.shown.end(), false);
    const auto show = [&](PointIndex point) {
        if (point != none) subject.shown[at_index(point)] = true;
    };
    for (const PointIndex point : points_of(subject.mechanism, body)) show(point);
    for (const Mass& mass : subject.mechanism.masses)
        if (body.body != none && mass.body == body.body) show(mass.centre);
}

/// The loads of the mechanism that act.
std::function<bool(const DistributedLoad&)> loads_that_act(const LoadCase& loads) {
    return [&loads](const DistributedLoad& each) {
        return !loads.is_alone() || loads.solution().mechanism.body(each.body).name == loads.load();
    };
}

/// "Loads alone on body 3".
std::string words_of_load(const DrawingContext& context, const std::string& load) {
    const bool body = context.solution.mechanism.body_named(load).has_value();
    return word(lang::sheet::loads_alone, context.language) + " " +
           word(body ? lang::sheet::loads_of_body : lang::sheet::loads_of_pin, context.language) + " " + load;
}

/// The name of a free body: "2", "2: connecting rod", "pin B"; for the loads of one body alone with that body.
RichText caption_of(const DrawingContext& context, const FreeBody& body, const std::string& name,
                    const std::string& load) {
    RichText caption = one_piece(
        word(body.body != none ? lang::sheet::free_body : lang::sheet::free_pin, context.language) + " " + name);
    if (!load.empty()) {
        std::string words = words_of_load(context, load);
        words.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(words.front())));
        caption.back().text += word(lang::notation::semicolon, context.language) + words;
    } else if (body.body != none) {
        if (const std::string& label = in(context.solution.mechanism.body(body.body).label, context.language);
            !label.empty())
            caption.back().text += word(lang::notation::colon, context.language) + label;
    }
    return caption;
}

// --- the mechanism with its forces

/// True for loads, input forces and couples, and reactions of the frame; an actuator between two bodies is shown once.
/// `alone`: for the loads of one body alone, where bodies with two forces have no figure of their own.
bool is_shown_on_mechanism(const FreeBody& body, const AppliedForce& applied, bool alone) {
    const auto forces =
        std::count_if(body.forces.begin(), body.forces.end(), [](const AppliedForce& f) { return !f.force.is_zero(); });
    const bool inner_reaction = applied.is_reaction() && applied.from != frame && !(alone && forces == 2);
    const bool again = applied.kind == Quantity::Kind::effort && applied.from > frame && applied.from < body.body;
    return !inner_reaction && !again;
}

/// The length on paper of the rope of which it is the pull; 0: it is no pull between two points.
double rope_of(const Sketch& sketch, const AppliedForce& applied) {
    for (const Load& load : sketch.mechanism.loads)
        if (const auto* pull = std::get_if<SpringLoad>(&load);
            pull != nullptr && !pull->elastic && pull->magnitude.sign() > 0 && pull->name == name_of(applied.symbol))
            return length(sketch.spot(pull->between[1]) - sketch.spot(pull->between[0]));
    return 0;
}

/// An arrow of fixed length at a distance from its point, pulling or pushing, where it crosses least. `rope`: that
/// pulls. The two arrows stand on its halves if these have room for them; on a shorter one their heads would nearly
/// meet, as those of a bar in tension, so that they push from outside, as a hand does.
Bar free_arrow(const Clutter& clutter, const AppliedForce& applied, Spot at, const std::vector<Bar>& standing,
               double rope) {
    const std::vector<double> stand_offs =
        acts_at_centre(applied) ? std::vector<double>{2.2} : std::vector<double>{2.4, 7.0};
    constexpr double longest = 20, shortest = 12, on_short_rope = 3;
    const double whole = rope > 0 ? std::clamp(0.5 * rope, shortest, longest) : longest;
    const Spot along = paper_direction(applied.force);
    const bool at_centre = acts_at_centre(applied);
    if (0.5 * rope > 2 * stand_offs.front() + longest) {
        const Spot tail = at + stand_offs.front() * along;
        return {tail, tail + whole * along};
    }
    Cheapest<Bar> best;
    for (const double stand_off : stand_offs)
        for (const bool pulls : {true, false}) {
            const Spot tail = pulls ? at + stand_off * along : at - (stand_off + whole) * along;
            const Bar arrow{tail, tail + whole * along};
            double price = clutter.along(arrow.from, arrow.to) + 0.03 * stand_off;
            if (at_centre && !pulls) price += 0.6;
            if (applied.is_reaction() && pulls) price += 0.15;
            if (rope > 0 && pulls) price += on_short_rope;
            for (const double side : {0.0, beside_an_arrow, -beside_an_arrow}) {
                const Bar tried = moved(arrow, side * turned(along));
                const bool is_free = side == 0 || reads_as_one(arrow, standing);
                if (is_free) best.offer(price + (side == 0 ? 0 : 0.3) + (reads_as_one(tried, standing) ? 3 : 0), tried);
            }
        }
    return best.choice;
}

/// Whether an arrow reads as a continuation of another on its line.
bool continues(const Bar& arrow, const Bar& other) {
    constexpr double on_line = 1.5, gap = 6;
    const Spot along = (1 / length(arrow.to - arrow.from)) * (arrow.to - arrow.from);
    for (const Spot end : {other.from, other.to})
        if (std::abs(cross(along, end - arrow.from)) > on_line) return false;
    const double from = dot(other.from - arrow.from, along), to = dot(other.to - arrow.from, along);
    return std::max(from, to) > -gap && std::min(from, to) < length(arrow.to - arrow.from) + gap;
}

/// A resultant acts at no point, so its arrow may stand anywhere on its line: at its place or at a point of
/// concurrency, where it crosses least, hides no point, and is not taken for a part of another arrow.
Bar arrow_of_resultant(const Sketch& sketch, const Clutter& clutter, const AppliedForce& sum, const Meets& meets,
                       const Box& view, const std::vector<Bar>& standing) {
    constexpr double whole = 20, about_point = 2.0, of_other_place = 0.05;
    constexpr double as_one = 3, continued = 0.8, over_point = 0.8, beside = 0.6, outside = 0.4, of_tail = 2.5,
                     of_heads = 8, on_body = 0.3;
    const Spot at = sketch.spot(sum.at), along = paper_direction(sum.force);
    std::vector<Spot> places{at}, points;
    for (const FreeBody::Meet& meet : meets)
        if (const Spot spot = sketch.spot(meet.place); contains(view, spot)) {
            points.push_back(spot);
            if (std::abs(cross(along, spot - at)) < 0.05 && length(spot - at) > 1) places.push_back(spot);
        }
    for (const PointIndex point : indices_of(sketch.mechanism.points))
        if (sketch.subject.shown[at_index(point)]) points.push_back(sketch.spot(point));
    Cheapest<Bar> best;
    for (const Spot place : places)
        for (const double stand_off : {2.4, 7.0, 12.0, 17.0})
            for (const bool pulls : {true, false}) {
                const Spot tail = pulls ? place + stand_off * along : place - (stand_off + whole) * along;
                const Bar own{tail, tail + whole * along};
                for (const double side : {0.0, beside_an_arrow, -beside_an_arrow}) {
                    if (side != 0 && !reads_as_one(own, standing)) continue;
                    const Bar tried = moved(own, side * turned(along));
                    double price = clutter.along(tried.from, tried.to) + 0.03 * stand_off + (side == 0 ? 0 : beside) +
                                   (&place == &places.front() ? 0 : of_other_place);
                    if (!contains(view, tried.from) || !contains(view, tried.to)) price += outside;
                    if (reads_as_one(tried, standing)) price += as_one;
                    // An end on a body would be taken for a point where it acts.
                    for (const Bar& end :
                         {Bar{tried.from, tried.from + of_tail * along}, Bar{tried.to - of_heads * along, tried.to}})
                        price += clutter.along(end.from, end.to) > 0 ? on_body : 0;
                    for (const Bar& other : standing) price += continues(tried, other) ? continued : 0;
                    for (const Spot point : points) price += distance(point, tried) < about_point ? over_point : 0;
                    best.offer(price, tried);
                }
            }
    return best.choice;
}

/// The cylinder whose force it is; null: none.
const Cylinder* cylinder_of(const Sketch& sketch, const AppliedForce& applied) {
    if (applied.kind != Quantity::Kind::effort) return nullptr;
    for (const Cylinder& cylinder : sketch.cylinders())
        if (coincide(sketch.spot(sketch.mechanism.joint(cylinder.joint)), sketch.spot(applied.at))) return &cylinder;
    return nullptr;
}

/// Beside the barrel: rod and barrel fill the line of action, and beyond them are other bodies.
Bar arrow_beside(const Sketch& sketch, const Clutter& clutter, const Cylinder& cylinder, const AppliedForce& applied) {
    constexpr double whole = 20, off = 2.5, per_millimetre = 0.01;
    const Spot along = paper_direction(applied.force), across = turned(along);
    double half = 0;
    for (const Spot corner : corners_of_barrel(sketch, cylinder))
        half = std::max(half, std::abs(dot(corner - cylinder.barrel.from, across)));
    Cheapest<Bar> best;
    for (const double on : {0.0, 5.0, -5.0, 10.0, -10.0})
        for (const double side : {1.0, -1.0}) {
            const Spot at = middle(cylinder.barrel) + on * along + side * (half + off) * across;
            const Bar arrow{at - 0.5 * whole * along, at + 0.5 * whole * along};
            best.offer(clutter.along(arrow.from, arrow.to) + per_millimetre * std::abs(on), arrow);
        }
    return best.choice;
}

/// The arrow of a force that acts at a point.
Bar arrow_of_force(const Sketch& sketch, const Clutter& clutter, const AppliedForce& applied,
                   const std::vector<Bar>& standing) {
    const Cylinder* const cylinder = cylinder_of(sketch, applied);
    return cylinder != nullptr
               ? arrow_beside(sketch, clutter, *cylinder, applied)
               : free_arrow(clutter, applied, sketch.spot(applied.at), standing, rope_of(sketch, applied));
}

/// Draws only the sense of a force, at its arrow.
void draw_sense(Sketch& sketch, Clutter& clutter, const AppliedForce& applied, const BodyColour& body,
                StatementIndex statement, const std::string& held, const Bar& arrow) {
    const std::size_t first = sketch.arrows.size();
    const BodyColour colour = colour_of(applied, sketch.theme, body);
    draw_force_arrow(sketch.arrows, applied, arrow, sketch.theme.outline, colour.line);
    belong(sketch.arrows, first, statement);
    hang(sketch.arrows, first, on_force(Form::with, held));
    clutter.add(arrow.from, arrow.to);
    LabelRequest& label = sketch.add_label(typeset(applied.symbol, sketch.context.language), colour.letter,
                                           middle(arrow), 1.5, statement);
    label.size = sketch.theme.equation;
    label.toward = arrow.to;
    label.is_of_vector = true;
    label.names = {name_of(applied.symbol)};
    label.holds = on_force(Form::with, held);
}

/// Of bodies, where they are in view, and of bodies taken together.
void draw_resultants(Sketch& sketch, Clutter& clutter, const LoadCase& loads, const Meets& meets, const Box& view,
                     std::vector<Bar>& standing) {
    const BodyColour colour = sketch.theme.colour_of(none);
    const auto draw = [&](const AppliedForce& sum, const std::string& held) {
        if (sum.force.is_zero()) return;
        standing.push_back(arrow_of_resultant(sketch, clutter, sum, meets, view, standing));
        draw_sense(sketch, clutter, sum, colour, sum.force_statement, held, standing.back());
    };
    for (const FreeBody& body : loads.bodies())
        for (const AppliedForce& sum : sums_on_mechanism(sketch, body))
            if (contains(view, sketch.spot(sum.at))) draw(sum, sum_binding(loads.load(), body, sum));
    for (std::size_t i = 0; i < loads.together().size(); ++i)
        for (const AppliedForce& sum : loads.together()[i].sums) draw(sum, sum_binding(loads.load(), i, sum));
}

/// Those that the mechanism shows, after its forces. Their values stand at the free bodies: here they would make the
/// figure so wide that polygons become small.
void draw_couples(Sketch& sketch, Clutter& clutter, const LoadCase& loads) {
    for (const FreeBody& body : loads.bodies())
        for (const AppliedForce& applied : body.forces) {
            if (applied.couple.is_zero() || !is_shown_on_mechanism(body, applied, loads.is_alone())) continue;
            const RichText text = typeset(couple_symbol(applied), sketch.context.language);
            const std::string couple = couple_of(force_binding(loads.load(), body, applied));
            draw_couple(sketch, clutter, text,
                        free_couple_arc(sketch, clutter, text, sketch.spot(applied.at), applied.couple.sign() > 0),
                        sketch.theme.colour_of(body.body), applied.force_statement, {couple, couple}, 0);
        }
}

/// Whether the force acts on the bodies taken together from outside, and is therefore in their funicular polygon.
bool acts_from_outside(const AppliedForce& applied, const TakenTogether& together) {
    const FreeBody::Funicular& strings = *together.funicular;
    return applied.symbol == strings.first || applied.symbol == strings.second ||
           std::find(strings.known.begin(), strings.known.end(), applied.symbol) != strings.known.end();
}

/// For a resultant displaced by a couple: its line before (thin), the point on it where the lines of its components
/// meet, and the displacement, if it is visible.
void draw_shift(Sketch& sketch, const LoadCase& loads, const AppliedForce& sum, const Box& view) {
    const Protocol& protocol = loads.solution().protocol;
    for (const StatementIndex statement : indices_of(protocol.statements)) {
        const auto shift = shift_of(protocol, loads.bodies(), statement, sum);
        if (!shift) continue;
        const Spot to = sketch.spot(sum.at), from = sketch.spot(sum.at - *shift), along = paper_direction(sum.force);
        constexpr double least = 2;
        if (length(to - from) < least) continue;
        const Interval seen = within(view, from, along);
        if (!(seen.to - seen.from > line_overshoot)) continue;
        const std::size_t first = sketch.construction.size();
        sketch.construction.emplace_back(line(from + seen.from * along, from + seen.to * along, sketch.thin()));
        // Beside the mechanism, where both lines are free.
        const double at = seen.from + 0.12 * (seen.to - seen.from);
        const Spot one = from + at * along, other = one + (to - from);
        sketch.construction.emplace_back(line(one, other, sketch.thin()));
        for (std::size_t i = first; i < sketch.construction.size(); ++i) belong(sketch.construction, i, statement);
        const Unit& unit = sketch.mechanism.units.length;
        RichText text = one_piece("d", Face::italic);
        append(text,
               with_powers(" = " + number(kinegraph::length(*shift) / unit.si.to_double(), 4, sketch.context.language) +
                           " " + unit.symbol));
        sketch.add_label(std::move(text), sketch.theme.secondary, 0.5 * (one + other), 1.0, statement).size =
            sketch.theme.small;
    }
}

void draw_action_lines(Sketch& sketch, const LoadCase& loads, const Meets& meets, const Box& view,
                       std::vector<Bar>& pointers) {
    const Solution& solution = loads.solution();
    const std::string& load = loads.load();
    ActionLines lines(sketch, view, load);
    for (const FreeBody& body : loads.bodies())
        for (const AppliedForce& applied : body.forces) {
            if (applied.force.is_zero()) continue;
            ActionLine action = lines.line_of(applied, shown_meets(solution, body), force_binding(load, body, applied));
            if (action.joins() || applied.line_by_construction) lines.add(std::move(action));
        }
    for (const FreeBody& body : loads.bodies())
        for (const AppliedForce& sum : sums_on_mechanism(sketch, body)) {
            ActionLine action = lines.line_of(sum, meets, sum_binding(load, body, sum));
            reach_feet(action, sketch, body, load);
            lines.add(std::move(action));
        }
    const auto add_sum = [&](const AppliedForce& sum, std::string held) {
        if (ActionLine action = lines.line_of(sum, meets, std::move(held)); action.joins())
            lines.add(std::move(action));
    };
    for (std::size_t i = 0; i < loads.together().size(); ++i) {
        const TakenTogether& together = loads.together()[i];
        for (const AppliedForce& sum : together.sums) {
            add_sum(sum, sum_binding(load, i, sum));
            draw_shift(sketch, loads, sum, view);
        }
        if (!together.funicular) continue;
        draw_strings(sketch, *together.funicular, load);
        for (const FreeBody& body : loads.bodies())
            for (const AppliedForce& applied : body.forces)
                if (!applied.force.is_zero() && acts_from_outside(applied, together))
                    lines.add_to_strings(applied, force_binding(load, body, applied), shown_meets(solution, body),
                                         *together.funicular);
        for (const AppliedForce& sum : together.sums)
            if (acts_from_outside(sum, together))
                lines.add_to_strings(sum, sum_binding(load, i, sum), meets, *together.funicular);
    }
    lines.draw_meets(meets);
    lines.draw(sketch.construction);
    pointers = lines.pointers();
    // Once at each mesh: action and reaction have one line.
    std::set<JointIndex> meshes;
    for (const FreeBody& body : solution.free_bodies)
        for (const AppliedForce& applied : body.forces)
            if (applied.joint != none && meshes.insert(applied.joint).second) draw_pressure_angle(sketch, applied);
}

}  // namespace

namespace {

/// Of a free body without its forces, mm across. Names and arrows keep their size: a smaller body gains little space
/// for them, and the places of its forces would become one. Only where these would lie farther apart is it smaller.
constexpr double least_of_free_body = 12, farthest_forces = 100;

constexpr double least_of_longest = 12;  // mm, of the longest force on a free body that needs the room

double across(const Box& box) { return nearest::hypot(box.width(), box.height()); }

/// The coarsest scale of the series at which a free body is drawn, m per mm.
double coarsest_scale(const FreeExtent& extent) {
    const double size = across(extent.own);
    double scale = choose_scale(size, 0, least_of_free_body, least_of_free_body, std::nullopt);
    while (size / scale < least_of_free_body) scale = finer_scale(scale);
    while (across(extent.reach) / scale > farthest_forces) scale = next_scale(scale);
    return scale;
}

double longest_force(const FreeBody& body) {
    double longest = 0;
    for (const AppliedForce& applied : body.forces) longest = std::max(longest, kinegraph::length(applied.force));
    return longest;
}

double scale_within(const Box& box, Spot room) {
    return choose_scale(std::max(box.width(), 1e-9), std::max(box.height(), 1e-9), std::max(room.x, 10.0),
                        std::max(room.y, 10.0), std::nullopt);
}

/// Says in the caption that thin arrows are not to scale.
void say_thin(Figure& figure, const DrawingContext& context) {
    if (!figure.further_scale.empty()) figure.further_scale += ";  ";
    figure.further_scale += word(lang::sheet::thin_arrows_not_to_scale, context.language);
}

/// The scale in the file, where the longest arrow has room at it.
std::optional<double> kept_scale(const Mechanism& mechanism, double longest, Spot room) {
    const auto asked = asked_scale(mechanism, FigureKind::free_body);
    return asked && longest / *asked <= room.x + room.y ? asked : std::nullopt;
}

/// A free body with its forces in a room: the scale of its lengths and that of its forces are chosen apart.
class FreeBodyFigure {
public:
    FreeBodyFigure(const DrawingContext& context, FigureId id, Spot room, bool at_pairs)
        : context_(context),
          loads_(context.solution, id.part),
          body_(loads_.bodies()[at_index(id.of)]),
          unit_(context.solution.mechanism.units.force),
          blank_(begun(context, id)),
          room_(room),
          subject_(context.solution),
          extent_(extent_of_body(subject_, body_)),
          longest_(longest_force(body_) / unit_.si.to_double()),
          forces_{unit_.si.to_double(), 1, true, at_pairs} {
        subject_.box = extent_.all;
        show_only(subject_, body_);
    }

    Figure draw(const ScaleWish& wish) {
        const auto kept = kept_scale(context_.solution.mechanism, longest_ * forces_.si, room_);
        has_close_names_ = wish.arrow > 0 || wish.vectors > 0;
        forces_.per_millimetre = kept ? *kept / forces_.si : scale_of_forces(wish);
        // Short arrows are wanted where a page has no room for more.
        constexpr double short_arrow = 10;
        forces_.says_values = !(wish.arrow > 0 && wish.arrow < short_arrow);
        Figure figure = drawn(wish);
        // Where all has no room, values are left to the table of results …
        if (forces_.says_values && !has_room(figure)) {
            forces_.says_values = false;
            figure = drawn(wish);
        }
        // … and then forces become shorter, not the body.
        const bool is_fixed = kept || (wish.vectors > 0 && !(wish.arrow > 0));
        while (has_length() && !is_fixed && !has_room(figure) &&
               longest_ / next_scale(forces_.per_millimetre) >= least_of_longest) {
            forces_.per_millimetre = next_scale(forces_.per_millimetre);
            figure = drawn(wish);
        }
        return figure;
    }

private:
    /// A single block has no length; any scale would do.
    bool has_length() const { return across(extent_.own) > 0; }
    bool has_room(const Figure& figure) const {
        return figure.scale < any_scale && figure.box.width() <= room_.x && figure.box.height() <= room_.y;
    }
    double scale_of_forces(const ScaleWish& wish) const {
        if (!(longest_ > 0)) return 1;
        if (!(wish.arrow > 0) && wish.vectors > 0) return wish.vectors;
        if (wish.arrow > 0) {
            const double shown = scale_that_shows(longest_, wish.arrow);
            return wish.vectors > 0 ? std::min(shown, wish.vectors) : shown;
        }
        const double reach = std::clamp(0.42 * std::min(room_.x, room_.y), 15.0, 38.0);
        return choose_scale(longest_, 0, reach, reach, std::nullopt);
    }
    double first_scale(const ScaleWish& wish) const {
        constexpr double of_no_length = 120, below = 12;  // mm
        if (!has_length()) {
            const double size = subject_.size() > 0 ? subject_.size() : 1;
            return choose_scale(size, 0, of_no_length, of_no_length, std::nullopt);
        }
        if (wish.finest > 0) return wish.finest;
        const double around = std::min(30.0, longest_ / forces_.per_millimetre);
        return std::min(scale_within(extent_.all, {room_.x - around, room_.y - around - below}),
                        coarsest_scale(extent_));
    }
    Figure drawn(const ScaleWish& wish) const {
        const bool is_free = has_length() && !wish.exactly;
        const double size = across(extent_.own), first = first_scale(wish);
        // The last trial is that at the coarsest scale.
        const double coarsest = is_free ? std::max(coarsest_scale(extent_), first) : 0;
        return fit({.room = room_,
                    .first = first,
                    .strict = wish.strict,
                    .exactly = wish.exactly,
                    .extent = is_free ? size : 0,
                    .least_shown = is_free ? (1 - 1e-9) * size / coarsest : 0},
                   [&](const Trial& trial) { return at_scale(trial); });
    }
    Figure at_scale(const Trial& trial) const {
        Sketch sketch(subject_, context_, trial.scale, blank_.id);
        const bool thin = FreeBodyDrawing(sketch, loads_, body_, forces_).draw();
        Figure figure = sketch.finish(blank_, unit_.symbol);
        figure.scale = forces_.per_millimetre;
        if (has_length()) figure.further_scale = ratio_words(figure.places, context_.language);
        figure.caption = caption_of(context_, body_, name(), loads_.load());
        if (thin) say_thin(figure, context_);
        // Names stand close to the strokes, where the figure is not drawn for a room.
        constexpr Spot about_strokes{14, 16};
        Spot room = room_;
        if (has_close_names_) {
            const Box& strokes = figure.box;
            room.x = std::min(room.x, strokes.width() + about_strokes.x);
            room.y = std::min(room.y, strokes.height() + about_strokes.y);
        }
        sketch.close(figure, room, trial.last, forces_.per_millimetre * forces_.si, unit_, trial.last || trial.strict);
        return figure;
    }
    const std::string& name() const {
        const Mechanism& mechanism = context_.solution.mechanism;
        return body_.body != none ? mechanism.body(body_.body).name : mechanism.point(body_.pin).name;
    }

    const DrawingContext& context_;
    LoadCase loads_;
    const FreeBody& body_;
    const Unit& unit_;
    Figure blank_;
    Spot room_;
    Subject subject_;
    FreeExtent extent_;
    double longest_;  // of the forces, in their unit
    ForceScale forces_;
    bool has_close_names_ = false;
};

}  // namespace

Figure free_body_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y, bool at_pairs,
                        int part, const ScaleWish& wish) {
    return FreeBodyFigure(context, {FigureKind::free_body, static_cast<int>(index), part}, {room_x, room_y}, at_pairs)
        .draw(wish);
}

bool has_meets(const LoadCase& loads, bool of_several) {
    const Meets meets = all_shown_meets(loads);
    return std::any_of(meets.begin(), meets.end(), [&](const FreeBody::Meet& meet) {
        const auto shows = [&](const FreeBody& body) {
            const Meets own = shown_meets(loads.solution(), body);
            return std::any_of(own.begin(), own.end(), [&](const auto& each) { return each.name == meet.name; });
        };
        return !of_several || std::none_of(loads.bodies().begin(), loads.bodies().end(), shows);
    });
}

namespace {

/// The mechanism with lines of action and the senses of forces.
class ForcesOnMechanism {
public:
    ForcesOnMechanism(const DrawingContext& context, int part)
        : context_(context),
          loads_(context.solution, part),
          subject_(context.solution),
          meets_(all_shown_meets(loads_)),
          blank_(begun(context, {FigureKind::lines_of_action, -1, part})) {
        std::vector<Spot> places;
        for (const FreeBody::Meet& meet : meets_) places.push_back(paper_spot(meet.place));
        const Box near = grown(subject_.box, 0.7 * subject_.size());
        extent_ = with_near_places(subject_.box, std::move(places), growth_for_places * subject_.size());
        for (const TakenTogether& together : loads_.together())
            if (together.funicular) include_strings(extent_, *together.funicular, near);
    }

    Figure draw(Spot room, const ScaleWish& wish) const {
        const double first = choose_scale(extent_.width(), extent_.height(), std::max(room.x - 14, 10.0),
                                          std::max(room.y - 24, 10.0), std::nullopt);
        const FitPolicy policy{.room = room,
                               .first = std::max(first, wish.finest),
                               .asked = wish.asked,
                               .strict = wish.strict,
                               .exactly = wish.exactly};
        return fit(policy, [&](const Trial& trial) { return at_scale(trial, room); });
    }

private:
    Figure at_scale(const Trial& trial, Spot room) const {
        const std::string& load = loads_.load();
        Sketch sketch(subject_, context_, trial.scale, load.empty() ? "" : element_of("load", load));
        const auto acts = loads_that_act(loads_);
        draw_in_colour(sketch, acts);
        for (const Load& each : sketch.mechanism.loads)
            if (const auto* distributed = std::get_if<DistributedLoad>(&each); distributed && acts(*distributed))
                name_intensities(sketch, *distributed);
        name_points(sketch);
        Clutter clutter;
        clutter.add(sketch.bodies);
        clutter.add(sketch.ground);
        const Box drawn{(1 / trial.scale) * extent_.min, (1 / trial.scale) * extent_.max};
        const Box view = grown(drawn, line_overshoot + 4);
        std::vector<Bar> standing, pointers;
        draw_action_lines(sketch, loads_, meets_, view, pointers);
        for (const FreeBody& body : loads_.bodies())
            for (const AppliedForce& applied : body.forces)
                if (is_shown_on_mechanism(body, applied, !load.empty()) && !applied.force.is_zero()) {
                    standing.push_back(applied.is_resultant()
                                           ? arrow_of_resultant(sketch, clutter, applied, meets_, view, standing)
                                           : arrow_of_force(sketch, clutter, applied, standing));
                    draw_sense(sketch, clutter, applied, context_.theme.colour_of(body.body), applied.force_statement,
                               force_binding(load, body, applied), standing.back());
                }
        standing.insert(standing.end(), pointers.begin(), pointers.end());
        draw_resultants(sketch, clutter, loads_, meets_, view, standing);
        draw_couples(sketch, clutter, loads_);
        std::vector<Bar> arms;
        for (const FreeBody& body : loads_.bodies())
            for (std::size_t i = 0; i < body.arms.size(); ++i)
                if (!body.arms[i].is_shift) draw_arm(sketch, body, i, load, arms);
        Figure figure = sketch.finish(blank_, "m");
        if (loads_.is_alone()) figure.caption = one_piece(words_of_load(context_, load));
        if (!standing.empty()) figure.further_scale = word(lang::sheet::arrows_not_to_scale, context_.language);
        sketch.close(figure, room, trial.last || trial.asked, trial.scale, context_.solution.mechanism.units.length,
                     trial.strict);
        return figure;
    }

    const DrawingContext& context_;
    LoadCase loads_;
    Subject subject_;
    Meets meets_;
    Figure blank_;
    Box extent_;
};

}  // namespace

Figure mechanism_with_forces(const DrawingContext& context, double room_x, double room_y, int part,
                             const ScaleWish& wish) {
    return ForcesOnMechanism(context, part).draw({room_x, room_y}, wish);
}

namespace {

/// Brief: under a part of the loads, only if a free body does not show as much.
std::vector<int> lines_of_action(const Shown& shown, const LoadCase& loads) {
    if (loads.is_alone()) return once(!shown.is_brief || has_meets(loads, false));
    return once(!loads.bodies().empty());
}
void measure_lines_of_action(const Shown& shown, FigureId id, SizeWanted& size) {
    measure_mechanism(shown, id, size);
    if (id.part != all_loads) size.asked.reset();
}
Figure draw_lines_of_action(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    return mechanism_with_forces(shown.context, room.x, room.y, id.part, wish);
}

/// In the order of the bodies, pins after them. Under a part of the loads those that have a polygon.
std::vector<int> free_bodies(const Shown& shown, const LoadCase& loads) {
    std::vector<int> order;
    for (std::size_t i = 0; i < loads.bodies().size(); ++i)
        if (!loads.is_alone() || (!shown.is_brief && has_force_polygon(loads, loads.bodies()[i])))
            order.push_back(static_cast<int>(i));
    if (loads.is_alone()) return order;
    const auto rank = [&](int i) {
        const FreeBody& body = loads.bodies()[at_index(i)];
        return body.body == none ? 1 << 20 : body.body.number();
    };
    std::stable_sort(order.begin(), order.end(), [&](int one, int other) { return rank(one) < rank(other); });
    return order;
}
void measure_free_body(const Shown& shown, FigureId id, SizeWanted& size) {
    const LoadCase loads(shown.solution(), id.part);
    const FreeBody& body = loads.bodies()[at_index(id.of)];
    const FreeExtent extent = extent_of_body(Subject(shown.solution()), body);
    size.take(extent.all);
    size.subject = std::max(extent.own.width(), extent.own.height());
    size.asked.reset();  // that of its forces, not of its size
    // A longer link with two forces on one line shows no more: the space is better used for polygons.
    constexpr double enough_for_two_forces = 50;
    if (size.extent() > 0 && !has_force_polygon(loads, body)) size.enough = enough_for_two_forces;
}
Figure draw_free_body(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish) {
    return free_body_figure(shown.context, at_index(id.of), room.x, room.y, !shown.is_brief, id.part, wish);
}

}  // namespace

constinit const FigureFunctions lines_of_action_functions{lines_of_action, measure_lines_of_action,
                                                          draw_lines_of_action};
constinit const FigureFunctions free_body_functions{free_bodies, measure_free_body, draw_free_body};

}  // namespace kinegraph::render
