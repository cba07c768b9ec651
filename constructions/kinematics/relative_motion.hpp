// Relative motion: a point's velocity and acceleration as two observers see them, one fixed and one carried by a body
// or translating with a point (transport, relative and Coriolis terms; theorem of Coriolis, 1835). And the sliding of
// each sliding pair.
#pragma once

#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Sees to it that the places needed later are nodes, so that the plan reaches them.
void add_nodes_of_interest(Structure& structure);

/// i seen from j at every prismatic pair and pin-slot whose two places have been drawn.
std::vector<Sliding> draw_slidings(Structure& structure, Board& board, const Motion& motion, bool with_accelerations);

/// The asked relative motions, each with a small polygon of its own.
std::vector<RelativeMotion> draw_relative_motions(Structure& structure, Board& board, const Motion& motion,
                                                  bool with_accelerations);

}  // namespace kinegraph
