// Moving: the programs of a mechanism's stretches, planned where they are needed, and its positions, for whoever
// replays them.
#pragma once

#include "constructions/moving/moving_parameters.hpp"
#include "engine/solution/moving.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Of a solution in its drawn position, for each of its drivers. Nothing where nothing moves it: no driver, no joints,
/// or a mechanism whose motion is not determined. A plan is made where none of those before holds, `most_plans` at
/// most; beyond that a position has none. `rereading`: of the file that was solved as it is drawn; without it no
/// parameter can be changed.
std::optional<Moving> moving_of(const Solution& solution, const Rereading& rereading = {});

}  // namespace kinegraph
