// The whole mechanism in colour or as a grey skeleton under vectors, or one free body.
#include <algorithm>

#include "engine/results/result_names.hpp"
#include "render/mechanism/symbols.hpp"

namespace kinegraph::render::drawing {

namespace {

void draw_frame(Sketch& sketch) {
    for (const Joint& joint : sketch.mechanism.joints) {
        if (is_fixed_pin(joint)) draw_fixed_pin(sketch, joint.point);
        if (joint.pair().is_clamp()) draw_clamp(sketch, joint);
        if (is_curved_slot(joint) && joint.bodies[1] == frame) draw_curved_slot(sketch, joint, sketch.ground);
    }
    draw_guides(sketch);
    std::vector<Mark> none;  // everything on the frame is drawn in the ground layer
    draw_profiles(sketch, frame, none);
}

/// Points that belong to no joint: mass centres and other points of a body.
void draw_free_points(Sketch& sketch) {
    const std::vector<Joint>& joints = sketch.mechanism.joints;
    for (const PointIndex point : indices_of(sketch.mechanism.points)) {
        const bool taken = std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) {
            return coincide(sketch.spot(joint), sketch.spot(point)) && !joint.pair().is_sleeve();
        });
        if (sketch.subject.shows(point) && !taken) draw_point(sketch, point);
    }
}

void draw_skeleton_of(Sketch& sketch, BodyIndex body, const Pen& thin) {
    const Shape& shape = sketch.shape(body);
    std::vector<Mark>& marks = sketch.bodies;
    for (const Joint& joint : sketch.mechanism.joints) {
        if (joint.pair().is_sleeve() && joint.bodies[0] == body && !sketch.cylinder_of(joint))
            marks.emplace_back(panel(sketch.corners_of_block(joint), sketch.theme.paper, thin));
    }
    for (const Cylinder& cylinder : sketch.cylinders())
        if (sketch.mechanism.joint(cylinder.joint).bodies[1] == body)
            marks.emplace_back(panel(corners_of_barrel(sketch, cylinder), sketch.theme.paper, thin));
    for (Path& rim : rims_in(shape, thin)) marks.emplace_back(std::move(rim));
    for (Path& stroke : strokes_in(shape, thin)) marks.emplace_back(std::move(stroke));
    for (const Bar& slot : shape.slots) marks.emplace_back(line(slot.from, slot.to, thin));
}

/// Draws all heavy strokes twice, wide in the line colour and narrower in the tint, which gives a common outline.
void draw_outline(Sketch& sketch, const Shape& shape, const std::vector<Path>& heavy, const BodyColour& colour) {
    const double width = 0.9 * sketch.theme.link, edge = sketch.theme.outline;
    for (const bool outside : {true, false}) {
        const Pen pen{outside ? width + 2 * edge : width, outside ? colour.line : colour.tint, {}, true};
        if (!outside && !shape.plate.empty()) sketch.bodies.emplace_back(tinted(filled(shape.plate, colour.tint)));
        draw_strokes(shape, pen, sketch.bodies);
        for (Path path : heavy) {
            path.pen = pen;
            sketch.bodies.emplace_back(std::move(path));
        }
    }
}

}  // namespace

/// Says of the marks from `first` on whose tints they are.
void own_tints(std::vector<Mark>& marks, std::size_t first, BodyIndex body) {
    for (std::size_t i = first; i < marks.size(); ++i)
        if (auto* path = std::get_if<Path>(&marks[i]); path != nullptr && path->tinted) path->tint_of = body;
}

void draw_in_colour(Sketch& sketch, const std::function<bool(const DistributedLoad&)>& acts) {
    draw_frame(sketch);
    for (const Load& load : sketch.mechanism.loads) {
        if (const auto* spring = std::get_if<SpringLoad>(&load)) draw_spring(sketch, *spring);
        if (const auto* torsion = std::get_if<TorsionLoad>(&load)) draw_torsion_spring(sketch, *torsion);
        const auto* distributed = std::get_if<DistributedLoad>(&load);
        if (distributed != nullptr && (!acts || acts(*distributed)))
            draw_distributed(sketch, *distributed, sketch.ground);
    }
    std::vector<BodyIndex> below;
    for (const BodyIndex body : drawing_order(sketch)) {
        if (body == frame) continue;
        const std::size_t tints = sketch.tints.size(), bodies = sketch.bodies.size();
        draw_link(sketch, body, below);
        own_tints(sketch.tints, tints, body);
        own_tints(sketch.bodies, bodies, body);
        below.push_back(body);
    }
    for (const BodyIndex body : sketch.mechanism.moving_bodies())
        if (name_of_bar(sketch.subject.solution, body) == nullptr) draw_balloon(sketch, body);
    draw_joints(sketch);
    draw_free_points(sketch);
}

void draw_in_grey(Sketch& sketch) {
    const Pen thin{sketch.theme.outline, sketch.theme.skeleton, {}, true};
    std::vector<Mark> none;  // everything on the frame is drawn in the ground layer
    draw_profiles(sketch, frame, none);
    sketch.construction.clear();
    for (const BodyIndex body : drawing_order(sketch)) {
        if (body == frame) continue;
        const std::string& name = sketch.mechanism.body(body).name;
        sketch.bodies.emplace_back(GroupBegin{"link", sketch.id("link", name), name, {}});
        draw_skeleton_of(sketch, body, thin);
        sketch.bodies.emplace_back(GroupEnd{});
    }
    for (const Joint& joint : sketch.mechanism.joints) {
        if (joint.pair().is_sleeve()) continue;
        sketch.pins.emplace_back(ring(sketch.spot(joint), 0.9, sketch.theme.paper, thin));
        if (is_fixed_pin(joint)) draw_fixed_pin(sketch, joint.point);
    }
    // What has a name is seen.
    draw_free_points(sketch);
}

void draw_alone(Sketch& sketch, BodyIndex body) {
    const std::string& name = sketch.mechanism.body(body).name;
    sketch.bodies.emplace_back(GroupBegin{"link", sketch.id("link", name), name, {}});
    std::vector<Mark> profiles;
    draw_profiles(sketch, body, profiles);
    sketch.construction.clear();
    std::vector<Path> heavy;
    for (const Mark& mark : profiles) {
        const auto* path = std::get_if<Path>(&mark);
        if (path && path->stroked && path->pen.width == sketch.theme.link)
            heavy.push_back(*path);
        else
            sketch.bodies.push_back(mark);
    }
    draw_outline(sketch, sketch.shape(body), heavy, sketch.theme.colour_of(body));
    for (const Cylinder& cylinder : sketch.cylinders())
        if (sketch.mechanism.joint(cylinder.joint).bodies[1] == body) draw_barrel(sketch, cylinder, sketch.bodies);
    draw_sliding_parts(sketch, body, sketch.bodies);
    sketch.bodies.emplace_back(GroupEnd{});
    std::vector<Spot> done;
    const auto once = [&](Spot at) {
        if (std::any_of(done.begin(), done.end(), [&](Spot other) { return coincide(other, at); })) return false;
        done.push_back(at);
        return true;
    };
    for (const Joint& joint : sketch.mechanism.joints) {
        const Spot at = sketch.spot(joint);
        if (!joint.connects(body) || joint.pair().is_sleeve() || !once(at)) continue;
        if (joint.pair().has_pin())
            sketch.pins.emplace_back(ring(at, 0.8 * sketch.measures.pin_radius, sketch.theme.paper, sketch.outline()));
        else
            draw_dot(sketch, at);
    }
    for (const PointIndex point : indices_of(sketch.mechanism.points))
        if (sketch.subject.shows(point) && once(sketch.spot(point))) draw_point(sketch, point);
}

}  // namespace kinegraph::render::drawing
