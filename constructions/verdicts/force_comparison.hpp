// Compares the forces of a solution with those of the numeric check.
#pragma once

#include "constructions/verdicts/check_rows.hpp"
#include "engine/check/check.hpp"

namespace kinegraph {

/// Adds the rows, bars and actions to the comparison; `motion` is that of the check.
void compare_forces(const Solution& solution, const NumericMotion& motion, Comparison& comparison);

}  // namespace kinegraph
