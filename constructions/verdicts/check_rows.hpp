// The results held against the numeric check, row by row. Neither learns from the other: here they are only set side by
// side, and where they differ that is said.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "engine/solution/solution.hpp"

namespace kinegraph {

/// What the check says beside a solution.
struct Comparison {
    /// A row for each scalar that both the constructions (in the solution) and the check of motion and of forces
    /// determine, SI units: ω and α by body, velocities and accelerations by point, slidings, finite instant centres,
    /// joint forces, the virtual power, the efforts. What one of the two leaves open has no row.
    std::vector<CheckRow> rows;
    /// By Protocol::vectors, as Solution::numeric_moduli.
    std::vector<std::optional<double>> moduli;
    /// By free body and its forces, as AppliedForce::numeric_force and numeric_couple.
    struct Action {
        std::optional<double> force, couple;
    };
    std::vector<std::vector<Action>> actions;
    /// Of bars of a truss, by Truss::bars: N, tension positive.
    std::vector<std::pair<std::size_t, double>> bars;
    /// By BodyIndex: whether the check finds its motion determined, and not at rest.
    struct Moved {
        bool determined = false, moves = false;
    };
    std::vector<Moved> bodies;
};
/// The solution's protocol is finished.
Comparison compare_with_check(const Solution& solution);

/// Enters the numbers of the check in the solution.
void enter(Comparison comparison, Solution& solution);

/// Where the solution and the numbers of the check entered in it differ by more than 1e-6 of the largest of their kind,
/// the worst of each kind; and bodies that move by the one and by the other cannot be said to.
std::vector<Message> disagreements(const Solution& solution, const std::vector<Comparison::Moved>& bodies);

}  // namespace kinegraph
