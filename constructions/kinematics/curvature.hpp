// Curvature: the motion of each body to the second order, as geometry. Finds the pole and its tangent, the inflection
// circle, the centres of curvature of points' paths and of straight lines' envelopes, Bresse's circles and the
// acceleration pole. All numbers come from the board. Accelerations are only used for a body without two known paths.
//
// Sources: Euler (1765) and Savary (1845) for conjugate points; Bobillier (1870) for the pole tangent; Bresse (1853)
// for the two circles; all as in Dijksman, Motion Geometry of Mechanisms (1976), and Hall, Kinematics and Linkage
// Design (1961).
#pragma once

#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/curvature.hpp"

namespace kinegraph {

/// For all moving bodies whose velocities and accelerations are known in `motion`, in the file's order.
std::vector<Curvature> draw_curvature(Structure& structure, Board& board, const Motion& motion);

}  // namespace kinegraph
