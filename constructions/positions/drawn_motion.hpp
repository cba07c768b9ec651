// What a figure of a motion shows: other positions of the mechanism, and paths of points.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/motion/positions.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph {

/// One of the positions that are drawn, as rigid motions of the bodies (by BodyIndex) from the drawn position.
struct OtherPosition {
    double coordinate = 0;  ///< of the driver
    double share = 0;       ///< of the travel, from 0 to 1
    std::vector<RigidMotion> bodies;
};
/// `count` positions at even steps of the driver's coordinate, from one end of the travel to the other, limits
/// included. Where the mechanism is in the same position at both ends, as after a whole turn, the last step leads back
/// to the first position, which is not repeated. A position that cannot be reached is left out.
std::vector<OtherPosition> other_positions(const Positions& positions, const Travel& travel, int count);

/// A point whose path is followed, as seen from a body.
struct TracedPoint {
    PointIndex point;
    BodyIndex on = frame;
};
using PathPlaces = std::vector<VectorOf<double>>;  ///< m, in order along the travel
/// By traced point its path from one end of the travel to the other, as a polyline so fine that no corner is seen: at
/// most 1/10000 of the drawing's size off the path. More than one piece where a part of the travel cannot be reached.
std::vector<std::vector<PathPlaces>> paths_of(const Positions& positions, const Travel& travel,
                                              const std::vector<TracedPoint>& traced);

}  // namespace kinegraph
