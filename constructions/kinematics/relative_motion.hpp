// Relative motion: a point's velocity and acceleration for two observers, one fixed and one moving with a body or
// translating with a point (transport, relative and Coriolis terms; theorem of Coriolis, 1835). Also the sliding in
// each sliding pair.
#pragma once

#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/solution/motion.hpp"

namespace kinegraph {

/// Adds the places needed later as nodes, so that the plan reaches them.
void add_nodes_of_interest(Structure& structure);

/// Motion of i relative to j at every prismatic pair and pin-slot whose two places have been drawn.
std::vector<Sliding> draw_slidings(Structure& structure, Board& board, const Motion& motion, bool with_accelerations);

/// The relative motions in the file's "find", each with its own small polygon.
std::vector<RelativeMotion> draw_relative_motions(Structure& structure, Board& board, const Motion& motion,
                                                  bool with_accelerations);

}  // namespace kinegraph
