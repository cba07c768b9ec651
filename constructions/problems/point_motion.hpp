// The motion of a point: derivatives of its laws in symbols (engine/file/algebra.hpp), place, velocity and acceleration
// from them, and, on the board, the components of the acceleration along tangent and normal and the centre of
// curvature.
//
// Sources: the intrinsic components, Huygens; the centre of curvature from v and a_n by the altitude of a right
// triangle, Euclid II.14 (ρ a_n = v²).
#pragma once

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/solution/problem_solution.hpp"

namespace kinegraph {

/// Errors: laws that are not real or infinite at the instant or on the way, each at its place; no algebra.
Result<ProblemSolution> solve_point_motion(const PointProblem& problem, const Mechanism& mechanism, const Pose& pose);

}  // namespace kinegraph
