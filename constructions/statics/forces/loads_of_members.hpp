// What loads each member, read from the file onto the board: forces, couples, springs, distributed loads, weights, and
// by d’Alembert the inertia of what moves; with the sentences of those that are found first. Knows no bond.
#pragma once

#include <map>
#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "constructions/statics/force_nouns.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph::statics {

/// By a hinge with a node of its own: the member that is its pin.
using PinMembers = std::map<JointIndex, MemberIndex>;

struct LoadsOfMembers {
    std::vector<Load> loads;  ///< none that vanishes, none on the frame
    /// Inertia forces moved aside so that they carry their couples, and by what.
    std::vector<Added> moved;
    std::vector<Lever> shifts;
    /// Why loads could not be read (an inertia force without an acceleration, a spring without length).
    std::vector<Unsolved> missing;
};

LoadsOfMembers loads_of_members(Structure& structure, Board& board, const Motion& motion, const PinMembers& pins);

}  // namespace kinegraph::statics
