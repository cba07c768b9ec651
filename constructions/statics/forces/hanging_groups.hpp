// Connected components of members; which of them are attached to the frame. Uses no forces.
#pragma once

#include <vector>

#include "constructions/statics/force_model.hpp"

namespace kinegraph::statics {

/// Groups of connected members without a bond to the frame or an input force.
std::vector<Group> floating_groups(const ForceModel& model);
/// Structures of more than one body with bonds to the frame and without input force. Excludes a single body supported
/// by bars: with or without the bars, the same lines act on it.
std::vector<Group> hung_on_frame(const ForceModel& model);
/// Bodies with bonds to the frame only; each with the pins on it.
std::vector<Group> single_on_frame(const ForceModel& model);

}  // namespace kinegraph::statics
