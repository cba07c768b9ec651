// A relative motion taken apart: the transport about the origin of the moving axes, Poisson's formulae, what the
// observer sees in his axes, and Coriolis' term with its sense, or why there is none. Items as those of the equations.
#pragma once

#include <cstddef>
#include <vector>

#include "render/equations/equation_text.hpp"

namespace kinegraph::render {

/// Of Solution::relative_motion[index], which has its `apart`.
std::vector<EquationItem> apart_items(const Solution& solution, std::size_t index, Language language);

}  // namespace kinegraph::render
