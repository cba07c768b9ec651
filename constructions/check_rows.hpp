// The results held against the numeric check, row by row. Neither learns from the other: here they are only set side by side.
#pragma once

#include <vector>

#include "engine/solution.hpp"

namespace kinegraph {

/// A row for each scalar that both the constructions (in `solution`) and the check of motion and of forces determine, SI units:
/// ω and α by body, velocities and accelerations by point, slidings, finite instant centres, joint forces, the virtual power, the
/// efforts. What one of the two leaves open has no row.
std::vector<CheckRow> check_rows(const Solution& solution);

}  // namespace kinegraph
