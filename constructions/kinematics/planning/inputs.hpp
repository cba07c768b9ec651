// The data flow of plan steps: which steps are needed for a given result.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "constructions/kinematics/plan.hpp"

namespace kinegraph::planning {

/// Inputs or outputs of a step: tips of nodes and angular velocities of bodies.
struct Quantities {
    std::set<NodeIndex> tips;
    std::set<BodyIndex> spins;
};

void add_inputs(const Closing& closing, Quantities& inputs);
/// The steps from `first` on that `wanted` depends on, in their order.
std::vector<Step> leading_to(Quantities wanted, const std::vector<Step>& steps, std::size_t first);

}  // namespace kinegraph::planning
