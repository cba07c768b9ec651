// Impact of two rigid bodies in the plane, exactly: momentum and moment of momentum, Coulomb's friction and Poisson's
// restitution, followed from phase to phase as in Routh's diagram of impulses (Routh, Dynamics of a System of Rigid
// Bodies, Elementary Part, art. 187–198; Whittaker, Analytical Dynamics, art. 95).
//   Δu_n = a J_n + b J_t,  Δu_t = b J_n + c J_t,  a = nᵀKn, b = nᵀKt, c = tᵀKt,  K = Σ (1/m + (r⊥ r⊥ᵀ)/J)
//   sliding dJ_t = ∓f dJ_n against the slip; sticking on the line u_t = 0, where |b/c| ≤ f; the greatest compression on
//   u_n = 0; the end at J_n = (1 + e) times that of the greatest compression.
#pragma once

#include "engine/drawing/pose.hpp"
#include "engine/solution/problem_solution.hpp"

namespace kinegraph {

/// Errors: bodies that part or keep their distance at the point of impact; a body on a pivot with its centre on it and
/// no inertia; with friction so great that sliding jams, where rigid bodies have no answer (no_unique_answer).
Result<ProblemSolution> solve_impact(const ImpactProblem& problem, const Mechanism& mechanism, const Pose& pose);

}  // namespace kinegraph
