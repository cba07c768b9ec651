// The layout of a mechanism at one scale: where its points stand on paper (mm), how large its symbols are and what each
// body is made of. Draws nothing; whatever draws reads it.
#pragma once

#include <vector>

#include "render/mechanism/subject.hpp"
#include "render/page/theme.hpp"

namespace kinegraph::render::drawing {

/// Where a body is touched by another: the joint, and who touches.
struct Touch {
    JointIndex joint;
    BodyIndex other;
};
/// A round profile: a wheel, a gear, a cam, a roller, or only the arc on which another body slides.
struct Rim {
    enum class Form { wheel, gear, cam, roller, arc } form = Form::wheel;
    Spot centre;
    double radius = 0;
    bool hollow = false;         // the material lies outside
    std::vector<Touch> touches;  // none: a plain disc
};
/// A straight profile from end to end.
struct Flat {
    Bar bar;
    Spot inward;       // unit, into the material
    double depth = 1;  // from the profile to the middle of the stroke: its edge is what touches
    bool rack = false;
    std::vector<Touch> touches;
};

/// Piston in a barrel: a slide between two bodies that something drives, in line with the pins that hold it.
struct Cylinder {
    JointIndex joint;
    Spot rod_end;  // the pin of the rod
    Spot piston;   // on the axis
    Bar barrel;    // its axis, closed end first
};

/// What a body is drawn of, mm.
struct Shape {
    std::vector<Bar> bars;
    std::vector<Bar> edges;   // knife edges, from the end of the bar to the tip
    std::vector<Spot> plate;  // hull; empty: none
    bool solid = false;       // the plate is too slender to show its tint, and its lines are full
    std::vector<Bar> slots;   // centre lines of straight slots
    std::vector<Rim> rims;
    std::vector<Flat> flats;
    std::vector<Bar> strokes;  // the bars and the sides of the plate
    Spot middle;               // somewhere on it
};

/// Measures of the symbols, mm; they shrink where the links are short.
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

/// Each of its members is made of those before it.
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
    double scale() const { return scale_; }  ///< m for each mm
    Box mechanism_box() const { return {(1 / scale_) * subject.box.min, (1 / scale_) * subject.box.max}; }
    double module() const { return module_; }  ///< of all gears: height of a tooth above the pitch circle

    const std::vector<Cylinder>& cylinders() const { return cylinders_; }
    const Cylinder* cylinder_of(const Joint& joint) const;
    const std::vector<Shape>& shapes() const { return shapes_; }
    const Shape& shape(BodyIndex body) const { return shapes_[at_index(body)]; }

    /// Half the length and half the width of a slide's block.
    BlockSize block(const Joint& slide) const;
    /// Its corners.
    std::vector<Spot> corners_of_block(const Joint& slide) const;
    /// The centre line of a slot curved about a point; radius 0: too narrow to draw.
    Arc curved_slot(const Joint& joint) const;
    /// Unit directions in which strokes leave a point.
    std::vector<Spot> leaving(PointIndex point) const;
    /// How much a small symbol at `spot` would be in the way of strokes, blocks and pins other than that at `besides`:
    /// 0 not at all.
    double crowding(Spot spot, Spot besides) const;
    /// Whether a straight link lies along a longer one (and does not slide on it).
    bool lies_on(BodyIndex body, BodyIndex longer) const;

private:
    double crowding_of_joint(const Joint& joint, Spot spot, Spot besides) const;

    double scale_;
    std::vector<Spot> spots_;
    double module_;
    std::vector<Cylinder> cylinders_;
    std::vector<Shape> shapes_;
};

// What a layout is made of, each in a file of its own.

double gear_module(const Layout& layout);
std::vector<Cylinder> cylinders_in(const Layout& layout);
/// Somewhere within a body, to tell on which side of a contact it lies.
Spot bulk_of(const Layout& layout, BodyIndex body, const Joint& joint);
/// Round and straight profiles of a body.
std::vector<Rim> rims_of(const Layout& layout, BodyIndex body);
std::vector<Flat> flats_of(const Layout& layout, BodyIndex body);
Shape shape_of(const Layout& layout, BodyIndex body);

}  // namespace kinegraph::render::drawing
