// Motions in the large: what takes a body from one position to another, by the bisectors, and where a crank that
// carries one of its points through three positions has its fixed pivot.
//
// Sources: the pole of a finite displacement, Euler and Chasles; three positions, Burmester 1888.
#pragma once

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/solution/problem_solution.hpp"

namespace kinegraph {

Result<ProblemSolution> solve_positions(const PositionsProblem& problem, const Mechanism& mechanism, const Pose& pose);

}  // namespace kinegraph
