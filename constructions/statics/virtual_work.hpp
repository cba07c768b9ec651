// Virtual work: the second way to the efforts, which needs no reaction.
#pragma once

#include <optional>
#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// The powers (W) of all that acts from outside on the free bodies, in the motion of the velocity polygon. Ideal pairs
/// do no work, so they cancel: d'Alembert's principle where forces of inertia are among them. Nothing where no such
/// force acts or the motion of a body that carries one is not known.
std::optional<VirtualWork> virtual_work(const Structure& structure, Board& board,
                                        const Track<Plane::velocity>& velocities, const std::vector<FreeBody>& bodies);

/// The same of loads, weights and springs alone, without reactions, and beside them the power of one unit of each
/// effort: what virtual displacements need, the velocities being displacements. Nothing where the motion of a body that
/// carries one is not known.
std::optional<VirtualWork> works_of_displacement(Structure& structure, Board& board, const Motion& motion);

}  // namespace kinegraph
