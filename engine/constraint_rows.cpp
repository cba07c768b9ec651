#include "engine/constraint_rows.hpp"

namespace kinegraph {
namespace {

void write(const Joint& joint, JointIndex index, const Pose& pose, std::vector<ConstraintRow>& rows) {
    const auto slot = static_cast<std::size_t>(index);
    const auto equal_speeds = [&](BodyIndex j, const Vector& along) {
        rows.push_back({index, joint.bodies[0], j, joint.point, along, false});
    };
    const auto equal_turns = [&](BodyIndex j) { rows.push_back({index, joint.bodies[0], j, joint.point, {}, true}); };
    const auto pinned = [&](BodyIndex j) {
        equal_speeds(j, {1, 0});
        equal_speeds(j, {0, 1});
    };
    switch (joint.kind) {
        case JointKind::revolute:
            for (std::size_t k = 1; k < joint.bodies.size(); ++k) pinned(joint.bodies[k]);
            return;
        case JointKind::weld:
            for (std::size_t k = 1; k < joint.bodies.size(); ++k) {
                pinned(joint.bodies[k]);
                equal_turns(joint.bodies[k]);
            }
            return;
        case JointKind::prismatic:
            equal_speeds(joint.bodies[1], quarter_turn(pose.guides[slot]));
            equal_turns(joint.bodies[1]);
            return;
        case JointKind::pin_slot:
        case JointKind::contact:
            equal_speeds(joint.bodies[1], pose.normals[slot]);
            return;
        case JointKind::rolling:
            pinned(joint.bodies[1]);
            return;
        case JointKind::gear:
            equal_speeds(joint.bodies[1], pose.tangents[slot]);
            return;
    }
}

}  // namespace

std::vector<ConstraintRow> constraint_rows(const Mechanism& mechanism, const Pose& pose) {
    std::vector<ConstraintRow> rows;
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) write(mechanism.joints[i], static_cast<JointIndex>(i), pose, rows);
    return rows;
}

}  // namespace kinegraph
