// Asked values: results by name, as the engine finds them, for the sheets that tell them. Computes nothing.
#pragma once

#include <vector>

#include "constructions/positions/named_results.hpp"
#include "render/tables/answers.hpp"

namespace kinegraph::app {

/// Each with the unit in which a file of these units tells it.
std::vector<render::AskedValue> asked_values(const std::vector<NamedResult>& results, const Units& units);
/// What the file asks for by name, and whatever else there is by name; nothing where it asks for nothing.
std::vector<render::AskedValue> asked_values(const Solution& solution);

}  // namespace kinegraph::app
