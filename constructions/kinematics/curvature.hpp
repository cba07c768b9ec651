// Curvature: the motion of each body to the second order, as geometry. The pole and its tangent, the inflection circle,
// the centre of curvature of any point's path, that of a straight line's envelope, Bresse's circles and the
// acceleration pole. It asks the board, never computes; of accelerations it takes no more than a body needs of which no
// two paths are known.
//
// Sources: Euler (1765) and Savary (1845) for conjugate points; Bobillier (1870) for the pole tangent; Hartmann (1893)
// for the centre of curvature by the velocity of the pole; Bresse (1853) for the two circles; all as in Dijksman,
// Motion Geometry of Mechanisms (1976), and Hall, Kinematics and Linkage Design (1961).
#pragma once

#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Of all moving bodies whose velocities and accelerations are known in `motion`, in the file's order.
std::vector<Curvature> draw_curvature(Structure& structure, Board& board, const Motion& motion);

}  // namespace kinegraph
