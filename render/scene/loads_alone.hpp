// Superposition: a copy of the solution with the loads of one body only, so that the figures of forces apply to it
// unchanged. Computes nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "engine/solution/solution.hpp"

namespace kinegraph::render {

/// The mechanism with its free bodies under the loads of `part` of its superposition only.
Solution under_loads_alone(const Solution& solution, std::size_t part);
/// The part of the superposition that a statement belongs to. Empty: it refers to all loads.
std::optional<std::size_t> part_of(const Solution& solution, StatementIndex statement);
/// Name of the body or the pin whose loads act: "3", "K".
const std::string& name_of(const Mechanism& mechanism, const Superposition::Part& part);
/// Bodies that are balanced together: "3 + 4"; of more than four only the first and the last.
std::string names_of(const Mechanism& mechanism, const TakenTogether& together);

}  // namespace kinegraph::render
