// Joints and points: pins, dots, clamps, centres of mass, springs between two points.
#include <algorithm>
#include <cmath>

#include "lang/keys/notation.hpp"
#include "render/mechanism/symbols.hpp"

namespace kinegraph::render::drawing {

namespace {

/// A pin of the body on which a block slides, hidden by the block.
bool covered_by_block(const Layout& layout, const Joint& hinge) {
    for (const Joint& joint : layout.mechanism.joints) {
        if (!is_slide(joint) || joint.bodies[0] == frame || layout.cylinder_of(joint)) continue;
        if (coincide(layout.spot(joint), layout.spot(hinge)) && !hinge.connects(joint.bodies[0]) &&
            hinge.connects(joint.bodies[1]))
            return true;
    }
    return false;
}

void draw_mass_centre(Sketch& sketch, Spot centre) {
    constexpr double radius = 1.9;
    sketch.pins.emplace_back(ring(centre, radius, sketch.theme.paper, sketch.outline()));
    for (const double from : {0.0, pi_number}) {
        Path quarter = filled({}, sketch.theme.text);
        quarter.segments = {MoveTo{centre}, LineTo{centre + radius * polar_spot(from)},
                            ArcTo{centre, radius, from, from + pi_number / 2}, Close{}};
        sketch.pins.emplace_back(std::move(quarter));
    }
}

}  // namespace

void draw_joints(Sketch& sketch) {
    std::vector<Spot> pinned;
    const double radius = sketch.measures.pin_radius;
    for (const Joint& joint : sketch.mechanism.joints) {
        const Spot at = sketch.spot(joint);
        std::string bodies;
        for (const BodyIndex body : joint.bodies)
            bodies += (bodies.empty() ? "" : " ") + sketch.mechanism.body(body).name;
        const std::string title = joint.name + word(lang::notation::colon, sketch.context.language) + bodies;
        const Holds held{Holds::Form::at, {point_binding(joint.point)}};
        sketch.pins.emplace_back(GroupBegin{"joint", sketch.id("joint", joint.name), title, {}, none, held});
        const bool already = std::any_of(pinned.begin(), pinned.end(), [&](Spot p) { return coincide(p, at); });
        const bool hinge = joint.pair().has_pin();
        if (hinge && !already && covered_by_block(sketch, joint)) {
            sketch.pins.emplace_back(circle(at, radius, {sketch.theme.outline, sketch.theme.text, {0.9, 0.5}, false}));
        } else if (hinge && !already) {
            sketch.pins.emplace_back(ring(at, radius, sketch.theme.paper, sketch.outline()));
            pinned.push_back(at);
        } else if (joint.pair().touches()) {
            draw_dot(sketch, at);
        }
        sketch.pins.emplace_back(GroupEnd{});
    }
}

void draw_point(Sketch& sketch, PointIndex point) {
    const std::size_t first = sketch.pins.size();
    if (sketch.subject.mass_centre[at_index(point)])
        draw_mass_centre(sketch, sketch.spot(point));
    else
        draw_dot(sketch, sketch.spot(point));
    hang(sketch.pins, first, {Holds::Form::at, {point_binding(point)}});
}

void draw_dot(Sketch& sketch, Spot at) {
    constexpr double radius = 0.65, halo = 0.35;
    const bool on_a_stroke = std::any_of(sketch.shapes().begin(), sketch.shapes().end(), [&](const Shape& shape) {
        return std::any_of(shape.strokes.begin(), shape.strokes.end(),
                           [&](const Bar& stroke) { return distance(at, stroke) < sketch.theme.link / 2; });
    });
    if (on_a_stroke) sketch.pins.emplace_back(tinted(disc(at, radius + halo, sketch.theme.paper)));
    sketch.pins.emplace_back(disc(at, radius, sketch.theme.text));
}

void draw_clamp(Sketch& sketch, const Joint& joint) {
    const Spot at = sketch.spot(joint);
    const std::vector<Spot> links = sketch.leaving(joint.point);
    const Spot along = links.empty() ? Spot{1, 0} : links.front();
    if (joint.connects(frame)) {
        const Spot half = sketch.measures.base_half * turned(along);
        draw_wall(sketch, {at + half, at - half}, -1.0 * along);
        return;
    }
    // Fills the corner between two links; for links in line, a patch over both.
    const auto other =
        std::find_if(links.begin(), links.end(), [&](Spot link) { return std::abs(cross(link, along)) > 0.2; });
    constexpr double leg = 5, half = 1.7;
    const std::vector<Spot> patch = other != links.end() ? std::vector<Spot>{at, at + leg * along, at + leg * *other}
                                                         : corners_about(at, half * along, half * turned(along));
    sketch.pins.emplace_back(filled(patch, sketch.theme.colour_of(joint.bodies[0]).line));
    hang(sketch.pins, sketch.pins.size() - 1, on_body(joint.bodies[0]));
}

namespace {

void draw_coil(Sketch& sketch, const SpringLoad& spring) {
    const Spot from = sketch.spot(spring.between[0]), to = sketch.spot(spring.between[1]);
    const Spot along = unit(to - from), across = turned(along);
    constexpr double pitch = 2.4, amplitude = 2.0, shortest = 8;
    constexpr int least_turns = 4;  // a short spring is not taken for a bar
    const double whole = length(to - from), straight = std::min(std::max(0.15 * whole, 2.5), 0.15 * whole + 0.5);
    std::vector<Spot> spots{from};
    if (const double coiled = whole - 2 * straight; whole > shortest) {
        const int turns = std::max(static_cast<int>(coiled / pitch), least_turns);
        const double step = coiled / turns;
        spots.push_back(from + straight * along);
        for (int i = 0; i < turns; ++i) {
            spots.push_back(from + (straight + (i + 0.25) * step) * along + amplitude * across);
            spots.push_back(from + (straight + (i + 0.75) * step) * along - amplitude * across);
        }
        spots.push_back(to - straight * along);
    }
    spots.push_back(to);
    sketch.ground.emplace_back(
        GroupBegin{"spring", sketch.id("spring", spring.name), spring.name, {}, none, between_ends(spring)});
    sketch.ground.emplace_back(polyline(spots, sketch.outline()));
    sketch.ground.emplace_back(GroupEnd{});
}

/// Two points that a force of a given magnitude pulls together, as a rope does. Thin, since it is no bar; below the
/// bodies and no obstacle: its two forces may stand on it.
void draw_pull(Sketch& sketch, const SpringLoad& pull) {
    std::vector<Mark>& marks = sketch.construction;
    marks.emplace_back(GroupBegin{"spring", sketch.id("spring", pull.name), pull.name, {}, none, between_ends(pull)});
    marks.emplace_back(line(sketch.spot(pull.between[0]), sketch.spot(pull.between[1]), sketch.thin()));
    marks.emplace_back(GroupEnd{});
}

}  // namespace

void draw_spring(Sketch& sketch, const SpringLoad& spring) {
    if (spring.elastic)
        draw_coil(sketch, spring);
    else if (spring.magnitude.sign() < 0)
        draw_gas_spring(sketch, spring);
    else
        draw_pull(sketch, spring);
    const Spot from = sketch.spot(spring.between[0]), to = sketch.spot(spring.between[1]), along = unit(to - from);
    const std::vector<Joint>& joints = sketch.mechanism.joints;
    for (const std::size_t end : {0U, 1U}) {
        const Spot at = end == 0 ? from : to, away = end == 0 ? -1.0 * along : along;
        const bool pinned = std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) {
            return is_fixed_pin(joint) && coincide(sketch.spot(joint), at);
        });
        const Spot half = sketch.measures.base_half * turned(away);
        if (spring.bodies[end] == frame && !pinned) draw_wall(sketch, {at + half, at - half}, away);
    }
}

}  // namespace kinegraph::render::drawing
