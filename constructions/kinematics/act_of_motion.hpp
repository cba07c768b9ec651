// The act of motion of one body: what the velocities of some of its points, wholly given or in direction only, say of
// all the others, and where the centre of instantaneous rotation is; then the same for accelerations. It asks the
// board, never computes.
//
// Sources: Rivals 1853 for velocities and accelerations of two points (so that velocities project alike on their join);
// Euler and Chasles for the centre; Assur (1914) for the auxiliary point where three directions of accelerations are
// given.
#pragma once

#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

struct ActOfMotionResult {
    Motion motion;         ///< tips and spins of the body, as of a mechanism's
    ActFigure figure;      ///< what the drawing shows besides
    InstantCentre centre;  ///< of the body against the frame; unknown where the data do not tell
    std::vector<Unsolved> unsolved;
};

/// What of it is asked for; velocities are drawn in any case, since all else hangs on them.
struct ActWishes {
    bool centre = true, velocities = true, accelerations = false;
};

/// Draws the act of motion of `mechanism.motion`. Velocities that no rigid motion has are not drawn further: the result
/// says between which points, and has both projections where these differ.
ActOfMotionResult draw_act_of_motion(Structure& structure, Board& board, const ActWishes& wishes);

}  // namespace kinegraph
