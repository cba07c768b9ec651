// A Hertzian contact: two elastic bodies that are pressed together, or the bodies at a joint of a mechanism, whose
// force is found first. Half axes, pressure and approach by closed forms, and the stresses below the middle of the
// contact.
//   E*:  1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂
//   round point (Johnson, Contact Mechanics, 4.22–4.24):  a³ = 3QR/4E*,  δ = a²/R,  p₀ = 3Q/2πa²
//   ellipse (Johnson 3.38, 4.26–4.31): the paraboloid of displacement under a semi-ellipsoid of pressure, with complete
//   elliptic integrals K, E of the modulus e, e² = 1 − b²/a²:
//     A = p₀ b/(E* e² a²)·(K − E),  B = p₀ b/(E* e² a²)·((a/b)² E − K),  δ = p₀ b K/E*,  p₀ = 3Q/2πab
//   line (Johnson 4.43–4.45, 5.57, 5.58):  b² = 4QR/πlE*,  p₀ = 2Q/πbl; approach of a cylinder from its axis
//     δᵢ = Q(1 − νᵢ²)/(πlEᵢ)·(2 ln(4rᵢ/b) − 1); of a flat or concave body from a depth d
//     δᵢ = Q(1 − νᵢ²)/(πlEᵢ)·(2 ln(2d/b) − νᵢ/(1 − νᵢ))
//   stresses on the axis: round 3.45, ellipse 3.69 (Thomas and Hoersch, incomplete elliptic integrals), line 4.49.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/mechanism/contact.hpp"
#include "engine/solution/problem_kind.hpp"

namespace kinegraph {

// ----- what a file states

/// One of two elastic bodies that are pressed together.
struct HertzBody : ElasticBody {
    /// Principal radii at the contact, m; 0: flat in that plane. A sphere has two equal ones; the second one of a
    /// cylinder that lies along a line of contact is not used.
    std::array<Exact, 2> radii{};
    std::array<bool, 2> inside{};  ///< concave: the material lies outside the radius

    /// Curvature in a principal plane, 1/m, positive where the body bulges towards the other.
    Exact curvature(std::size_t plane) const {
        if (radii[plane].is_zero()) return {};
        return inside[plane] ? -(Exact(1) / radii[plane]) : Exact(1) / radii[plane];
    }
};
/// A contact at a joint of a mechanism, which supplies the force and the radii.
struct AtJoint {
    std::string joint;    ///< name of the joint
    bool meshes = false;  ///< teeth touch at the pitch point: involutes of these pitch radii (m; 0: a rack)
    std::array<double, 2> pitch_radii{};
    double pressure_angle = 0;  ///< rad
};
struct HertzProblem {
    Exact force;  ///< N
    std::array<HertzBody, 2> bodies;
    bool line = false;
    Exact length;                 ///< of a line contact, m
    Exact turn;                   ///< between the first principal planes of the two bodies, rad
    std::optional<AtJoint> at{};  ///< none: the file gives force and radii
};

// ----- solution

/// A Hertzian contact. Axes: x along the longer axis of the contact ellipse (for a line: along the common tangent,
/// across the line), z into the bodies.
struct HertzSolution {
    Exact curvature_sum;         ///< 1/R of a line or a round point contact: the sum of both bodies' curvatures; for an
                                 ///< ellipse twice A + B
    double radius = 0;           ///< effective: R, for an ellipse (R′R″)^½
    double modulus = 0;          ///< effective: E*, Pa
    bool elliptic = false;       ///< a point contact with different principal curvatures
    double long_curvature = 0;   ///< A of the gap A x² + B y², 1/m: that of the longer axis
    double short_curvature = 0;  ///< B
    double a = 0,
           b = 0;  ///< half axes, a ≥ b, m; equal for a round contact; for a line b is the half width and a is 0
    double mean = 0, greatest = 0;  ///< pressure, Pa
    double approach = 0;            ///< of points far from the contact, m
    double shear = 0, depth = 0;    ///< the greatest shear on the axis, Pa, and its depth, m
    std::size_t sheared = 0;        ///< which of the two bodies has it
    /// On the axis, Pa; tension positive. σ_x and σ_y are equal under a round contact.
    struct Stress {
        double z = 0, along_x = 0, along_y = 0, along_z = 0, shear = 0;
    };
    std::vector<Stress> stresses;  ///< of the body `sheared`, from the surface down
};

/// `checked`: the same problem with the force of the numeric check, if the force was a result. Errors: numbers so far
/// apart that a double overflows.
Result<ProblemSolution> solve_hertz(const HertzProblem& problem, const HertzProblem& checked);
inline Result<ProblemSolution> solve_hertz(const HertzProblem& problem) { return solve_hertz(problem, problem); }

/// The stresses on the axis of a contact with known axes and pressure, in a material of Poisson's ratio ν, at a depth z
/// ≥ 0 (m). Shear is in the plane across the shorter axis, ½|σ_y − σ_z| (for a line across it). For round contacts and
/// lines this is the textbook's value; for ellipses it lies between them.
HertzSolution::Stress hertz_stress(const HertzSolution& contact, double poisson, double z);

/// Adds the contacts at joints that have materials. The solution's forces and their check must be known. The load Q is
/// the component of the joint force along the common normal (for teeth the force itself, which lies along the line of
/// action). Radii are those of the profiles; of teeth r sin α, at the pitch point. Of two profiles on one side of the
/// contact the larger is concave. The check uses its own force and its own quadrature. A contact without load (no force
/// found, zero force, a pull) or without contact area (equal radii) gives a remark.
void find_contacts(Solution& solution);

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

// ----- the kind of problem

std::any read_hertz(FormReader& file, Mechanism& mechanism, JsonValue section);
extern const FormValue hertz_section;
extern const ProblemKind hertz_problem;

}  // namespace kinegraph

namespace kinegraph::render {

struct DrawingContext;
struct Figure;
struct ProblemSection;

std::vector<ProblemSection> hertz_sections(const DrawingContext& context);

// ----- Figures: the bodies to scale, the pressure over the contact area with its plan, the stresses below. Room in mm.

/// The profiles of both bodies in the plane across the contact's shorter axis, with radii and force. Kind and id
/// "contact".
Figure hertz_bodies_figure(const DrawingContext& context, double room_x, double room_y);
/// The semi-ellipse of pressure across the contact, and below it the plan of the contact area at the same scale. Kind
/// and id "pressure".
Figure hertz_pressure_figure(const DrawingContext& context, double room_x, double room_y);
/// Stresses on the axis over the depth, with the maximum shear stress. Kind "plot", id "stresses".
Figure hertz_stress_figure(const DrawingContext& context, double room_x, double room_y);

}  // namespace kinegraph::render
