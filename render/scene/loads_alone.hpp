// Loads alone: a solution by superposition as it is while only the loads of one body act, so that every figure of
// forces shows these as it shows all. Computes nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "engine/solution/solution.hpp"

namespace kinegraph::render {

/// The same mechanism with the bodies cut free under the loads of `part` of its superposition alone.
Solution under_loads_alone(const Solution& solution, std::size_t part);
/// The part of the superposition that a sentence is about; nothing: it is about all loads.
std::optional<std::size_t> part_of(const Solution& solution, StatementIndex statement);
/// Of the body or the pin whose loads act: "3", "K".
const std::string& name_of(const Mechanism& mechanism, const Superposition::Part& part);
/// Bodies balanced as one: "3 + 4", or the first and the last of more than four.
std::string names_of(const Mechanism& mechanism, const TakenTogether& together);

}  // namespace kinegraph::render
