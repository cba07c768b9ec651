// Virtual displacements: which coordinates are displaced, the mechanism drawn displaced along each, and the efforts
// that make the works vanish.
#pragma once

#include "engine/solution/displacements.hpp"

namespace kinegraph {

/// Finds them for a solved mechanism: along its own drivers where these move it wholly, else along coordinates chosen
/// in the file's order (turns about hinges of the frame, slides on the frame, other turns, other slides, points). Adds
/// the rows that hold efforts against the check of forces, and the remarks on displacements that differ from the check
/// of motion. `finer`: its pose with twice the bits, where that is not drawn from the file.
void add_displacements(Solution& solution, const FinerPose& finer = {});

}  // namespace kinegraph
