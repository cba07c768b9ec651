// Degeneracy: what there is to say of a position where the rank and the count differ, or a driver drives nothing.
#pragma once

#include <optional>
#include <vector>

#include "engine/motion/branches.hpp"
#include "engine/motion/mobility.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// The motions of this position, where there is a reason to look: constraints that repeat others, or a driver that
/// fixes nothing.
std::optional<InstantMotion> degenerate_motion(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility);

/// Redundant constraints, bodies that cannot be driven, branches of a change point: one sentence each.
std::vector<Message> remarks_on_mobility(const Mechanism& mechanism, const Mobility& mobility,
                                         const std::optional<InstantMotion>& motion);

/// Links of which all pins lie at one place: each is told with their names, since a crank of length zero was hardly
/// meant.
std::vector<Message> remarks_on_lengths(const Mechanism& mechanism, const Pose& pose);

/// Gravity as it is on no planet: most likely a bare number in a unit that was not thought of.
std::vector<Message> remarks_on_gravity(const Mechanism& mechanism);

}  // namespace kinegraph
