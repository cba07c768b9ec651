// The results file (docs/results.md) and its parts.
#pragma once

#include <functional>
#include <string>

#include "engine/file/json_writer.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

struct Displacements;
struct Equations;
struct Mechanism;
struct ProblemSolution;
struct Solution;

/// Renders a message in English.
using Teller = std::function<std::string(const Message&)>;

/// The results file of docs/results.md (SI, one line a value group); `exact` adds fractions.
std::string results_json(const Solution& solution, bool exact, const Teller& tell);
/// The value of "virtual work".
void write_displacements(const Mechanism& mechanism, const Displacements& displacements, JsonWriter& json);
/// The value of "equations".
void write_equations(const Equations& equations, JsonWriter& json);
/// All values of a problem that have a name in the file, as members of an object.
void write_values(const ProblemSolution& found, JsonWriter& json);

}  // namespace kinegraph
