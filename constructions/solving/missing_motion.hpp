// What of a motion is not found, and why: drivers that ask for another motion than there is, bodies that nothing moves
// in one way, accelerations and curvatures that want what the file does not give.
#pragma once

#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/plan.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// A motion that was drawn, and what it was drawn from.
struct DrawnMotion {
    Solution& solution;  ///< which the reasons are added to
    const Structure& structure;
    Board& board;
    const Plan& plan;
    const Motion& motion;
    bool accelerations;                    ///< whether they are wanted
    const std::vector<Message>& mistakes;  ///< that the file most likely has
};

/// A driver that fixes nothing new must ask what the mechanism does anyway; if not, it drives against a dead point or a
/// lock.
void explain_idle_drivers(const DrawnMotion& drawn);
void explain_missing_motion(const DrawnMotion& drawn);
/// Of bodies that move in a known way; what hides the motion of others is said already.
void explain_missing_curvature(const DrawnMotion& drawn);

}  // namespace kinegraph
