// Drawn by: which statement of the solution draws a velocity or a force, wherever it is shown. Computes no mechanics.
#pragma once

#include <string>

#include "engine/solution.hpp"
#include "render/scene/force_statements.hpp"

namespace kinegraph::render {

/// The statement that draws the velocity of a point, by its label ("A", "A*"); −1: it is given, or no polygon has it.
int statement_of_velocity(const Protocol& protocol, const std::string& label);
/// The statement after which a force or couple on a free body is known; −1: it is given.
int statement_of_force(const Solution& solution, const ForceStatements& statements, const Symbol& symbol);

}  // namespace kinegraph::render
