// Results for the motion of a point and for finite displacements of a body. Values in SI units, angles in radians.
// Methods: constructions/problems/point_motion.hpp and finite_displacements.hpp; numeric checks:
// engine/check/check_point_motion.hpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/board/board.hpp"
#include "engine/file/expression.hpp"

namespace kinegraph {

struct Solution;

// ----- the motion of a point

/// A law and its derivatives in symbols.
struct Derived {
    std::array<Expression, 3> by_order;
};

/// The motion of a point at the instant. Flags mark components that are undefined there.
struct PointMotionSolution {
    std::vector<Derived> laws;             ///< of PointProblem::laws
    std::optional<Derived> of_path;        ///< f, f′, f″
    Vector place, velocity, acceleration;  ///< the values of the laws in doubles, as input of the board
    double way = 0;                        ///< path length s from `from`; for a path, as its law counts it
    bool rests = false;                    ///< v = 0: no tangent, no normal, no curvature
    bool straight = false;                 ///< a_n = 0: the centre of curvature at infinity
    bool at_pole = false;                  ///< polar coordinates: r = 0, the radial direction is undefined
    /// By the construction; none where `rests`.
    std::optional<Vector> tangential, normal;  ///< components of the acceleration
    std::optional<Vector> centre;              ///< of curvature; none where `straight`
    double speed = 0, acceleration_length = 0, along = 0, across = 0, radius = 0;  ///< v, |a|, a_t, a_n, ρ
    double r = 0, theta = 0;
    std::array<double, 2> polar_velocity{}, polar_acceleration{};  ///< radial, transverse
    struct At {
        double time = 0, way = 0, speed = 0, along = 0, across = 0;
        VectorOf<double> place, velocity;
        bool rests = false;
    };
    std::vector<At> course;  ///< from `from` to `to`
    Protocol record;         ///< the board of the components and of the centre of curvature
    /// Elements of the record: points of the drawing, where one metre stands for 1 m/s or 1 m/s².
    struct Elements {
        ElementIndex tip_of_velocity = none, tip_of_acceleration = none, foot = none, reversed = none, centre = none;
    } elements;
};

/// The value of "motion" in the results file (docs/results.md), of a solution whose problem is the motion of a point.
std::string motion_json(const Solution& solution);

// ----- finite displacements

/// The displacement of a body from one position to another.
struct Displacement {
    std::size_t from = 0, to = 1;
    enum class Kind {
        rest,         ///< both positions are the same
        translation,  ///< all points have the same displacement
        rotation,     ///< about one of the two points, which stays in place
        general       ///< about a pole that is neither of the points
    } kind = Kind::general;
    std::optional<Vector> pole;  ///< none for a translation or rest
    Vector way;                  ///< of a translation
    double angle = 0;            ///< −π … π, counter-clockwise positive
    /// How the pole was found: intersection of the perpendicular bisectors; where they coincide, intersection of the
    /// two joins, or the common midpoint; or a point that stays.
    enum class By { bisectors, joins, middle, point } by = By::bisectors;
};
/// The fixed pivot of a crank that guides one of the points through three positions: centre of the circle through them.
struct FixedPivot {
    enum class Kind {
        pivot,
        straight,
        free,
        fixed
    } kind = Kind::pivot;  ///< free: two places coincide; fixed: all three coincide
    std::optional<Vector> centre;
    Vector direction;   ///< of the straight line
    double radius = 0;  ///< length of the crank
};
struct PositionsSolution {
    std::vector<Displacement> displacements;  ///< 1→2; of three positions also 2→3, 1→3
    std::vector<FixedPivot> pivots;           ///< of three positions: of the first and of the second point
    Protocol record;
};

}  // namespace kinegraph
