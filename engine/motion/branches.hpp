// Branches of a degenerate position. The rank leaves a space of velocities; where constraints are redundant,
// accelerations exist only for some of these velocities: the branches that leave the position.
#pragma once

#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/mobility.hpp"

namespace kinegraph {

/// One way out of a change point, as ratios of angular velocities.
struct Branch {
    BodyIndex reference = none;  ///< the driven body, or the first by name that rotates; none: no body rotates
    std::vector<double> ratios;  ///< by BodyIndex: ω_b/ω_reference; empty where no body turns
    std::vector<Exact> exact;    ///< the same where it is rational and the pose exact; else empty
};

/// Velocities u with J u = 0 at this pose, and the second-order condition on them: J a = −q(u) has a solution only if
/// every row vector s with s J = 0 (a state of self-stress) has s·q(u) = 0. These are quadratic forms on the space of
/// u; where they vanish identically, there is no condition. To second order only: the condition is necessary, a branch
/// is not proved to continue.
struct InstantMotion {
    enum class SecondOrder {
        unasked,     ///< no constraint is redundant
        free,        ///< every velocity has an acceleration
        branches,    ///< only those of `branches`
        impossible,  ///< none: the position moves for an instant only (shaky)
        open         ///< undecided: more than two freedoms, or a contact of unknown curvature
    };
    SecondOrder second_order = SecondOrder::unasked;
    int freedoms = 0;                  ///< dimension of the space of velocities
    int conditions = 0;                ///< states of self-stress whose quadratic form does not vanish
    std::vector<Branch> branches;      ///< by comes_before() of engine/motion/branch_order.hpp
    std::vector<BodyIndex> still;      ///< bodies at rest in every possible motion, except the frame
    std::vector<BodyIndex> unturning;  ///< bodies that move but never rotate
};

/// Exact on an exact pose. On a pose with a leftover in 400-bit arithmetic, where values below 2^-60 of the drawing's
/// size count as zero; if the rank then differs from that of `mobility`, the second order is undecided. Source:
/// Connelly and Whiteley, Second-order rigidity and prestress stability, SIAM J. Discrete Math. 9 (1996).
InstantMotion instant_motion_of(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility);

}  // namespace kinegraph
