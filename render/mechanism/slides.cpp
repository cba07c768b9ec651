// Slides: blocks on their guides, cylinders, straight and curved slots.
#include "render/mechanism/symbols.hpp"

namespace kinegraph::render::drawing {

namespace {

void draw_piston(const Sketch& sketch, const Cylinder& cylinder, BodyIndex body, std::vector<Mark>& marks) {
    const Spot along = direction(cylinder.barrel);
    const double half = sketch.measures.sleeve_side - sketch.theme.vector / 2 - 0.25;
    marks.emplace_back(
        filled(corners_about(cylinder.piston, 1.2 * along, half * turned(along)), sketch.theme.colour_of(body).line));
}

/// The block of a slide, or the piston of a cylinder.
void draw_block(const Sketch& sketch, const Joint& slide, std::vector<Mark>& marks) {
    const BodyIndex body = slide.bodies[0];
    if (const Cylinder* cylinder = sketch.cylinder_of(slide)) return draw_piston(sketch, *cylinder, body, marks);
    marks.emplace_back(panel(sketch.corners_of_block(slide), sketch.theme.colour_of(body).tint,
                             sketch.pen_of(body, sketch.theme.vector)));
}

void draw_slot(const Sketch& sketch, const Bar& slot, BodyIndex body, std::vector<Mark>& marks) {
    const double side = sketch.measures.slot_side, a = angle_of(direction(slot));
    const Spot across = side * turned(direction(slot));
    Path path = panel({}, sketch.theme.paper, sketch.pen_of(body, sketch.theme.vector));
    path.segments = {MoveTo{slot.from + across}, ArcTo{slot.from, side, a + pi_number / 2, a + 3 * pi_number / 2},
                     LineTo{slot.to - across}, ArcTo{slot.to, side, a - pi_number / 2, a + pi_number / 2}, Close{}};
    marks.emplace_back(std::move(path));
}

}  // namespace

void draw_curved_slot(Sketch& sketch, const Joint& joint, std::vector<Mark>& marks) {
    const double side = sketch.measures.slot_side;
    const Arc slot = sketch.curved_slot(joint);
    if (slot.radius <= 0) return;
    const Arc outer{slot.centre, slot.radius + side, slot.from, slot.to};
    const Arc inner{slot.centre, slot.radius - side, slot.from, slot.to};
    const BodyIndex body = joint.bodies[1];
    Path path =
        panel({}, sketch.theme.paper, sketch.pen_of(body, body == frame ? sketch.theme.outline : sketch.theme.vector));
    path.segments = {MoveTo{outer.at(slot.from)},
                     ArcTo{slot.centre, outer.radius, slot.from, slot.to},
                     ArcTo{slot.at(slot.to), side, slot.to, slot.to + pi_number},
                     ArcTo{slot.centre, inner.radius, slot.to, slot.from},
                     ArcTo{slot.at(slot.from), side, slot.from + pi_number, slot.from + 2 * pi_number},
                     Close{}};
    if (body == frame) {
        hatch_arc(sketch, outer, true);
        if (slot.radius > 3 * side) hatch_arc(sketch, inner, false);
    }
    marks.emplace_back(std::move(path));
}

std::vector<Spot> corners_of_barrel(const Layout& layout, const Cylinder& cylinder) {
    const auto& [from, to] = cylinder.barrel;
    const Spot w = layout.measures.sleeve_side * turned(direction(cylinder.barrel));
    return {from + w, to + w, to - w, from - w};
}

/// Open at the rod's end except for the end wall.
void draw_barrel(const Sketch& sketch, const Cylinder& cylinder, std::vector<Mark>& marks) {
    const BodyIndex body = sketch.mechanism.joint(cylinder.joint).bodies[1];
    marks.emplace_back(panel(corners_of_barrel(sketch, cylinder), sketch.theme.colour_of(body).tint,
                             sketch.pen_of(body, sketch.theme.vector)));
}

void draw_sliding_parts(Sketch& sketch, BodyIndex body, std::vector<Mark>& marks) {
    for (const Joint& joint : sketch.mechanism.joints)
        if (body != frame && is_slide(joint) && joint.bodies[0] == body) draw_block(sketch, joint, marks);
    for (const Bar& slot : sketch.shape(body).slots) draw_slot(sketch, slot, body, marks);
    for (const Joint& joint : sketch.mechanism.joints)
        if (is_curved_slot(joint) && joint.bodies[1] == body) draw_curved_slot(sketch, joint, marks);
}

}  // namespace kinegraph::render::drawing
