// Virtual work: an independent way to the input forces and couples, without reactions.
#pragma once

#include <optional>
#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/forces.hpp"

namespace kinegraph {

/// The powers (W) of all external forces on the free bodies, in the motion of the velocity polygon. Ideal pairs do no
/// work, so their powers cancel; with inertia forces this is d'Alembert's principle. None if there is no such force, or
/// the motion of a body with one is not known.
std::optional<VirtualWork> virtual_work(const Structure& structure, Board& board,
                                        const Track<Plane::velocity>& velocities, const std::vector<FreeBody>& bodies);

/// The powers of loads, weights and springs, without reactions, and the power of one unit of each input force or
/// couple. Velocities serve as virtual displacements. None if the motion of a loaded body is not known.
std::optional<VirtualWork> works_of_displacement(Structure& structure, Board& board, const Motion& motion);

}  // namespace kinegraph
