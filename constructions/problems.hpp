// Problems stated in place of joints, each given to its own method.
#pragma once

#include "engine/pose.hpp"
#include "engine/problem.hpp"

namespace kinegraph {

/// Errors: what no number of such a problem can be, with its place; bodies between which nothing happens.
Result<ProblemSolution> solve_problem(const Problem& problem, const Mechanism& mechanism, const Pose& pose);

}  // namespace kinegraph
