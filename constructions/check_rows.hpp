// The results held against the numeric check, row by row. Neither learns from the other: here they are only set side by side.
#pragma once

#include <optional>
#include <vector>

#include "engine/solution.hpp"

namespace kinegraph {

/// What the check says beside a solution.
struct Comparison {
    /// A row for each scalar that both the constructions (in the solution) and the check of motion and of forces determine, SI
    /// units: ω and α by body, velocities and accelerations by point, slidings, finite instant centres, joint forces, the virtual
    /// power, the efforts. What one of the two leaves open has no row.
    std::vector<CheckRow> rows;
    /// By Protocol::vectors, as Solution::numeric_moduli.
    std::vector<std::optional<double>> moduli;
};
/// The solution's protocol is finished.
Comparison compare_with_check(const Solution& solution);

}  // namespace kinegraph
