// Branches: what a degenerate position allows. The rank leaves a space of velocities; where constraints repeat each
// other the accelerations exist only for some of them, and these are the branches that leave the position. Draws
// nothing.
#pragma once

#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/mobility.hpp"

namespace kinegraph {

/// One way out of a change point, as ratios of angular velocities.
struct Branch {
    BodyIndex reference = none;  ///< the driven body, or the first that turns; none: no body turns
    std::vector<double> ratios;  ///< by BodyIndex: ω_b/ω_reference; empty where no body turns
    std::vector<Exact> exact;    ///< the same where it is rational and the pose exact; else empty
};

/// Velocities u that the constraints J u = 0 allow at this pose, and what the second order says to them: J a = −q(u)
/// has a solution only where every row vector s with s J = 0 (a state of self-stress) has s·q(u) = 0. These are
/// quadratic forms on the space of u; where they vanish alike, nothing is asked. To the second order only: a branch is
/// necessary, not proved to go on.
struct InstantMotion {
    enum class SecondOrder {
        unasked,     ///< no constraint repeats another
        free,        ///< every velocity has an acceleration
        branches,    ///< only those of `branches`
        impossible,  ///< none: the position moves for an instant only (shaky)
        open         ///< more than two freedoms, or a contact whose curvature the file does not say
    };
    SecondOrder second_order = SecondOrder::unasked;
    int freedoms = 0;    ///< dimension of the space of velocities
    int conditions = 0;  ///< states of self-stress whose quadratic form does not vanish
    std::vector<Branch> branches;
    std::vector<BodyIndex> still;      ///< bodies at rest in every motion that the position allows, but for the frame
    std::vector<BodyIndex> unturning;  ///< bodies that move, but turn in none
};

/// Exact on an exact pose. On a pose with a leftover in 400-bit arithmetic, where what is below 2^-60 of the drawing's
/// size counts as zero; if that is not the rank that `mobility` found, the second order stays open. Source: Connelly
/// and Whiteley, Second-order rigidity and prestress stability, SIAM J. Discrete Math. 9 (1996).
InstantMotion instant_motion_of(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility);

}  // namespace kinegraph
