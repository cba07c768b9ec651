// What the public face asks of the kinds of problems beyond what engine and render know of them.
#pragma once

#include <vector>

#include "engine/solution/problem_kind.hpp"
#include "render/equations/equation_text.hpp"

namespace kinegraph::app {

/// The formulas of a solved problem as one list, without figures.
using EquationsOfProblem = std::vector<render::EquationItem> (*)(const Solution& solution, Language language);
/// Null: the file states no problem, or one that is not told by formulas alone.
EquationsOfProblem equations_of_problem(const Mechanism& mechanism);

}  // namespace kinegraph::app
