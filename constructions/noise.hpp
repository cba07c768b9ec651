// Noise: what is zero within the precision of the data is zero in everything that is told and drawn of a solution. The record
// keeps its numbers. Decides by engine/rounding.hpp alone; knows no mechanics.
#pragma once

#include "engine/solution.hpp"

namespace kinegraph {

/// Sets results that are zero within the data to zero, component by component, and marks drawn vectors that vanish. Nothing where
/// the data are exact.
void forget_noise(Solution& solution);

}  // namespace kinegraph
