// Compares the results with the numeric check, row by row, and reports differences. The two computations are
// independent; neither uses the other.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "engine/solution/findings.hpp"

namespace kinegraph {

struct NumericMotion;
struct Solution;

/// Values of the check for a solution.
struct Comparison {
    /// A row for each scalar that both the constructions and the check of motion and of forces determine, in SI units:
    /// ω and α by body, velocities and accelerations by point, slidings, finite instant centres, joint forces, the
    /// virtual power, the input forces and couples. There is no row for a value that only one of the two determines.
    std::vector<CheckRow> rows;
    /// By Protocol::vectors, as Solution::numeric_moduli.
    std::vector<std::optional<double>> moduli;
    /// By free body and its forces, as AppliedForce::numeric_force and numeric_couple.
    struct Action {
        std::optional<double> force, couple;
    };
    std::vector<std::vector<Action>> actions;
    /// Bars of a truss, by Truss::bars: N, tension positive.
    std::vector<std::pair<std::size_t, double>> bars;
    /// By BodyIndex: whether the check finds the motion determined, and not zero.
    struct Moved {
        bool determined = false, moves = false;
    };
    std::vector<Moved> bodies;
};
/// The solution's protocol must be finished.
Comparison compare_with_check(const Solution& solution);

/// Stores the values of the check in the solution.
void enter(Comparison comparison, Solution& solution);

/// Differences of more than 1e-6 of the largest value of the kind, the worst of each kind; and bodies that move by only
/// one of the two computations.
std::vector<Message> disagreements(const Solution& solution, const std::vector<Comparison::Moved>& bodies);

/// Adds the rows, bars and actions of forces to the comparison; `motion` is that of the check.
void compare_forces(const Solution& solution, const NumericMotion& motion, Comparison& comparison);

}  // namespace kinegraph
