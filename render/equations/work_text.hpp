// Virtual work as it is worked by hand: what is displaced, forces and displacements in a table, the sum, the efforts;
// and the same by the velocity ratios of the closure equations. Items as those of the equations, which the sheet sets.
// Takes every number from the displacements.
#pragma once

#include <vector>

#include "engine/solution/displacements.hpp"
#include "render/equations/equation_text.hpp"

namespace kinegraph::render {

/// Nothing where they are not asked for; where there are none, why.
std::vector<EquationItem> virtual_work_items(const Solution& solution, Language language);

/// "δθ_3", "δs_D": the coordinate that is displaced.
RichText displaced_coordinate(const Mechanism& mechanism, const Driver& driver);

}  // namespace kinegraph::render
