// The requested values: named results with their units, for the sheets that show them.
#pragma once

#include <vector>

#include "constructions/positions/named_results.hpp"
#include "render/tables/answers.hpp"

namespace kinegraph::app {

/// Each in the unit that a file with these units uses for it.
std::vector<render::RequestedResult> requested_results(const std::vector<NamedResult>& results, const Units& units);
/// The results in the file's "ask", then all other named results; empty if the file has no "ask".
std::vector<render::RequestedResult> requested_results(const Solution& solution);

}  // namespace kinegraph::app
