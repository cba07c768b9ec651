// Virtual displacements: chooses the coordinates, draws the mechanism displaced along each, and finds the input forces
// and couples for which the works vanish.
#pragma once

#include "engine/solution/displacements.hpp"

namespace kinegraph {

/// Uses the drivers of a solved mechanism if these determine its motion, else coordinates chosen in the file's order
/// (turns about hinges of the frame, slides on the frame, other turns, other slides, points). Adds the rows that
/// compare input forces with the check of forces, and remarks if displacements differ from the check of motion.
/// `finer`: its pose with twice the bits, if it is not drawn from the file.
void add_displacements(Solution& solution, const FinerPose& finer = {});

}  // namespace kinegraph
