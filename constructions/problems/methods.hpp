// The methods that solve each kind of problem stated without joints.
#pragma once

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/solution/problem_solution.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

// ----- Finite displacements: the pole between two positions of a body, by bisectors, and the fixed pivot of a crank
// that guides one of its points through three positions.
//
// Sources: the pole of a finite displacement, Euler and Chasles; three positions, Burmester 1888.

Result<ProblemSolution> solve_positions(const PositionsProblem& problem, const Mechanism& mechanism, const Pose& pose);

// ----- Hertz contact: half axes, pressure and approach by closed forms, and the stresses below the middle of the
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

/// `checked`: the same problem with the force of the numeric check, if the force was a result. Errors: numbers so far
/// apart that a double overflows.
Result<ProblemSolution> solve_hertz(const HertzProblem& problem, const HertzProblem& checked);
inline Result<ProblemSolution> solve_hertz(const HertzProblem& problem) { return solve_hertz(problem, problem); }

/// The stresses on the axis of a contact with known axes and pressure, in a material of Poisson's ratio ν, at a depth z
/// ≥ 0 (m). Shear is in the plane across the shorter axis, ½|σ_y − σ_z| (for a line across it). For round contacts and
/// lines this is the textbook's value; for ellipses it lies between them.
HertzSolution::Stress hertz_stress(const HertzSolution& contact, double poisson, double z);

// ----- Impact of two rigid bodies in the plane, exactly: momentum and angular momentum, Coulomb's friction and
// Poisson's restitution, phase by phase as in Routh's diagram of impulses (Routh, Dynamics of a System of Rigid Bodies,
// Elementary Part, art. 187–198; Whittaker, Analytical Dynamics, art. 95).
//   Δu_n = a J_n + b J_t,  Δu_t = b J_n + c J_t,  a = nᵀKn, b = nᵀKt, c = tᵀKt,  K = Σ (1/m + (r⊥ r⊥ᵀ)/J)
//   sliding: dJ_t = ∓f dJ_n against the slip; sticking: on the line u_t = 0, if |b/c| ≤ f; greatest compression: on
//   u_n = 0; end: J_n = (1 + e) times that at the greatest compression.

/// Errors: bodies that separate or keep their distance at the point of impact; a body on a pivot with its centre on it
/// and no inertia; friction so great that sliding jams, for which rigid bodies have no solution (no_unique_answer).
Result<ProblemSolution> solve_impact(const ImpactProblem& problem, const Mechanism& mechanism, const Pose& pose);

// ----- The motion of a point: symbolic derivatives of its laws (engine/file/algebra.hpp) give place, velocity and
// acceleration. The board gives the components of the acceleration along tangent and normal, and the centre of
// curvature.
//
// Sources: the intrinsic components, Huygens; the centre of curvature from v and a_n by the altitude of a right
// triangle, Euclid II.14 (ρ a_n = v²).

/// Errors: laws that are not real or are infinite at the instant or along the path, each at its place.
Result<ProblemSolution> solve_point_motion(const PointProblem& problem, const Mechanism& mechanism, const Pose& pose);

// ----- Reye's hypothesis: the worn volume is proportional to the work of friction, so the worn depth is proportional
// to pressure × sliding. The motion of the bodies during wear gives the form of the depth, equilibrium its size
// (Ferrari and Romiti, Meccanica applicata alle macchine; Shigley, Mechanical Engineering Design, 16–1 … 16–6).
//   pad:   free to tilt, the depth is linear: p = p₁(1 + m x/a), p₁ = 2Q(2a − 3d)/a²b, m = (3a − 6d)/(3d − 2a).
//          If p₁ or p₂ would be negative the face lifts. There remains a triangle of length three times the distance of
//          the force from the nearer end.
//   block: guided, the depth is uniform: p = Q/ab
//   disc:  guided, sliding is proportional to r: p r = Q/2π(r₂ − r₁), M = n f Q (r₁ + r₂)/2;
//          new, with uniform pressure, M = ⅔ n f Q (r₂³ − r₁³)/(r₂² − r₁²)
//   shoe:  turns about its pivot, the depth is proportional to the pivot's distance from the normal: p = C sin θ.
//          With N₁ = b r h ∫ sin²θ dθ and F₁ = b r ∫ sin θ (r − h cos θ) dθ, equilibrium about the pivot is
//          Q c = C (N₁ ∓ f F₁), − if friction assists the force

/// Errors: a self-locking leading shoe (no_unique_answer); numbers too far apart.
Result<ProblemSolution> solve_reye(const ReyeProblem& problem);

// ----- Contacts at joints of a solved mechanism: Hertz's theory with the joint force as load and the radii of the
// profiles, or of the involutes of the teeth.

/// Sets Solution::problem if joints of the mechanism have materials. The solution's forces and their check must be
/// known. The load Q is the component of the joint force along the common normal (for teeth the force itself, which
/// lies along the line of action). Radii are those of the profiles; of teeth r sin α, at the pitch point. Of two
/// profiles on one side of the contact the larger is concave. The check uses its own force and its own quadrature. A
/// contact without load (no force found, zero force, a pull) or without contact area (equal radii) gives a remark.
void find_contacts(Solution& solution);

}  // namespace kinegraph
