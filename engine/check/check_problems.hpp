// Numeric checks of problems without joints. Each uses another method than the construction.
#pragma once

#include <array>
#include <optional>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/problem.hpp"

namespace kinegraph {

// ----- The numeric check of a Hertzian contact. It does not use the closed forms. Points: Hertz's integrals over the
// confocal ellipsoids, by quadrature (the closed form of the approach of a line contact omits (b/r)², the check does
// not). Lines: the integral equation of the pressure as a linear system (Erdogan and Gupta's Gauss–Chebyshev
// quadrature). Approach of a line contact: integration of the strain. Stresses: Boussinesq's and Flamant's solutions
// for a single force, integrated over the contact area.

/// As in HertzSolution, m and Pa.
struct HertzCheck {
    double radius = 0, modulus = 0, a = 0, b = 0, mean = 0, greatest = 0, approach = 0, shear = 0, depth = 0;
};
HertzCheck check_hertz(const HertzProblem& problem);

/// The datum for the approach of a body at a line of contact: its axis, or a depth below a flat or concave face (where
/// the file gives none, the radius of the other body).
struct Datum {
    bool is_axis = true;
    double depth = 0;  ///< m below the contact
};
Datum datum_of(const HertzProblem& problem, std::size_t body);

// ----- The numeric check of an impact: Newton's laws for both bodies, integrated in small steps of the normal impulse
// with Coulomb friction in each. Compression lasts until the points in contact no longer approach; restitution then
// adds e times its impulse. In doubles; it shares no formula with the construction.

struct ImpactCheck {
    std::array<double, 2> impulse{};  ///< on the first body, N s
    struct Body {
        std::array<double, 2> velocity{}, reaction{};
        double omega = 0;
    };
    std::array<Body, 2> bodies;
    double energy_lost = 0;
};
/// `normal` points from the second body to the first. Precondition: the bodies approach.
ImpactCheck check_impact(const ImpactProblem& problem, const Vector& at, const Vector& normal, const Pose& pose);

// ----- The numeric check of a contact that wears by Reye's hypothesis: the face is cut into strips; each is pressed in
// proportion to its wear, without tension. Equilibrium of the strips is solved for the motion of the worn body. No
// closed form.

/// As in ReyeSolution.
struct ReyeCheck {
    double first = 0, second = 0, greatest = 0, resultant = 0, begin = 0, end = 0, friction = 0, torque = 0;
    double uniform_pressure = 0, uniform_torque = 0, normal = 0, pressure_radius = 0, locking = 0;
    std::array<double, 2> worn{};
};
ReyeCheck check_reye(const ReyeProblem& problem);

// ----- The numeric checks of the motion of a point and of positions of a body. Motion of a point: automatic
// differentiation (engine/file/expression.hpp, jets) instead of symbolic derivatives; the path length by Simpson's
// rule. Positions: complex numbers, with a displacement z′ = e^{iφ}z + c, and circles through three points by their
// equations.

struct PointCheck {
    VectorOf<double> place, velocity, acceleration;
    double way = 0, speed = 0, acceleration_length = 0;
    double along = 0, across = 0, radius = 0;  ///< not meaningful where v or a_n vanishes
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
/// The circle through the three positions of point `point`: centre and radius.
std::pair<VectorOf<double>, double> check_pivot(const PositionsProblem& problem, std::size_t point);

}  // namespace kinegraph
