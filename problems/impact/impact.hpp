// Impact of two rigid bodies in the plane, exactly: momentum and angular momentum, Coulomb's friction and
// Poisson's restitution, phase by phase as in Routh's diagram of impulses (Routh, Dynamics of a System of Rigid Bodies,
// Elementary Part, art. 187–198; Whittaker, Analytical Dynamics, art. 95).
//   Δu_n = a J_n + b J_t,  Δu_t = b J_n + c J_t,  a = nᵀKn, b = nᵀKt, c = tᵀKt,  K = Σ (1/m + (r⊥ r⊥ᵀ)/J)
//   sliding: dJ_t = ∓f dJ_n against the slip; sticking: on the line u_t = 0, if |b/c| ≤ f; greatest compression: on
//   u_n = 0; end: J_n = (1 + e) times that at the greatest compression.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/solution/problem_kind.hpp"

namespace kinegraph {

// ----- what a file states

/// One of two bodies that hit each other.
struct ImpactBody {
    BodyIndex body = none;
    bool fixed = false;            ///< at rest, whatever hits it
    Exact mass;                    ///< kg
    std::optional<Exact> inertia;  ///< about the centre of mass, kg m²; none: a particle, which does not turn
    std::optional<Place> centre;   ///< none: at the point of impact
    std::optional<Place> pivot;    ///< of a body that turns about a fixed hinge
    std::optional<Vector>
        velocity;  ///< of the centre of mass before the impact, m/s; a pivoted body has `omega` instead
    Exact omega;   ///< rad/s
    std::string where;
};
struct ImpactProblem {
    std::array<ImpactBody, 2> bodies;
    Place at;
    Bearing normal;     ///< of the plane of impact; its sense from the second body to the first, where their centres do
                        ///< not determine it
    Exact restitution;  ///< 0 … 1, the ratio of the normal impulses of restitution and compression (Poisson)
    Exact friction;     ///< coefficient of Coulomb
    std::string where;
};

// ----- solution

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

/// Errors: bodies that separate or keep their distance at the point of impact; a body on a pivot with its centre on it
/// and no inertia; friction so great that sliding jams, for which rigid bodies have no solution (no_unique_answer).
Result<ProblemSolution> solve_impact(const ImpactProblem& problem, const Mechanism& mechanism, const Pose& pose);

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

// ----- the kind of problem

std::any read_impact(FormReader& file, Mechanism& mechanism, JsonValue section);
extern const FormValue impact_section;
extern const ProblemKind impact_problem;

}  // namespace kinegraph

namespace kinegraph::render {

struct DrawingContext;
struct Figure;
struct ProblemSection;

std::vector<ProblemSection> impact_sections(const DrawingContext& context);

// ----- Figures: the bodies with their velocities, the velocity plane, and Routh's diagram of impulses. Room in mm.

/// The bodies to scale with centres, line and plane of impact, and the velocities before the impact. Kind and id
/// "contact".
Figure impact_bodies_figure(const DrawingContext& context, double room_x, double room_y);
/// The same with the velocities after the impact. Kind "contact", id "contact-after".
Figure impact_after_figure(const DrawingContext& context, double room_x, double room_y);
/// Velocities of the centres before and after, from one pole: their changes are parallel to the impulse. Kind
/// "velocity", id "velocities".
Figure impact_velocities_figure(const DrawingContext& context, double room_x, double room_y);
/// Relative velocity of the points in contact before and after, along normal and tangent. Kind "velocity", id
/// "restitution".
Figure impact_restitution_figure(const DrawingContext& context, double room_x, double room_y);
/// Tangential over normal impulse: the path, the lines of sticking and of maximum compression, the friction limit. Kind
/// "plot", id "routh".
Figure impact_routh_figure(const DrawingContext& context, double room_x, double room_y);
bool has_routh_figure(const DrawingContext& context);

}  // namespace kinegraph::render
