// The symbols that a mechanism is drawn of (ISO 3952), each on the layers of a sketch. A further symbol is a file and a
// line here.
#pragma once

#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

// Ground.

/// A line with hatching on the side `away`.
void draw_wall(Sketch& sketch, const Bar& wall, Spot away);
/// Hatching along an arc.
void hatch_arc(Sketch& sketch, const Arc& along, bool outwards);
void draw_fixed_pin(Sketch& sketch, PointIndex point);
/// Guides of the frame: axis and walls on both sides, open where a link passes.
void draw_guides(Sketch& sketch);

// Slides; `marks` are those of the body that has the part.

void draw_barrel(const Sketch& sketch, const Cylinder& cylinder, std::vector<Mark>& marks);
/// A slot about a point; that of the frame is hatched.
void draw_curved_slot(Sketch& sketch, const Joint& joint, std::vector<Mark>& marks);
/// Blocks (or pistons) and slots of a body.
void draw_sliding_parts(Sketch& sketch, BodyIndex body, std::vector<Mark>& marks);

// Links.

/// Plate, bars and knife edges in one pen.
void draw_strokes(const Shape& shape, const Pen& stroke, std::vector<Mark>& marks);
/// Blocks stand above the guide they slide on and below the links pinned to them.
std::vector<BodyIndex> drawing_order(const Layout& layout);
/// All that a body is made of, over those drawn already.
void draw_link(Sketch& sketch, BodyIndex body, const std::vector<BodyIndex>& below);
/// The body's number in a circle beside its longest stroke; names longer than two letters go without the circle.
void draw_balloon(Sketch& sketch, BodyIndex body);

// Wheels and what touches.

/// Wheels, gears, cams and flat faces of one body; those of the frame go to the ground.
void draw_profiles(Sketch& sketch, BodyIndex body, std::vector<Mark>& marks);
/// After ISO 2203: pitch circle dash-dot, tip circle in full; teeth where wheels mesh.
void draw_gear(Sketch& sketch, const Rim& rim, BodyIndex body, std::vector<Mark>& marks);
/// Teeth along the pitch line (dash-dot), the bar behind them.
void draw_rack(Sketch& sketch, const Flat& flat, BodyIndex body, std::vector<Mark>& marks);
/// The ground behind a fixed rim: hatched on the side where nothing rolls.
void draw_fixed_rim(Sketch& sketch, const Rim& rim, double radius, bool outside);
/// Hub and one spoke where the wheel has its own pin, so that a turn is seen; true where it is drawn. `end`: where the
/// rim begins.
bool draw_hub(const Sketch& sketch, const Rim& rim, double end, BodyIndex body, std::vector<Mark>& marks);
/// A ring-shaped area between two circles.
Path annulus(Spot centre, double inner, double outer, Colour tint);
/// Contacts of which the file tells no profile: a support on rollers where the frame bears, else the common tangent.
void draw_bare_contacts(Sketch& sketch, BodyIndex body);

// Joints and points.

/// One group each: a pin where bodies turn about each other, a dot where they touch.
void draw_joints(Sketch& sketch);
/// Two bodies in one piece: a filled square across the joint; a clamp in the frame: a wall.
void draw_clamp(Sketch& sketch, const Joint& joint);
/// A point of no joint: a dot, or the centre of mass.
void draw_point(Sketch& sketch, PointIndex point);
/// A point, or a place of contact: black, on a stroke set off from it by the paper.
void draw_dot(Sketch& sketch, Spot at);
/// A coil between two points; where they are too near for one, a line (a rope looks so, too).
void draw_spring(Sketch& sketch, const SpringLoad& spring);
/// A spring whose given force pushes: a cylinder with its rod.
void draw_gas_spring(Sketch& sketch, const SpringLoad& spring);
/// A spiral about its point.
void draw_torsion_spring(Sketch& sketch, const TorsionLoad& torsion);
/// Arrows with the line of intensities over them; their size tells proportions only.
void draw_distributed(Sketch& sketch, const DistributedLoad& load, std::vector<Mark>& layer);

}  // namespace kinegraph::render::drawing
