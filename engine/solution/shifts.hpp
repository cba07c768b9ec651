// By how much a force was moved aside for a couple, d = M/F, where bodies were taken together. Reads what was found;
// owns no construction.
#pragma once

#include <optional>

#include "engine/solution/solution.hpp"

namespace kinegraph {

/// From the line of a sum before the statement moved it aside for a couple to where it is then, square to it, m. None:
/// the statement moves another force, or none.
std::optional<Vector> shift_of(const Solution& solution, StatementIndex statement, const AppliedForce& sum);

}  // namespace kinegraph
