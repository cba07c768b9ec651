// The kinematic chain of bodies and pairs: the pairs of each body, loops, whether it is open or closed. Topology only.
#pragma once

#include <vector>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// A hinge of n bodies counts once at each of them, and as n − 1 pairs between them. Clamped bodies count as the
/// separate bodies of the file, clamps as pairs.
struct KinematicChain {
    std::vector<int>
        pairs;  ///< by BodyIndex: at how many joints the body takes part; 1 unary (an end), 2 binary, 3 ternary …
    int joints = 0;  ///< binary ones: a hinge of n bodies is n − 1
    int parts = 0;   ///< connected components; 1: one chain
    int loops = 0;   ///< independent ones: joints − bodies + parts
    enum class Kind {
        open,    ///< no loop
        closed,  ///< loops, and each body has two pairs at least
        mixed    ///< loops, and also bodies with a single pair
    };
    Kind kind() const;
};
KinematicChain chain_of(const Mechanism& mechanism);

}  // namespace kinegraph
