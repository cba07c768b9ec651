// Plans a mechanism piece by piece along the travel of its drivers, and records the programs for replay.
#pragma once

#include "constructions/moving/moving_parameters.hpp"
#include "engine/solution/moving.hpp"

namespace kinegraph {

struct Solution;

/// Limits of what a live page moves: beyond them every driver's travel would take minutes to plan.
constexpr std::size_t most_moved_bodies = 40, most_moved_drivers = 12;
bool is_beyond_moving(const Mechanism& mechanism);

/// From a solution in its drawn position, for each of its drivers. None if nothing moves it: no driver, no joints,
/// motion not determined, one position of a cam, or more than the limits. A new plan is made where no earlier one is
/// valid, up to `most_plans`; positions beyond that have no plan. Without `rereading`, which reads the file of the
/// solution again, no parameter can be changed.
std::optional<Moving> moving_of(const Solution& solution, const Rereading& rereading = {});
/// Of what no driver of the file moves: a structure in its only position, with loads that can be changed and turned; an
/// instantaneous motion with its velocities; a mechanism of which virtual displacements are sought, along its
/// coordinates. None else.
std::optional<Moving> standing_of(const Solution& solution);

struct Solution;

/// Binds marks of figures to the elements that place them, by the names of engine/solution/bindings.hpp.
/// Elements of forces (under all loads and under those of one body alone), of curvature and of powers. A quantity that
/// vanishes has no element.
std::vector<MovingPlan::Binding> bindings_of(const Solution& solution);

}  // namespace kinegraph
