// Constraint rows: the conditions of each pair on the velocities of its bodies, one scalar condition a row. The rank
// and everything derived from it use this one list, in the arithmetic of the pose.
#pragma once

#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// along · (v_i(P) − v_j(P)) = 0, or ω_i = ω_j.
struct ConstraintRow {
    JointIndex joint = none;
    BodyIndex i = none, j = none;
    PointIndex point = none;
    Vector along;  ///< any length; unused where `turn`
    bool turn = false;
};

/// The rows of all joints, in the file's order: those of the pair, for each body after the first.
std::vector<ConstraintRow> constraint_rows(const Mechanism& mechanism, const Pose& pose);

}  // namespace kinegraph
