// The loads on each member, read from the file onto the board: forces, couples, springs, distributed loads, weights,
// and inertia forces by d’Alembert's principle; with the sentences for those that must be computed first.
#pragma once

#include <map>
#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "constructions/statics/force_nouns.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/findings.hpp"

namespace kinegraph::statics {

/// For each hinge with its own node: the member that is its pin.
using PinMembers = std::map<JointIndex, MemberIndex>;

struct LoadsOfMembers {
    std::vector<Load> loads;  ///< none that vanishes, none on the frame
    /// Inertia forces offset so that they include their couples, and their arms.
    std::vector<Sum> moved;
    std::vector<Arm> shifts;
    /// Why loads could not be read (an inertia force without an acceleration, a spring without length).
    std::vector<Unsolved> missing;
};

LoadsOfMembers loads_of_members(Structure& structure, Board& board, const Motion& motion, const PinMembers& pins);

}  // namespace kinegraph::statics
