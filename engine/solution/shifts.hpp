// The displacement d = M/F of a force that replaces a force and a couple, where bodies were taken together. Read from
// the results.
#pragma once

#include <optional>
#include <vector>

#include "engine/board/protocol.hpp"
#include "engine/solution/forces.hpp"

namespace kinegraph {

/// The displacement of a sum's line of action by the statement, perpendicular to it, m. None: the statement displaces
/// another force, or none. `bodies`: cut free under all loads, or under those of one body alone.
std::optional<Vector> shift_of(const Protocol& protocol, const std::vector<FreeBody>& bodies, StatementIndex statement,
                               const AppliedForce& sum);

}  // namespace kinegraph
