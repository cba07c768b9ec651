// Wheels, rollers, cams, sliding arcs, flat faces, and contacts without a given profile.
#include <algorithm>
#include <cmath>

#include "render/mechanism/symbols.hpp"

namespace kinegraph::render::drawing {

Path annulus(Spot centre, double inner, double outer, Colour tint) {
    Path path = tinted(disc(centre, outer, tint));
    path.segments.emplace_back(MoveTo{centre + Spot{inner, 0}});
    path.segments.emplace_back(ArcTo{centre, inner, 2 * pi_number, 0});
    path.segments.emplace_back(Close{});
    return path;
}

void draw_fixed_rim(Sketch& sketch, const Rim& rim, double radius, bool outside) {
    if (radius < 2) return;
    sketch.ground.emplace_back(circle(rim.centre, radius, sketch.outline()));
    hatch_arc(sketch, {rim.centre, radius, 0, 2 * pi_number}, outside);
}

namespace {

constexpr double least_with_hub = 6;  // least radius of a wheel with a hub, mm

/// Whether a wheel may have its hub there; false for an eccentric, whose body is hinged only elsewhere.
bool turns_about(const Layout& layout, Spot centre, BodyIndex body) {
    bool elsewhere = false;
    for (const Joint& joint : layout.mechanism.joints) {
        if (!joint.pair().is_hinge() || !joint.connects(body)) continue;
        if (coincide(layout.spot(joint), centre)) return true;
        elsewhere = elsewhere || joint.connects(frame);
    }
    return !elsewhere;
}

/// A direction for the spoke that is free of other strokes.
Spot free_spoke(const Layout& layout, const Rim& rim) {
    std::vector<Spot> taken;
    for (const Touch& touch : rim.touches)
        taken.push_back(unit(layout.spot(layout.mechanism.joint(touch.joint)) - rim.centre));
    for (const Joint& joint : layout.mechanism.joints)
        if (coincide(layout.spot(joint), rim.centre)) {
            for (const Spot link : layout.leaving(joint.point)) taken.push_back(link);
            if (is_fixed_pin(joint)) taken.push_back({0, 1});
        }
    Cheapest<Spot> spoke;
    for (int i = 0; i < 8; ++i) {
        const Spot along = polar_spot(pi_number * (0.75 + 0.25 * i));
        double price = 0;
        for (const Spot other : taken) price = std::max(price, dot(along, other));
        spoke.offer(price, along);
    }
    return spoke.choice;
}

/// The part of the arc that its contacts need.
Arc touched_arc(const Layout& layout, const Rim& rim) {
    double middle = 0, half = 0;
    for (std::size_t t = 0; t < rim.touches.size(); ++t) {
        const double angle = angle_of(layout.spot(layout.mechanism.joint(rim.touches[t].joint)) - rim.centre);
        if (t == 0) middle = angle;
        half = std::max(half, std::abs(std::remainder(angle - middle, 2 * pi_number)));
    }
    half = std::min(half + std::min(14.0 / rim.radius, 1.0), 2.8);
    return {rim.centre, rim.radius, middle - half, middle + half};
}

/// The body's corner nearest to the middle of the arc, and not on the arc.
std::optional<Spot> nearest_hold(const Layout& layout, BodyIndex body, Spot crown) {
    std::optional<Spot> hold;
    for (const PointIndex corner : layout.subject.corners[at_index(body)])
        if (const Spot at = layout.spot(corner);
            length(at - crown) > 3 && (!hold || length(at - crown) < length(*hold - crown) - 1e-9))
            hold = at;
    return hold;
}

/// An arc on which another body slides, connected to the nearest corner of its body: a sector, or a bow if the material
/// lies outside.
void draw_arc_profile(Sketch& sketch, const Rim& rim, BodyIndex body, std::vector<Mark>& marks) {
    Arc profile = touched_arc(sketch, rim);
    if (body == frame) {
        sketch.ground.emplace_back(arc(profile, sketch.outline()));
        hatch_arc(sketch, profile, rim.hollow);
        return;
    }
    const Theme& theme = sketch.theme;
    const BodyColour colour = theme.colour_of(body);
    const Pen heavy{theme.link, colour.line, {}, true};
    // The edge of the stroke is the profile, not its centre line.
    profile.radius += (rim.hollow ? 0.5 : -0.5) * theme.link;
    Path stroke = arc(profile, heavy);
    const double half = 0.5 * (profile.to - profile.from);
    const std::optional<Spot> hold = nearest_hold(sketch, body, profile.at(profile.from + half));
    // A corner inside the sector is connected to the whole arc, any other to one end.
    if (hold && !rim.hollow && length(*hold - rim.centre) < profile.radius - 2) {
        stroke.segments.emplace_back(LineTo{*hold});
        stroke.segments.emplace_back(Close{});
        Path tint = tinted(stroke);
        tint.stroked = false;
        tint.filled = true;
        tint.fill = colour.tint;
        sketch.tints.emplace_back(std::move(tint));
    } else if (hold) {
        const Spot first = profile.at(profile.from), last = profile.at(profile.to);
        marks.emplace_back(line(*hold, length(first - *hold) < length(last - *hold) ? first : last, heavy));
    }
    marks.emplace_back(std::move(stroke));
}

/// A cross at a centre of curvature that the file names and nothing else marks.
void mark_centre(Sketch& sketch, const Rim& rim, BodyIndex body) {
    for (const PointIndex point : indices_of(sketch.mechanism.points))
        if (sketch.subject.shows(point) && coincide(sketch.spot(point), rim.centre)) return;
    const double arm = std::min(2.2, 0.5 * rim.radius);
    const std::size_t first = sketch.construction.size();
    for (const Spot along : {Spot{arm, 0}, Spot{0, arm}})
        sketch.construction.emplace_back(line(rim.centre - along, rim.centre + along, sketch.thin()));
    hang(sketch.construction, first, on_body(body));
}

void draw_rim(Sketch& sketch, const Rim& rim, BodyIndex body, std::vector<Mark>& marks) {
    if (rim.form == Rim::Form::gear) return draw_gear(sketch, rim, body, marks);
    if (rim.form == Rim::Form::arc) return draw_arc_profile(sketch, rim, body, marks);
    if (body == frame) return draw_fixed_rim(sketch, rim, rim.radius, rim.hollow);
    const Pen edge = sketch.pen_of(body, sketch.theme.vector);
    const Colour tint = sketch.theme.colour_of(body).tint;
    if (rim.hollow) {
        const double outer = rim.radius + 3.2;
        sketch.tints.emplace_back(annulus(rim.centre, rim.radius, outer, tint));
        marks.emplace_back(circle(rim.centre, rim.radius, edge));
        marks.emplace_back(circle(rim.centre, outer, edge));
        return;
    }
    sketch.tints.emplace_back(tinted(disc(rim.centre, rim.radius, tint)));
    marks.emplace_back(circle(rim.centre, rim.radius, edge));
    const double end = rim.radius - sketch.theme.vector / 2;
    const bool hubbed = rim.form == Rim::Form::wheel && draw_hub(sketch, rim, end, body, marks);
    if (!hubbed) mark_centre(sketch, rim, body);
}

/// Circles under the frame's wall: the supported body may slide along it.
void draw_rollers(Sketch& sketch, Spot at, Spot tangent, Spot away) {
    const double radius = 1.6 * sketch.measures.shrink, half = sketch.theme.link / 2;
    sketch.ground.emplace_back(ring(at + (radius + half) * away, radius, sketch.theme.paper, sketch.outline()));
    const Spot foot = at + (2 * radius + half) * away, base = sketch.measures.base_half * tangent;
    draw_wall(sketch, {foot + base, foot - base}, away);
}

/// A contact with the frame: a wall for a round or rolling body, else a roller support.
void draw_bearing(Sketch& sketch, const Joint& joint, Spot tangent) {
    const BodyIndex other = joint.other_than(frame);
    const Spot at = sketch.spot(joint);
    Spot away = turned(tangent);
    if (joint.pushes)
        away = (joint.bodies[0] == frame ? 1.0 : -1.0) * paper_direction(*joint.pushes);
    else if (dot(bulk_of(sketch, other, joint) - at, away) > 0)
        away = -1.0 * away;
    const bool rounded = joint.profiles.count(other) != 0 && !is_tip(joint, other);
    if (rounded || joint.pair().rolls())
        draw_wall(sketch, {at - 16.0 * tangent, at + 16.0 * tangent}, away);
    else
        draw_rollers(sketch, at, tangent, away);
}

}  // namespace

/// No hub if the body's own points already show its rotation, or if the roller is small.
bool draw_hub(const Sketch& sketch, const Rim& rim, double end, BodyIndex body, std::vector<Mark>& marks) {
    if (!turns_about(sketch, rim.centre, body) || rim.radius < least_with_hub) return false;
    const BodyColour colour = sketch.theme.colour_of(body);
    const double hub = sketch.measures.pin_radius + 1.1;
    marks.emplace_back(ring(rim.centre, hub, colour.tint, {sketch.theme.outline, colour.line, {}, false}));
    const std::vector<Bar>& bars = sketch.shape(body).bars;
    if (std::any_of(bars.begin(), bars.end(), [](const Bar& bar) { return length(bar) > 1; })) return true;
    const Spot spoke = free_spoke(sketch, rim);
    marks.emplace_back(
        line(rim.centre + hub * spoke, rim.centre + end * spoke, {sketch.theme.vector, colour.line, {}, false}));
    return true;
}

void draw_profiles(Sketch& sketch, BodyIndex body, std::vector<Mark>& marks) {
    const Shape& shape = sketch.shape(body);
    for (const Rim& rim : shape.rims) draw_rim(sketch, rim, body, marks);
    for (const Flat& flat : shape.flats) {
        // The edge of the stroke is the profile, not its centre line.
        const Spot in = flat.depth * flat.inward;
        if (flat.rack)
            draw_rack(sketch, flat, body, marks);
        else if (body == frame)
            draw_wall(sketch, flat.bar, flat.inward);
        else
            marks.emplace_back(line(flat.bar.from + in, flat.bar.to + in,
                                    {sketch.theme.link, sketch.theme.colour_of(body).line, {}, true}));
    }
    draw_bare_contacts(sketch, body);
}

void draw_bare_contacts(Sketch& sketch, BodyIndex body) {
    for (const Joint& joint : sketch.mechanism.joints) {
        if (!joint.pair().touches() || joint.bodies.size() != 2 ||
            sketch.subject.solution.pose.tangents[at_index(sketch.mechanism.index_of(joint))].is_zero())
            continue;
        if (!joint.connects(body) || joint.profiles.count(body) != 0 || sketch.mechanism.body(body).circle) continue;
        const bool is_gear = joint.pair().meshes(), first = joint.bodies[0] == body;
        const Spot at = sketch.spot(joint), tangent = sketch.subject.tangent(joint);
        if (body == frame && !is_gear)
            draw_bearing(sketch, joint, tangent);
        else if (first && (is_gear || joint.bodies[1] != frame)) {
            sketch.construction.emplace_back(line(at - 10.0 * tangent, at + 10.0 * tangent, sketch.axis()));
            const JointIndex index = sketch.mechanism.index_of(joint);
            hang(sketch.construction, sketch.construction.size() - 1,
                 {Holds::Form::with, {point_binding(joint.point), tangent_binding(index)}});
        }
    }
}

}  // namespace kinegraph::render::drawing
