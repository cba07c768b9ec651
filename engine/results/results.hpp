// The results file (docs/results.md), and its parts that are also documents of their own.
#pragma once

#include <functional>
#include <string>

#include "engine/sentences/statement.hpp"

namespace kinegraph {

struct Displacements;
struct Equations;
struct Mechanism;
struct Solution;

/// Renders a message in English.
using Teller = std::function<std::string(const Message&)>;

/// The results file of docs/results.md (SI, one line a value group); `exact` adds fractions.
std::string results_json(const Solution& solution, bool exact, const Teller& tell);
/// The value of "virtual work".
std::string displacements_json(const Mechanism& mechanism, const Displacements& displacements);
/// The value of "equations".
std::string equations_json(const Equations& equations);

}  // namespace kinegraph
