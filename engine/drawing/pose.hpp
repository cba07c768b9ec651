// Pose: the drawn configuration. Every point is rational, every guide a rational direction; each has its construction
// and a certified bound on the leftover of the compass. Square roots and angles occur only here. Contains no motion.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// One arc or line drawn to find a point, for the figure and the text.
struct PositionStep {
    PointIndex point = none;
    enum class How { given, polar, along, lines, line_and_circle, circles, moved_onto_curve } how = How::given;
    struct Arc {
        Vector centre;
        Exact radius;
    };
    std::vector<Arc> arcs;  ///< the compass strokes
};

struct ShiftedDrawing;

struct Pose {
    int bits = 100;               ///< the compass is accurate to 2^-bits of the drawing's size
    std::vector<Vector> points;   ///< by PointIndex, m
    std::vector<Exact> leftover;  ///< by PointIndex: error bound of its own construction (m); zero where exact
    std::vector<Vector>
        guides;  ///< by JointIndex: direction of `along` (sense kept, any length), zero where the joint has none
    std::vector<Vector> guide_units;  ///< the same as a unit vector, within 2^-bits where its length is irrational
    std::vector<Vector> driver_directions;  ///< by driver index: `along` of a point driver, zero for other drivers
    std::vector<Vector> driver_units;       ///< the same as a unit vector
    std::vector<Vector>
        normals;  ///< by JointIndex: common normal of pin-slot, rolling, contact, gear (line of action); zero elsewhere
    std::vector<Vector> tangents;  ///< by JointIndex: common tangent at P of rolling, contact, gear (of the pitch
                                   ///< curves); zero elsewhere
    Exact size;         ///< the drawing's size: largest coordinate difference, m (1 where all points coincide)
    bool exact = true;  ///< no leftover anywhere: predicates need no finer pose
    std::vector<PositionStep> steps;  ///< in the order found
    std::vector<Message> remarks;     ///< points moved onto their curves, with the misfit
    Exact precision;  ///< how far coordinates and lengths may be off, m; zero: decimals are exact as written
    std::shared_ptr<const std::vector<ShiftedDrawing>>
        shifted;  ///< empty where no datum is rounded (engine/mechanism/rounding.hpp)

    bool is_rounded() const { return shifted != nullptr; }
    /// Whether a value does not depend on a leftover: such a one is a fraction as long as the compass's rounding.
    bool is_certain(const Exact& value) const {
        return exact || value.bits() < static_cast<std::size_t>(bits > 0 ? bits : 1);
    }
    /// The precision as a share of the drawing's size.
    double rounding() const { return precision.to_double() / size.to_double(); }
    const Vector& at(PointIndex point) const { return points[at_index(point)]; }
};

/// The pose of the mechanism whose rounded numbers are shifted within their precision.
struct ShiftedDrawing {
    Mechanism mechanism;
    Pose pose;
};

/// Places every point. Errors: a cycle of points, curves that do not meet (by how much), two intersections and no
/// choice, a point off its curve by more than both 1e-9 of the size and the data's precision (the misfit), a direction
/// between coincident points. Circles that touch within the precision touch.
/// The choice between two intersections: `near` chooses the nearer one (a tie is an error); `side` of two circles, left
/// or right of first centre → second; `side` on a line, with the line's direction pointing right: "right" is the one
/// further along it, "left" the one further back, wherever the circle's centre lies.
/// A gear's normal is its line of action, the common tangent turned counter-clockwise by the pressure angle (0 where
/// none is given); the other line, turned clockwise, is its mirror image.
Result<Pose> draw_pose(const Mechanism& mechanism, int bits = 100);

/// Returns the same pose at twice its bits, to decide suspiciously small values.
using FinerPose = std::function<Pose()>;

/// A bearing in this pose: a rational direction, not of unit length. Equal angles give equal directions; angles a
/// quarter turn apart give exactly perpendicular ones; multiples of 45° are exact.
Vector direction_of(const Bearing& bearing, const Pose& pose);
Vector direction_of(const Angle& angle, int bits);
/// direction / |direction|, within 2^-bits where the length is irrational.
Vector unit_along(const Vector& direction, int bits);
/// A direction that has no sense: dx > 0, or (0, 1); its larger component is 1 or −1. `is_exact`: the pose is; else a
/// vertical direction is accurate to about 2^-100, and its sense must not depend on that.
Vector without_sense(Vector direction, bool is_exact);

}  // namespace kinegraph
