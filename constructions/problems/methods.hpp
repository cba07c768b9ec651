// The methods by which each kind of problem that stands in place of joints is solved.
#pragma once

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/solution/problem_solution.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

// ----- Motions in the large: what takes a body from one position to another, by the bisectors, and where a crank that
// carries one of its points through three positions has its fixed pivot.
//
// Sources: the pole of a finite displacement, Euler and Chasles; three positions, Burmester 1888.

Result<ProblemSolution> solve_positions(const PositionsProblem& problem, const Mechanism& mechanism, const Pose& pose);

// ----- Hertz's contact: half axes, pressure and approach by the closed forms of the theory, and the stresses below the
// middle of the contact.
//   E*:  1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂
//   round point (Johnson, Contact Mechanics, 4.22–4.24):  a³ = 3QR/4E*,  δ = a²/R,  p₀ = 3Q/2πa²
//   ellipse (Johnson 3.38, 4.26–4.31): the paraboloid of displacement that the semi-ellipsoid of pressure makes, with
//   complete elliptic integrals K, E of the modulus e, e² = 1 − b²/a²:
//     A = p₀ b/(E* e² a²)·(K − E),  B = p₀ b/(E* e² a²)·((a/b)² E − K),  δ = p₀ b K/E*,  p₀ = 3Q/2πab
//   line (Johnson 4.43–4.45, 5.57, 5.58):  b² = 4QR/πlE*,  p₀ = 2Q/πbl; approach of a cylinder from its axis
//     δᵢ = Q(1 − νᵢ²)/(πlEᵢ)·(2 ln(4rᵢ/b) − 1), of a flat or concave body from a depth d  Q(1 − νᵢ²)/(πlEᵢ)·(2 ln(2d/b)
//     − νᵢ/(1 − νᵢ))
//   on the axis: round 3.45, ellipse 3.69 (Thomas and Hoersch, incomplete elliptic integrals), line 4.49.

/// `checked`: the same with the force of the numeric check, where the force itself was found.
/// Errors: numbers so far apart that no double holds what comes of them.
Result<ProblemSolution> solve_hertz(const HertzProblem& problem, const HertzProblem& checked);
inline Result<ProblemSolution> solve_hertz(const HertzProblem& problem) { return solve_hertz(problem, problem); }

/// The stresses on the axis of a contact whose axes and pressure are known, in a material of Poisson's ratio ν, at a
/// depth z ≥ 0 (m). Shear is that in the plane across the shorter axis, ½|σ_y − σ_z| (of a line across it): of round
/// contacts and lines the textbook's one, of ellipses between.
HertzSolution::Stress hertz_stress(const HertzSolution& contact, double poisson, double z);

// ----- Impact of two rigid bodies in the plane, exactly: momentum and moment of momentum, Coulomb's friction and
// Poisson's restitution, followed from phase to phase as in Routh's diagram of impulses (Routh, Dynamics of a System of
// Rigid Bodies, Elementary Part, art. 187–198; Whittaker, Analytical Dynamics, art. 95).
//   Δu_n = a J_n + b J_t,  Δu_t = b J_n + c J_t,  a = nᵀKn, b = nᵀKt, c = tᵀKt,  K = Σ (1/m + (r⊥ r⊥ᵀ)/J)
//   sliding dJ_t = ∓f dJ_n against the slip; sticking on the line u_t = 0, where |b/c| ≤ f; the greatest compression on
//   u_n = 0; the end at J_n = (1 + e) times that of the greatest compression.

/// Errors: bodies that part or keep their distance at the point of impact; a body on a pivot with its centre on it and
/// no inertia; with friction so great that sliding jams, where rigid bodies have no answer (no_unique_answer).
Result<ProblemSolution> solve_impact(const ImpactProblem& problem, const Mechanism& mechanism, const Pose& pose);

// ----- The motion of a point: derivatives of its laws in symbols (engine/file/algebra.hpp), place, velocity and
// acceleration from them, and, on the board, the components of the acceleration along tangent and normal and the centre
// of curvature.
//
// Sources: the intrinsic components, Huygens; the centre of curvature from v and a_n by the altitude of a right
// triangle, Euclid II.14 (ρ a_n = v²).

/// Errors: laws that are not real or infinite at the instant or on the way, each at its place.
Result<ProblemSolution> solve_point_motion(const PointProblem& problem, const Mechanism& mechanism, const Pose& pose);

// ----- Reye's hypothesis: the volume worn off goes with the work of friction, so the depth worn off with pressure ×
// sliding. What the bodies can do while they wear in gives the depth's form, equilibrium its size (Ferrari and Romiti,
// Meccanica applicata alle macchine; Shigley, Mechanical Engineering Design, 16–1 … 16–6).
//   pad:   free to tilt, the depth is linear: p = p₁(1 + m x/a), p₁ = 2Q(2a − 3d)/a²b, m = (3a − 6d)/(3d − 2a); where
//   p₁ or p₂ would be
//          negative the face lifts and a triangle over three times the distance of the force from the nearer end is
//          left
//   block: guided, the depth is even: p = Q/ab
//   disc:  guided, sliding goes with r: p r = Q/2π(r₂ − r₁), M = n f Q (r₁ + r₂)/2; new, with even pressure, M = ⅔ n f
//   Q (r₂³ − r₁³)/(r₂² − r₁²) shoe:  turns about its pivot, the depth goes with the pivot's distance from the normal: p
//   = C sin θ. With N₁ = b r h ∫ sin²θ dθ and
//          F₁ = b r ∫ sin θ (r − h cos θ) dθ equilibrium about the pivot is Q c = C (N₁ ∓ f F₁), − where friction helps
//          the force

/// Errors: a leading shoe that locks itself (no_unique_answer); numbers too far apart.
Result<ProblemSolution> solve_reye(const ReyeProblem& problem);

// ----- Contacts at joints of a solved mechanism: the force found presses the bodies together, their profiles or the
// involutes of their teeth have their radii there, and Hertz's theory says the rest (constructions/problems/hertz.hpp).
// Knows no file and no sheet.

/// Enters Solution::problem where joints of the mechanism have materials; the solution's forces and their check are in
/// it already. The load Q is the part of the joint's force along the common normal (of teeth the force itself, which
/// lies along the line of action); radii are those of the profiles, of teeth at the pitch point r sin α. Of two
/// profiles that lie on one side of the contact the larger is concave. The check takes its own force, and its own
/// quadrature. What presses nothing (no force found, none there, a pull) or has no face of contact (equal radii) is a
/// remark.
void find_contacts(Solution& solution);

}  // namespace kinegraph
