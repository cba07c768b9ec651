// Noise: what is zero within the precision of the data, or but for what the compass left over, is zero in everything
// that is told and drawn of a solution and of its equations. The record keeps its numbers. Decides by
// engine/mechanism/rounding.hpp and by a finer pose, as the board's predicates do; knows no mechanics.
#pragma once

#include "engine/equations/equations.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Sets results that are zero within the data to zero, component by component, and marks drawn vectors that vanish.
/// Nothing where the data are exact. `finer`: the pose with twice its bits, asked for only where a result is
/// suspiciously small.
void forget_noise(Solution& solution, const FinerPose& finer);
/// The same of the values of its equations.
void forget_noise(Equations& equations, const Solution& solution, const FinerPose& finer);

}  // namespace kinegraph
