// Reye's hypothesis: the volume worn off goes with the work of friction, so the depth worn off with pressure × sliding.
// What the bodies can do while they wear in gives the depth's form, equilibrium its size (Ferrari and Romiti, Meccanica
// applicata alle macchine; Shigley, Mechanical Engineering Design, 16–1 … 16–6).
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
#pragma once

#include "engine/solution/problem_solution.hpp"

namespace kinegraph {

/// Errors: a leading shoe that locks itself (no_unique_answer); numbers too far apart.
Result<ProblemSolution> solve_reye(const ReyeProblem& problem);

}  // namespace kinegraph
