// The instantaneous motion of one body: from the velocities of some of its points, given as vectors or as directions
// only, those of all other points and the instant centre; then the same for accelerations. All numbers come from the
// board.
//
// Sources: Rivals 1853 for velocities and accelerations of two points (so that velocities have equal projections on
// their join); Euler and Chasles for the centre; Assur (1914) for the auxiliary point where three directions of
// accelerations are given.
#pragma once

#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/findings.hpp"
#include "engine/solution/motion.hpp"

namespace kinegraph {

struct InstantaneousMotionResult {
    Motion motion;                     ///< tips and spins of the body, as for a mechanism
    InstantaneousMotionFigure figure;  ///< what else the figure shows
    InstantCentre centre;              ///< of the body against the frame; unknown if the data do not determine it
    std::vector<Unsolved> unsolved;
};

/// What to find. Velocities are always drawn, since all else depends on them.
struct InstantaneousMotionWishes {
    bool centre = true, velocities = true, accelerations = false;
};

/// Draws the instantaneous motion of `mechanism.motion`. Velocities that no rigid motion has are not continued: the
/// result names the two points, with both projections where these differ.
InstantaneousMotionResult draw_instantaneous_motion(Structure& structure, Board& board,
                                                    const InstantaneousMotionWishes& wishes);

}  // namespace kinegraph
