// The seam between the program and kinegraph_algebra.so, the module that finds derivatives in symbols. GiNaC and CLN
// take eight milliseconds to load and to set up, twice as long as many a run takes; so the motion of a point alone
// loads them.
#pragma once

#include "engine/file/algebra.hpp"

namespace kinegraph::app {

/// What the module exports, under the name `kinegraph_algebra`. It throws nothing.
struct AlgebraFunctions {
    Algebra algebra;
};

}  // namespace kinegraph::app
