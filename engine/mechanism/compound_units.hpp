// Compound units: in which a file's forces per length and torsional stiffnesses are told, from its units of force,
// moment and length. Knows no text of a file.
#pragma once

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// kN/m, N/mm: the file's unit of force over that of length, where there is such a unit; else over the metre; else N/m.
Unit unit_of_force_per_length(const Units& units);
/// N mm/rad: the file's unit of moment for each radian, where there is such a unit; else N m/rad.
Unit unit_of_torsional_stiffness(const Units& units);

}  // namespace kinegraph
