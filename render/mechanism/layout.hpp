// Layout of a mechanism at one scale: positions of its points on paper (mm), sizes of its symbols and the shape of each
// body. Draws nothing; all drawing functions use it.
#pragma once

#include <vector>

#include "render/mechanism/subject.hpp"
#include "render/page/theme.hpp"

namespace kinegraph::render::drawing {

/// A contact of a body: the joint and the other body.
struct Touch {
    JointIndex joint;
    BodyIndex other;
};
/// A round profile: a wheel, a gear, a cam, a roller, or an arc on which another body slides.
struct Rim {
    enum class Form { wheel, gear, cam, roller, arc } form = Form::wheel;
    Spot centre;
    double radius = 0;
    bool hollow = false;         // the material lies outside
    std::vector<Touch> touches;  // empty: a plain disc
};
/// A straight profile from end to end.
struct Flat {
    Bar bar;
    Spot inward;       // unit vector, into the material
    double depth = 1;  // from the profile to the centre line of the stroke, whose edge is the profile
    bool rack = false;
    std::vector<Touch> touches;
};

/// A piston in a barrel: a driven slide between two moving bodies, in line with the pins that support it.
struct Cylinder {
    JointIndex joint;
    Spot rod_end;  // the pin of the rod
    Spot piston;   // on the axis
    Bar barrel;    // its axis, closed end first
};

/// The shape of a body, mm.
struct Shape {
    std::vector<Bar> bars;
    std::vector<Bar> edges;   // knife edges, from the end of the bar to the tip
    std::vector<Spot> plate;  // convex hull; empty: none
    bool slender = false;     // the plate is too slender to show its tint
    bool solid = false;       // … and its lines are full
    std::vector<Bar> slots;   // centre lines of straight slots
    std::vector<Rim> rims;
    std::vector<Flat> flats;
    std::vector<Bar> strokes;  // the bars and the sides of the plate
    Spot middle;               // some point of the body
};

/// Sizes of the symbols, mm. They shrink if the links are short.
struct Measures {
    double shrink;
    double pin_radius = 1.5 * shrink, triangle_height = 6.2 * shrink, triangle_half = 3.6 * shrink,
           base_half = 5.4 * shrink;
    double hatch_depth = 2.2 * shrink, hatch_pitch = 1.5 * shrink;
    double slider_half = 8.0 * shrink, slider_side = 4.4 * shrink, sleeve_half = 7.5 * shrink,
           sleeve_side = 3.6 * shrink;
    double wall_beyond = 9.0 * shrink, axis_beyond = 14.0 * shrink, rod_beyond = 9.0 * shrink;
    double slot_half = 10.0 * shrink, slot_side = 2.2 * shrink;
};

struct BlockSize {
    double half, side;
};

/// Members are initialised in order; each uses the preceding ones.
class Layout {
public:
    Layout(const Subject& of, const Theme& look, double metres_per_millimetre);

    const Subject& subject;
    const Mechanism& mechanism;
    const Theme& theme;
    const Measures measures;

    Spot spot(PointIndex point) const { return spots_[at_index(point)]; }
    Spot spot(const Vector& place) const { return (1 / scale_) * paper_spot(place); }
    Spot spot(const Joint& joint) const { return spot(joint.point); }
    Spot guide(const Joint& joint) const { return subject.guides[at_index(mechanism.index_of(joint))]; }
    double size() const { return subject.size() / scale_; }
    double scale() const { return scale_; }  ///< m per mm
    Box mechanism_box() const { return {(1 / scale_) * subject.box.min, (1 / scale_) * subject.box.max}; }
    double module() const { return module_; }  ///< module of all gears: height of a tooth above the pitch circle, mm

    const std::vector<Cylinder>& cylinders() const { return cylinders_; }
    const Cylinder* cylinder_of(const Joint& joint) const;
    const std::vector<Shape>& shapes() const { return shapes_; }
    const Shape& shape(BodyIndex body) const { return shapes_[at_index(body)]; }

    /// Half the length and half the width of a slide's block, mm.
    BlockSize block(const Joint& slide) const;
    std::vector<Spot> corners_of_block(const Joint& slide) const;
    /// The centre line of a slot curved about a point. Radius 0: too narrow to draw.
    Arc curved_slot(const Joint& joint) const;
    /// Unit vectors of the strokes that leave a point.
    std::vector<Spot> leaving(PointIndex point) const;
    /// Bars, plates, rims and blocks of the moving bodies, one body after the other; joints as strokes of no length.
    std::vector<BodyStroke> strokes_of_bodies() const;
    /// How much a small symbol at `spot` would collide with strokes, blocks and pins, except the pin at `besides`; 0:
    /// not at all.
    double crowding(Spot spot, Spot besides) const;
    /// Whether a straight link lies along a longer one without sliding on it.
    bool lies_on(BodyIndex body, BodyIndex longer) const;

private:
    double crowding_of_joint(const Joint& joint, Spot spot, Spot besides) const;

    double scale_;
    std::vector<Spot> spots_;
    double module_;
    std::vector<Cylinder> cylinders_;
    std::vector<Shape> shapes_;
};

// The parts of a layout, each defined in its own file.

double gear_module(const Layout& layout);
std::vector<Cylinder> cylinders_in(const Layout& layout);
/// A point within a body; it shows on which side of a contact the body lies.
Spot bulk_of(const Layout& layout, BodyIndex body, const Joint& joint);
/// Round and straight profiles of a body.
std::vector<Rim> rims_of(const Layout& layout, BodyIndex body);
std::vector<Flat> flats_of(const Layout& layout, BodyIndex body);
Shape shape_of(const Layout& layout, BodyIndex body);

}  // namespace kinegraph::render::drawing
