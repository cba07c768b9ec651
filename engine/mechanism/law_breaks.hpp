// Breaks of a law: where its speed or its acceleration jumps. Knows laws only.
#pragma once

#include <vector>

#include "engine/mechanism/law.hpp"

namespace kinegraph {

/// A jump of a law's first or second derivative: both as they are just before it and just after it. Of s there is none.
struct LawBreak {
    double at = 0;
    LawState before, after;
    bool of_speed = false;  ///< the first derivative jumps: the acceleration is infinite
};

/// In their order, of a law that begins again where it ends: so at 0 stands what is between its end and its beginning,
/// if anything is. A share of 1e-9 of the mean slope of the steepest piece (and of its square) is no jump.
std::vector<LawBreak> breaks_of_cycle(const Law& law);

}  // namespace kinegraph
