// The laws of statics for a solved mechanism under loads: agreement with the numeric equilibrium, equilibrium of every
// body and pin, joined polygons, action equals reaction, power balance.
#pragma once

#include "engine/check/check_forces.hpp"

namespace kinegraph {

struct Solution;

/// True if equilibrium determines every reaction and every input force or couple.
bool wholly_known(const NumericForces& forces);

/// Fails the running test if a law is violated or a force is missing.
void expect_laws_of_forces(const Solution& solution, const NumericForces& numeric);

/// For a mechanism that is not wholly determined: no force is given that equilibrium does not determine, and the others
/// are right.
void expect_determined_forces_only(const Solution& solution, const NumericForces& numeric);

/// Forces and moments of every free body vanish, exactly.
void expect_equilibrium_of_bodies(const Solution& solution);

}  // namespace kinegraph
