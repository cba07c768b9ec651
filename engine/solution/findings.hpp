// Findings: what the check says of the results, what has no result and why, remarks.
#pragma once

#include <optional>
#include <vector>

#include "engine/sentences/quantity.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// One scalar compared with the check.
struct CheckRow {
    Quantity quantity;  ///< of a vector: one component
    double graphical = 0, numeric = 0, difference = 0;
};
struct Unsolved {
    Message what;  ///< "velocity of body 3", "instant centre 2,5"
    Message why;
};

/// Of a whole solution.
struct Findings {
    std::vector<CheckRow> checks;
    /// By Protocol::vectors: the modulus of a velocity or an acceleration by the check, SI; none where undetermined by
    /// it.
    std::vector<std::optional<double>> numeric_moduli;
    std::vector<Unsolved> unsolved;  ///< not empty: exit 3
    std::vector<Message> remarks;    ///< redundant constraints, points moved onto curves …
};

}  // namespace kinegraph
