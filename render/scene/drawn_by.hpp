// Which statement of the solution draws a velocity, an acceleration or a force. Computes no mechanics.
#pragma once

#include "engine/sentences/quantity.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

/// The statement that draws the velocity or acceleration (`kind`) of a point of a body, or of another point pinned to
/// it there. none: it is given, or no polygon contains it.
StatementIndex statement_of_motion(const Solution& solution, Quantity::Kind kind, BodyIndex body, PointIndex point);
/// The statement that determines a force or couple on a free body. none: it is given.
StatementIndex statement_of_force(const Solution& solution, const Quantity& force);

}  // namespace kinegraph::render
