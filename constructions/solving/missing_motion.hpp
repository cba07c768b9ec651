// Reasons for missing results of a motion: drivers that impose an impossible motion, bodies whose motion is not
// determined, accelerations and curvatures that need data not in the file.
#pragma once

#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/plan.hpp"
#include "constructions/kinematics/structure.hpp"

namespace kinegraph {

struct Solution;

/// A motion that was drawn, with its inputs.
struct DrawnMotion {
    Solution& solution;  ///< to which the reasons are added
    const Structure& structure;
    Board& board;
    const Plan& plan;
    const Motion& motion;
    bool accelerations;                    ///< whether they were requested
    const std::vector<Message>& mistakes;  ///< likely mistakes in the file
};

/// A driver that determines nothing new must agree with the motion; otherwise it acts against a dead point or a lock.
void explain_idle_drivers(const DrawnMotion& drawn);
void explain_missing_motion(const DrawnMotion& drawn);
/// For bodies with known motion; for the others the reason was already given.
void explain_missing_curvature(const DrawnMotion& drawn);

}  // namespace kinegraph
