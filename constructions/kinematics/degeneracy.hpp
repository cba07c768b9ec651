// Remarks on degenerate positions: where rank and count of constraints differ, or a driver determines nothing.
#pragma once

#include <optional>
#include <vector>

#include "engine/motion/branches.hpp"
#include "engine/motion/mobility.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// The motions of this position, if constraints are redundant or a driver determines nothing.
std::optional<InstantMotion> degenerate_motion(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility);

/// Redundant constraints, bodies that cannot be driven, branches of a change point: one sentence each.
std::vector<Message> remarks_on_mobility(const Mechanism& mechanism, const Mobility& mobility,
                                         const std::optional<InstantMotion>& motion);

/// Links whose pins all coincide, by name: a crank of zero length is probably a mistake.
std::vector<Message> remarks_on_lengths(const Mechanism& mechanism, const Pose& pose);

/// Gravity far from any real value: probably a bare number in the wrong unit.
std::vector<Message> remarks_on_gravity(const Mechanism& mechanism);

}  // namespace kinegraph
