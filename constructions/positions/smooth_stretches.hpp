// Smooth stretches: the pieces of a travel on which the driver's motion has no break.
#pragma once

#include <vector>

#include "constructions/positions/followed_curve.hpp"
#include "engine/mechanism/law.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph {

struct SmoothStretch {
    FollowedCurve::Stretch stretch;
    int intervals = 0;  ///< for the first samples
};
/// In order. `turns`: the driver's coordinate is an angle. `law`: the driver's, null if it has none.
std::vector<SmoothStretch> smooth_stretches(const Travel& travel, bool turns, const Law* law);

}  // namespace kinegraph
