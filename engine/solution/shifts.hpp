// The displacement d = M/F of a force that replaces a force and a couple, where bodies were taken together. Read from
// the results.
#pragma once

#include <optional>

#include "engine/solution/solution.hpp"

namespace kinegraph {

/// The displacement of a sum's line of action by the statement, perpendicular to it, m. None: the statement displaces
/// another force, or none.
std::optional<Vector> shift_of(const Solution& solution, StatementIndex statement, const AppliedForce& sum);

}  // namespace kinegraph
