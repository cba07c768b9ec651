// The difference between a solution and the numeric check, each row relative to the largest magnitude of its kind.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/results/quantity_name.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph::tests {

using Kind = Quantity::Kind;

/// Quantities of one polygon that are compared with one magnitude: sliding quantities of all orders, forces and
/// couples.
inline Kind kind_of(const Quantity& quantity) {
    switch (quantity.kind) {
        case Kind::sliding_acceleration:
        case Kind::sliding_coriolis: return Kind::sliding_velocity;
        case Kind::couple:
        case Kind::force_component: return Kind::force;
        default: return quantity.kind;
    }
}

/// The magnitude of each kind: the largest value, or an estimate from related quantities if all values are zero.
inline std::map<Kind, double> magnitudes(const Solution& solution) {
    std::map<Kind, double> largest;
    double fastest = 0;
    for (const CheckRow& row : solution.checks) {
        double& of_kind = largest[kind_of(row.quantity)];
        of_kind = std::max({of_kind, std::abs(row.numeric), std::abs(row.graphical)});
        if (kind_of(row.quantity) == Kind::omega) fastest = std::max(fastest, std::abs(row.graphical));
    }
    // An angular velocity is compared with the one that gives the drawing's far end the speed of the fastest point.
    largest[Kind::omega] = std::max(largest[Kind::omega], largest[Kind::velocity] / solution.pose.size.to_double());
    // If nothing slides, a sliding velocity is compared with the motion of the bodies.
    largest[Kind::sliding_velocity] =
        std::max({largest[Kind::sliding_velocity], largest[Kind::velocity], largest[Kind::acceleration]});
    // A centre at the origin is compared with the size of the drawing.
    largest[Kind::centre] = std::max(largest[Kind::centre], solution.pose.size.to_double());
    // If all angular accelerations vanish, α is compared with ω².
    largest[Kind::alpha] = std::max(largest[Kind::alpha], fastest * fastest);
    // The sum of the powers is zero: it is compared with the single powers.
    if (solution.virtual_work) {
        for (const VirtualWork::Entry& entry : solution.virtual_work->entries)
            largest[Kind::virtual_power] = std::max(largest[Kind::virtual_power], std::abs(entry.power.to_double()));
    }
    return largest;
}

/// The worst difference from the check, relative to its kind's magnitude (absolute if that is zero). It is below 1e-9
/// for whole mechanisms: the check loses some six of the sixteen digits of a double in its systems of equations.
inline double worst_difference(const Solution& solution) {
    const std::map<Kind, double> largest = magnitudes(solution);
    double worst = 0;
    for (const CheckRow& row : solution.checks) {
        const auto of_kind = largest.find(kind_of(row.quantity));
        const double size = of_kind != largest.end() && of_kind->second > 0 ? of_kind->second : 1;
        EXPECT_NEAR(row.difference, row.graphical - row.numeric, 1e-15 * size) << name_of(row.quantity, solution);
        worst = std::max(worst, std::abs(row.difference) / size);
    }
    return worst;
}

}  // namespace kinegraph::tests
