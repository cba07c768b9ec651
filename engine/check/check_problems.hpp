// Numeric checks of problems that stand in place of joints, by other ways than the constructions.
#pragma once

#include <array>
#include <optional>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/problem.hpp"

namespace kinegraph {

// ----- The numeric check of a Hertzian contact. It shares nothing with the closed forms: points by Hertz's own
// integrals over the confocal ellipsoids, done by quadrature (the closed form of an approach along a line leaves out
// (b/r)², the check does not); lines by the integral equation of the pressure as a linear system (Erdogan and Gupta's
// Gauss–Chebyshev quadrature); approaches along a line by adding up the strain; stresses by Boussinesq's and Flamant's
// solutions for one force, summed over the face of contact.

/// As in HertzSolution, m and Pa.
struct HertzCheck {
    double radius = 0, modulus = 0, a = 0, b = 0, mean = 0, greatest = 0, approach = 0, shear = 0, depth = 0;
};
HertzCheck check_hertz(const HertzProblem& problem);

/// From where the approach of a body at a line of contact is counted: its axis, or a depth below a flat or concave face
/// (where the file gives none, the radius of the partner).
struct Datum {
    bool is_axis = true;
    double depth = 0;  ///< m below the contact
};
Datum datum_of(const HertzProblem& problem, std::size_t body);

// ----- The numeric check of an impact: Newton's laws for both bodies, integrated in small steps of the normal impulse
// with Coulomb's friction at each; compression until the points in contact no longer approach, then e times as much
// again. In doubles, body by body; shares no formula with the construction.

struct ImpactCheck {
    std::array<double, 2> impulse{};  ///< on the first body, N s
    struct Body {
        std::array<double, 2> velocity{}, reaction{};
        double omega = 0;
    };
    std::array<Body, 2> bodies;
    double energy_lost = 0;
};
/// `normal` from the second body to the first; bodies that approach.
ImpactCheck check_impact(const ImpactProblem& problem, const Vector& at, const Vector& normal, const Pose& pose);

// ----- The numeric check of a contact that wears by Reye's hypothesis: the face cut into strips, each pressed as far
// as it wears and never pulled; equilibrium of the strips solved for the motion of the body that wears. No closed form.

/// As in ReyeSolution.
struct ReyeCheck {
    double first = 0, second = 0, greatest = 0, resultant = 0, begin = 0, end = 0, friction = 0, torque = 0;
    double uniform_pressure = 0, uniform_torque = 0, normal = 0, pressure_radius = 0, locking = 0;
    std::array<double, 2> worn{};
};
ReyeCheck check_reye(const ReyeProblem& problem);

// ----- The numeric checks of the motion of a point and of positions of a body. Of the point: the rules of
// differentiation carried along with the numbers (engine/file/expression.hpp, jets), so no derivative in symbols is
// used; the way by Simpson's rule. Of positions: complex numbers, a displacement being z′ = e^{iφ}z + c, and circles
// through three points by their equations.

struct PointCheck {
    VectorOf<double> place, velocity, acceleration;
    double way = 0, speed = 0, acceleration_length = 0;
    double along = 0, across = 0, radius = 0;  ///< no numbers where v or a_n vanishes
    VectorOf<double> centre;
    double r = 0, theta = 0;
    std::array<double, 2> polar_velocity{}, polar_acceleration{};
};
PointCheck check_point_motion(const PointProblem& problem);

struct DisplacementCheck {
    VectorOf<double> pole, way;
    double angle = 0;
};
DisplacementCheck check_displacement(const PositionsProblem& problem, std::size_t from, std::size_t to);
/// Of the point number `point` through the three positions: centre and radius.
std::pair<VectorOf<double>, double> check_pivot(const PositionsProblem& problem, std::size_t point);

}  // namespace kinegraph
