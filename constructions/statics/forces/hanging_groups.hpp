// Which members hang together by their bonds: afloat, or on the frame. Asks no force.
#pragma once

#include <vector>

#include "constructions/statics/force_model.hpp"

namespace kinegraph::statics {

/// Members that hang together, and neither on the frame nor on an effort.
std::vector<Group> floating_groups(const ForceModel& model);
/// Structures of more than one body that hang on the frame and on no effort; not a single body held by bars: cut free
/// with them or without, the same lines act on it.
std::vector<Group> hung_on_frame(const ForceModel& model);
/// Bodies that no other body and no effort holds, but the frame: each with the pins on it.
std::vector<Group> single_on_frame(const ForceModel& model);

}  // namespace kinegraph::statics
