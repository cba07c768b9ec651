// Hertz's contact: half axes, pressure and approach by the closed forms of the theory, and the stresses below the
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
#pragma once

#include "engine/solution/problem_solution.hpp"

namespace kinegraph {

/// `checked`: the same with the force of the numeric check, where the force itself was found.
/// Errors: numbers so far apart that no double holds what comes of them.
Result<ProblemSolution> solve_hertz(const HertzProblem& problem, const HertzProblem& checked);
inline Result<ProblemSolution> solve_hertz(const HertzProblem& problem) { return solve_hertz(problem, problem); }

/// The stresses on the axis of a contact whose axes and pressure are known, in a material of Poisson's ratio ν, at a
/// depth z ≥ 0 (m). Shear is that in the plane across the shorter axis, ½|σ_y − σ_z| (of a line across it): of round
/// contacts and lines the textbook's one, of ellipses between.
HertzSolution::Stress hertz_stress(const HertzSolution& contact, double poisson, double z);

}  // namespace kinegraph
