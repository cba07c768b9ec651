// Oversights: what the author of a file probably forgot, read off its structure where more is free than is driven or
// held. Knows no way of solving; a mechanism that is determined has none.
#pragma once

#include <vector>

#include "engine/motion/mobility.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// Points that two bodies share without a joint, bodies without a joint or with one only, groups that nothing connects
/// with the frame: a sentence each, with the joint that is likely to be missing. A body that one of them names has no
/// second one.
std::vector<Message> oversights(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility);

}  // namespace kinegraph
