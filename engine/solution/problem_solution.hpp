// Results of a problem without joints (engine/mechanism/problem.hpp), as values in SI units. Methods:
// constructions/problems/hertz.hpp and others; numeric checks: engine/check/check_hertz.hpp and others.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/file/units.hpp"
#include "engine/mechanism/problem.hpp"
#include "engine/solution/point_motion.hpp"

namespace kinegraph {

/// One scalar result, for tables, results and checks.
struct ProblemValue {
    Words name;          ///< in English the key of the results file
    std::string symbol;  ///< "p_0", "σ_z": a letter and its subscript
    QuantityKind kind = QuantityKind::dimensionless;
    double value = 0;               ///< SI
    std::optional<double> numeric;  ///< by the check
    bool in_file = true;            ///< false: the results file has a special form for it
    std::string unit{};             ///< SI unit of a value without a kind: "N s", "J"
    Words spoken{};  ///< on sheets and in tables, where it differs from the name: with a body's label instead of its
                     ///< key
};

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

/// An impact, exactly. The normal n is no unit vector (it is rational); the tangent t is n turned by a quarter turn.
/// Impulses and velocities along them are in units of |n|, so that the friction limit stays |J_t| ≤ f J_n.
struct ImpactSolution {
    Vector at;               ///< the point of impact, m
    Vector normal, tangent;  ///< from the second body into the first
    struct Body {
        bool fixed = false;
        Vector centre;  ///< m
        std::optional<Vector> pivot;
        Exact inverse_mass;                    ///< 0: fixed or pivoted
        Exact inverse_inertia;                 ///< about the centre, or the pivot where there is one; 0: does not
                                               ///< rotate
        Vector before, after;                  ///< velocity of the centre, m/s
        Exact omega_before, omega_after;       ///< rad/s
        Vector contact_before, contact_after;  ///< velocity of its point at the impact, m/s
        std::optional<Vector> reaction;        ///< impulse of the pivot on the body, N s
        std::optional<Vector> percussion;      ///< the centre of percussion of a pivoted body, m
    };
    std::array<Body, 2> bodies;
    /// Relative velocity of the points in contact, first body relative to the second, along n and t; and the effect of
    /// an impulse on it: Δu_n = a J_n + b J_t,  Δu_t = b J_n + c J_t.
    Exact approach, slip, a, b, c;
    Exact friction, restitution;
    /// One phase of the impact: the impulses at its end and the state of the contact.
    struct Phase {
        enum class Kind { slides, sticks } kind = Kind::slides;
        int sense = 0;  ///< of the slip along t
        Exact normal, tangential;
        bool ends_compression = false;
    };
    std::vector<Phase> phases;
    Exact normal_impulse, tangential_impulse;
    Vector impulse;                    ///< on the first body, N s
    Exact separation, slip_after;      ///< u_n, u_t afterwards
    Exact energy_before, energy_lost;  ///< J
    bool central = false, direct = false;
    double obliquity = 0;         ///< ψ between the relative velocity and the normal, rad, 0 … π/2
    Exact kinematic_restitution;  ///< −u_n′/u_n (Newton)
};

/// A rubbing contact. The coordinate of pressures is x from the pad's end (m), the radius of a disc (m), or the angle
/// of a shoe (rad).
struct ReyeSolution {
    double begin = 0, end = 0;     ///< ends of the contact
    double first = 0, second = 0;  ///< pressures at both ends of the face, Pa; 0 where it lifts off
    double greatest = 0, greatest_at = 0;
    std::optional<Exact> m;          ///< pad: (p₂ − p₁)/p₁, where the whole face touches
    std::optional<Exact> resultant;  ///< pad, block: of the pressures, from the end x = 0, m
    bool lifts = false;
    std::optional<double> friction_force;                    ///< pad, block
    std::optional<double> torque;                            ///< disc, shoe; N m
    std::optional<double> uniform_pressure, uniform_torque;  ///< disc: new, before it has worn in
    std::optional<double> locking_friction;  ///< leading shoe: above this coefficient it locks without force
    VectorOf<double> normal_force;           ///< shoe: resultant of the pressures on the shoe, N; x towards the pivot
    double pressure_radius = 0;              ///< shoe: of the centre of pressure, m
    std::optional<std::array<double, 2>> worn;  ///< depth at both ends of the face, m
    struct At {
        double place = 0, pressure = 0;
    };
    std::vector<At> pressures;  ///< along the face
};

struct ProblemSolution;
/// The contact at one joint: its problem, and the solution.
struct SolvedContact {
    JointIndex joint = none;
    std::shared_ptr<const Problem> stated;
    std::shared_ptr<const ProblemSolution> found;
};
using SolvedContacts = std::vector<SolvedContact>;

struct ProblemSolution {
    Words subject;  ///< subject of the sheet, for its title block
    std::variant<HertzSolution, ImpactSolution, ReyeSolution, SolvedContacts, PointMotionSolution, PositionsSolution>
        of;
    std::vector<ProblemValue> values;
    std::vector<Words> remarks;
};

}  // namespace kinegraph
