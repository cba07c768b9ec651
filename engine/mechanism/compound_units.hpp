// Compound units: the units of forces per length and of torsional stiffnesses, composed from the file's units of force,
// moment and length.
#pragma once

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// kN/m, N/mm: the file's unit of force over that of length, where that unit exists; else over the metre; else N/m.
Unit unit_of_force_per_length(const Units& units);
/// N mm/rad: the file's unit of moment per radian, where that unit exists; else N m/rad.
Unit unit_of_torsional_stiffness(const Units& units);

}  // namespace kinegraph
