#include "engine/solution/motion.hpp"

namespace kinegraph {

Quantity velocity_of(const PointMotion& motion) {
    return {.kind = Quantity::Kind::velocity, .body = motion.bodies.front(), .point = motion.point};
}
Quantity acceleration_of(const PointMotion& motion) {
    return {.kind = Quantity::Kind::acceleration, .body = motion.bodies.front(), .point = motion.point};
}
Quantity quantity_of(const InstantCentre& centre) {
    return {.kind = Quantity::Kind::centre, .body = centre.first, .other = centre.second};
}

}  // namespace kinegraph
