// How near a solution lies to the numeric check: each row against what is large of its kind.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/results/quantity_name.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph::tests {

using Kind = Quantity::Kind;

/// What lies in one polygon and is small against one magnitude: slidings of all orders, forces with their couples.
inline Kind kind_of(const Quantity& quantity) {
    switch (quantity.kind) {
        case Kind::sliding_acceleration:
        case Kind::sliding_coriolis: return Kind::sliding_velocity;
        case Kind::couple:
        case Kind::force_component: return Kind::force;
        default: return quantity.kind;
    }
}

/// By kind, what a difference must be small against: the largest value met of it, and what it comes from where that is
/// nothing.
inline std::map<Kind, double> magnitudes(const Solution& solution) {
    std::map<Kind, double> largest;
    double fastest = 0;
    for (const CheckRow& row : solution.checks) {
        double& of_kind = largest[kind_of(row.quantity)];
        of_kind = std::max({of_kind, std::abs(row.numeric), std::abs(row.graphical)});
        if (kind_of(row.quantity) == Kind::omega) fastest = std::max(fastest, std::abs(row.graphical));
    }
    // A turn is small against the one that would move the drawing's far end as fast as its fastest point.
    largest[Kind::omega] = std::max(largest[Kind::omega], largest[Kind::velocity] / solution.pose.size.to_double());
    // Where nothing slides, the motion of the bodies is what a sliding is small against.
    largest[Kind::sliding_velocity] =
        std::max({largest[Kind::sliding_velocity], largest[Kind::velocity], largest[Kind::acceleration]});
    // A centre at the origin is small against the drawing.
    largest[Kind::centre] = std::max(largest[Kind::centre], solution.pose.size.to_double());
    // Where nothing turns faster and faster, ω² is what an α is small against.
    largest[Kind::alpha] = std::max(largest[Kind::alpha], fastest * fastest);
    // Powers add up to nothing: each alone is what their sum is small against.
    if (solution.virtual_work) {
        for (const VirtualWork::Entry& entry : solution.virtual_work->entries)
            largest[Kind::virtual_power] = std::max(largest[Kind::virtual_power], std::abs(entry.power.to_double()));
    }
    return largest;
}

/// The worst difference from the check, each over its kind's magnitude (1 where that is nothing). Whole mechanisms keep
/// it within 1e-9: the check counts in doubles, and loses some six of their sixteen digits in its systems of equations.
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
