#include "engine/drawing/spring_force.hpp"

namespace kinegraph {
namespace {

/// |PQ|: exact where it is rational, else to the precision of the drawing.
Exact distance(PointIndex from, PointIndex to, const Pose& pose) {
    const Vector apart = pose.at(to) - pose.at(from);
    return apart.is_zero() ? Exact() : dot(apart, unit_along(apart, pose.bits));
}

}  // namespace

Exact pull_of(const SpringLoad& spring, const Pose& pose) {
    if (!spring.elastic) return spring.magnitude;
    return spring.elastic->stiffness *
           (distance(spring.between[0], spring.between[1], pose) - spring.elastic->free_length);
}

Centroid centroid_of(const DistributedLoad& load) {
    const auto& [at_from, at_to] = load.intensity;
    const Exact both = at_from + at_to;
    if (both.is_zero()) return {true, Exact::ratio(1, 3)};
    return {false, (at_from + 2 * at_to) / (3 * both)};
}

Exact force_of(const DistributedLoad& load, const Pose& pose) {
    const auto& [at_from, at_to] = load.intensity;
    const Exact sum = centroid_of(load).is_couple ? at_to : at_from + at_to;
    return sum * distance(load.from, load.to, pose) / 2;
}

}  // namespace kinegraph
