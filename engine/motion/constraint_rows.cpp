#include "engine/motion/constraint_rows.hpp"

namespace kinegraph {
namespace {

/// The directions along which the bodies have the same velocity at the joint's point.
std::vector<Vector> directions_binding(const PlanePair& pair, const Pose& pose, std::size_t slot) {
    if (pair.holds_point()) return {{1, 0}, {0, 1}};
    std::vector<Vector> held;
    if (pair.holds_normal) held.push_back(pose.normals[slot]);
    if (pair.holds_tangent) held.push_back(pose.tangents[slot]);
    return held;
}

void write(const Joint& joint, JointIndex index, const Pose& pose, std::vector<ConstraintRow>& rows) {
    const std::vector<Vector> held = directions_binding(joint.pair(), pose, at_index(index));
    for (std::size_t k = 1; k < joint.bodies.size(); ++k) {
        for (const Vector& along : held)
            rows.push_back({index, joint.bodies[0], joint.bodies[k], joint.point, along, false});
        if (joint.pair().holds_rotation)
            rows.push_back({index, joint.bodies[0], joint.bodies[k], joint.point, {}, true});
    }
}

}  // namespace

std::vector<ConstraintRow> constraint_rows(const Mechanism& mechanism, const Pose& pose) {
    std::vector<ConstraintRow> rows;
    for (const JointIndex joint : indices_of(mechanism.joints)) write(mechanism.joint(joint), joint, pose, rows);
    return rows;
}

}  // namespace kinegraph
