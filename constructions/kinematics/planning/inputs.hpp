// What steps of a plan draw from and what they give: which of them lead to what is wanted.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "constructions/kinematics/plan.hpp"

namespace kinegraph::planning {

/// What a step draws from, or draws: tips of nodes and angular velocities of bodies.
struct Quantities {
    std::set<NodeIndex> tips;
    std::set<BodyIndex> spins;
};

void add_inputs(const Closing& closing, Quantities& inputs);
/// Of the steps from `first` on those that lead to what is wanted, in their order.
std::vector<Step> leading_to(Quantities wanted, const std::vector<Step>& steps, std::size_t first);

}  // namespace kinegraph::planning
