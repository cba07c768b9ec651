// Drawn by: which statement of the solution draws a velocity, an acceleration or a force, wherever it is shown.
// Computes no mechanics.
#pragma once

#include "engine/solution/solution.hpp"

namespace kinegraph::render {

/// The statement that draws the velocity or acceleration (`kind`) of a point as a body carries it, or another that is
/// pinned to it there; none: it is given, or no polygon has it.
StatementIndex statement_of_motion(const Solution& solution, Quantity::Kind kind, BodyIndex body, PointIndex point);
/// The statement after which a force or couple on a free body is known; none: it is given.
StatementIndex statement_of_force(const Solution& solution, const Quantity& force);

}  // namespace kinegraph::render
