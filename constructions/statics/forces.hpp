// Forces: graphical statics and kinetostatics of the whole mechanism. Lines of action before magnitudes, body by body:
// two-force bodies, three forces through one point, Culmann's line for four, a couple as an arm; bodies that slide in
// one another taken together; several loads by superposition; and what no order of bodies resolves by one trial value
// (everything is linear).
//
// A Bond is what two bodies may exert on each other at a joint or through an effort. It may be a force through a point
// (hinge, rolling), a force normal to a guide with an unknown place (sleeve), a force along a line (slot, contact,
// gear, actuator, force), a couple, or all three (weld). Sources: Culmann, Die graphische Statik (1866); Cremona
// (1872); Ritter's method of moments (1863).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

struct ForceResults {
    std::vector<JointForce> joints;
    std::vector<EffortValue> efforts;
    std::vector<FreeBody> bodies;  ///< in the order in which they were resolved
    std::vector<Unsolved> unsolved;
    std::vector<Message> remarks;
    std::vector<Resultant> resultants;  ///< of bodies that nothing holds
    std::optional<Truss> truss;         ///< where the mechanism is one; its bars are not cut free one by one then
    std::vector<VirtualMotion> virtual_motions;
    std::vector<TakenTogether> together;
    std::optional<Superposition> superposition;
};

/// Draws the forces of a loaded mechanism. `motion` gives the accelerations where the file includes inertia.
ForceResults draw_forces(Structure& structure, Board& board, const Motion& motion, const Mobility& mobility);

}  // namespace kinegraph
