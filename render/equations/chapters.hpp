// Chapters of prose and formulas beside the closure equations: relative motion taken apart, virtual work.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/solution/displacements.hpp"
#include "lang/words.hpp"
#include "render/equations/equation_text.hpp"
#include "render/text/words.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

// ----- Decomposition of a relative motion: transport motion about the origin of the moving axes, Poisson's formulae,
// the motion seen in the moving axes, and the Coriolis term with its sense, or why it vanishes.

/// For Solution::relative_motion[index], whose `apart` must be present.
std::vector<EquationItem> apart_items(const Solution& solution, std::size_t index, Language language);

// ----- Virtual work as calculated by hand: the displaced coordinate, forces and displacements in a table, the sum, and
// the input forces or couples; then the same by the velocity ratios of the closure equations. All numbers come from the
// displacements.

/// Empty if virtual work is not requested. If it does not apply, the reason.
std::vector<EquationItem> virtual_work_items(const Solution& solution, Language language);

/// "δθ_3", "δs_D": the displaced coordinate.
RichText displaced_coordinate(const Mechanism& mechanism, const Driver& driver);

}  // namespace kinegraph::render
