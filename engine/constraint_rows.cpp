#include "engine/constraint_rows.hpp"

namespace kinegraph {
namespace {

/// Along which directions the bodies have one speed at the joint's point.
std::vector<Vector> held_directions(const PlanePair& pair, const Pose& pose, std::size_t slot) {
    switch (pair.held) {
        case PlanePair::Held::along_normal:
            return {pose.normals[slot]};
        case PlanePair::Held::along_tangent:
            return {pose.tangents[slot]};
        case PlanePair::Held::wholly:
            break;
    }
    return {{1, 0}, {0, 1}};
}

void write(const Joint& joint, JointIndex index, const Pose& pose, std::vector<ConstraintRow>& rows) {
    const std::vector<Vector> held = held_directions(joint.pair(), pose, static_cast<std::size_t>(index));
    for (std::size_t k = 1; k < joint.bodies.size(); ++k) {
        for (const Vector& along : held) rows.push_back({index, joint.bodies[0], joint.bodies[k], joint.point, along, false});
        if (joint.pair().holds_rotation) rows.push_back({index, joint.bodies[0], joint.bodies[k], joint.point, {}, true});
    }
}

}  // namespace

std::vector<ConstraintRow> constraint_rows(const Mechanism& mechanism, const Pose& pose) {
    std::vector<ConstraintRow> rows;
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) write(mechanism.joints[i], static_cast<JointIndex>(i), pose, rows);
    return rows;
}

}  // namespace kinegraph
