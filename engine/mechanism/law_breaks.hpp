// Breaks of a law: where its speed or its acceleration jumps.
#pragma once

#include <vector>

#include "engine/mechanism/law.hpp"

namespace kinegraph {

/// A jump of a law's first or second derivative: both derivatives just before and just after it. s itself is
/// continuous.
struct LawBreak {
    double at = 0;
    LawState before, after;
    bool of_speed = false;  ///< the first derivative jumps: the acceleration is infinite
};

/// In order, for a periodic law: the break at 0 is between its end and its beginning. A jump below 1e-9 of the mean
/// slope of the steepest piece (of its square, for the second derivative) is ignored.
std::vector<LawBreak> breaks_of_cycle(const Law& law);

}  // namespace kinegraph
