// The laws that any plane motion obeys, asked of a solved mechanism: agreement with the numeric check, rigid bodies,
// slides on their guides, polygons that close, three centres on a line. Exactly, but for the check and for what a
// pose's leftover can explain.
#pragma once

#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Fails the running test where a law is broken. Asks only what was found: whether all was found is `motion_is_whole`.
void expect_laws_of_motion(const Solution& solution);

/// Nothing is left unsolved; then all the laws.
void expect_whole_motion(const Solution& solution);

}  // namespace kinegraph
