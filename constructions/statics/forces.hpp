// Forces: graphical statics and kinetostatics of the whole mechanism. Finds lines of action before magnitudes, body by
// body: two-force bodies, three concurrent forces, Culmann's line for four, a couple as force times arm. Bodies that
// slide in one another may be taken together. Several loads are superposed. If no order of bodies leads to the end, one
// force after the other is found by moments or by virtual work; of large structures, by elimination.
//
// A Bond is the interaction of two bodies at a joint or through an input force or couple. It is a force through a point
// (hinge, rolling), a force normal to a guide at an unknown place (sleeve), a force along a line (slot, contact, gear,
// actuator, force), a couple, or all three (weld). Sources: Culmann, Die graphische Statik (1866); Cremona (1872);
// Ritter's method of moments (1863).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/motion/mobility.hpp"
#include "engine/solution/findings.hpp"
#include "engine/solution/forces.hpp"

namespace kinegraph {

struct ForceResults {
    std::vector<JointForce> joints;
    std::vector<EffortValue> efforts;
    std::vector<FreeBody> bodies;  ///< in the order in which they were solved
    std::vector<Unsolved> unsolved;
    std::vector<Message> remarks;
    std::vector<Resultant> resultants;  ///< of unsupported bodies
    std::optional<Truss> truss;         ///< if the mechanism is one; its bars are then not drawn as free bodies
    std::vector<kinegraph::VirtualMotion> virtual_motions;
    std::vector<kinegraph::TakenTogether> together;
    std::optional<Superposition> superposition;
};

/// Draws the forces of a loaded mechanism. `motion` gives the accelerations if the file includes inertia.
ForceResults draw_forces(Structure& structure, Board& board, const Motion& motion, const Mobility& mobility);

}  // namespace kinegraph
