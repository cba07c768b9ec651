// The laws of statics, asked of a solved mechanism under loads: agreement with the numeric equilibrium, every body and
// pin closes in force and moment, the polygons side by side, action is reaction, no power is lost.
#pragma once

#include "engine/check/check_forces.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Equilibrium determines every reaction and effort.
bool wholly_known(const NumericForces& forces);

/// Fails the running test where a law is broken or a force is missing.
void expect_laws_of_forces(const Solution& solution, const NumericForces& numeric);

/// Of a mechanism that is not wholly determined: no force that equilibrium does not determine, and those given are
/// right.
void expect_determined_forces_only(const Solution& solution, const NumericForces& numeric);

}  // namespace kinegraph
