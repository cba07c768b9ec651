// Symbols of a mechanism (ISO 3952), drawn on the layers of a sketch. A further symbol is one file and one line here.
#pragma once

#include <string>

#include "engine/solution/bindings.hpp"
#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

// What marks of the mechanism move with, beyond the forms of holds.hpp: an arrow with two places as its direction
// reaches from one to the other; a mark other than a stroke is stretched along its segment; a segment with a third name
// is a bar with that force, of which its line says whether it is in tension; an arc with a radius (`beyond`) is that of
// an angle, from the direction of x to that of its second place.

inline Holds on_body(BodyIndex body) { return {Holds::Form::body, {std::to_string(body.number())}}; }
inline Holds arrow_between(const std::string& from, const std::string& to) {
    return {Holds::Form::arrow, {from, from, to}};
}
inline Holds between_ends(const SpringLoad& spring) {
    return {Holds::Form::segment, {point_binding(spring.between[0]), point_binding(spring.between[1])}};
}

// Ground.

/// A line with hatching on the side `away`.
void draw_wall(Sketch& sketch, const Bar& wall, Spot away);
/// Hatching along an arc.
void hatch_arc(Sketch& sketch, const Arc& along, bool outwards);
void draw_fixed_pin(Sketch& sketch, PointIndex point);
/// Guides of the frame: axis and walls on both sides, interrupted where a link passes.
void draw_guides(Sketch& sketch);

// Slides. `marks` belong to the body that has the part.

std::vector<Spot> corners_of_barrel(const Layout& layout, const Cylinder& cylinder);
void draw_barrel(const Sketch& sketch, const Cylinder& cylinder, std::vector<Mark>& marks);
/// A slot curved about a point; hatched if it belongs to the frame.
void draw_curved_slot(Sketch& sketch, const Joint& joint, std::vector<Mark>& marks);
/// Blocks (or pistons) and slots of a body.
void draw_sliding_parts(Sketch& sketch, BodyIndex body, std::vector<Mark>& marks);

// Outlines.

/// The rims of a shape except arcs; its straight profiles, edges, plate and bars.
std::vector<Path> rims_in(const Shape& shape, const Pen& pen);
std::vector<Path> strokes_in(const Shape& shape, const Pen& pen);

// Links.

/// Plate, bars and knife edges in one pen.
void draw_strokes(const Shape& shape, const Pen& stroke, std::vector<Mark>& marks);
/// Order in which bodies are drawn: blocks above the guide they slide on and below the links pinned to them.
std::vector<BodyIndex> drawing_order(const Layout& layout);
/// All parts of a body, above the bodies drawn before.
void draw_link(Sketch& sketch, BodyIndex body, const std::vector<BodyIndex>& below);
/// The body's number in a circle beside its longest stroke. Names longer than two letters have no circle.
void draw_balloon(Sketch& sketch, BodyIndex body);

// Wheels and contacts.

/// Wheels, gears, cams and flat faces of one body. Those of the frame are drawn in the ground layer.
void draw_profiles(Sketch& sketch, BodyIndex body, std::vector<Mark>& marks);
/// ISO 2203: pitch circle dash-dot, tip circle in full; teeth only where wheels mesh.
void draw_gear(Sketch& sketch, const Rim& rim, BodyIndex body, std::vector<Mark>& marks);
/// Teeth along the pitch line (dash-dot), with the bar behind them.
void draw_rack(Sketch& sketch, const Flat& flat, BodyIndex body, std::vector<Mark>& marks);
/// The ground behind a fixed rim, hatched on the side away from the rolling body.
void draw_fixed_rim(Sketch& sketch, const Rim& rim, double radius, bool outside);
/// Hub and one spoke, which shows the rotation, if the wheel has a pin of its own. Returns whether they were drawn.
/// `end`: radius at which the rim begins, mm.
bool draw_hub(const Sketch& sketch, const Rim& rim, double end, BodyIndex body, std::vector<Mark>& marks);
/// A ring-shaped area between two circles.
Path annulus(Spot centre, double inner, double outer, Colour tint);
/// Contacts without a given profile: a roller support if the frame is one of the bodies, else the common tangent.
void draw_bare_contacts(Sketch& sketch, BodyIndex body);

// Joints and points.

/// One group each: a pin at a hinge, a dot at a contact.
void draw_joints(Sketch& sketch);
/// A rigid connection of two bodies: a filled square across the joint; a clamp in the frame: a wall.
void draw_clamp(Sketch& sketch, const Joint& joint);
/// A point without a joint: a dot, or the symbol of a centre of mass.
void draw_point(Sketch& sketch, PointIndex point);
/// The dot of a point or a contact: black, separated from strokes by a ring of paper colour.
void draw_dot(Sketch& sketch, Spot at);
/// A coil between two points. If they are too near for a coil, a line, as for a rope.
void draw_spring(Sketch& sketch, const SpringLoad& spring);
/// A spring whose given force pushes apart: a cylinder with its rod.
void draw_gas_spring(Sketch& sketch, const SpringLoad& spring);
/// A spiral about its point.
void draw_torsion_spring(Sketch& sketch, const TorsionLoad& torsion);
/// Arrows with the intensity line over them. Their size shows proportions only.
void draw_distributed(Sketch& sketch, const DistributedLoad& load, std::vector<Mark>& layer);
/// The intensities at both its ends, or one value if they are equal.
void name_intensities(Sketch& sketch, const DistributedLoad& load);

}  // namespace kinegraph::render::drawing
