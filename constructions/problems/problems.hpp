// Problems stated in place of joints, each given to its own method.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/solution/problem_solution.hpp"

namespace kinegraph {

/// Errors: what no number of such a problem can be, with its place; bodies between which nothing happens.
Result<ProblemSolution> solve_problem(const Problem& problem, const Mechanism& mechanism, const Pose& pose);

/// Why these results are none, where one of them or its check is no number: data too far apart. `where`: the problem's
/// place.
std::optional<Errors> why_no_numbers(const std::vector<ProblemValue>& values, const std::string& where);

}  // namespace kinegraph
