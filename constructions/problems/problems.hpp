// Solves problems stated without joints, each by its own method.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/solution/problem_solution.hpp"

namespace kinegraph {

/// Errors: values impossible for the problem, with their place; bodies that do not interact.
Result<ProblemSolution> solve_problem(const Problem& problem, const Mechanism& mechanism, const Pose& pose);

/// The error if a result or its check is not a finite number because the data differ too much in size. `where`: the
/// problem's place.
std::optional<Errors> why_no_numbers(const std::vector<ProblemValue>& values, const std::string& where);

}  // namespace kinegraph
