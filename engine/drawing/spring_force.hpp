// Loads whose size hangs on the drawing: the pull of an elastic spring, the resultant of a distributed load, the couple
// of a torsion spring. Exact but for the lengths, which the compass gives. Knows no board.
#pragma once

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// N, along the join of the spring's points; positive where it pulls them together. Elastic: k (l − l_0).
Exact pull_of(const SpringLoad& spring, const Pose& pose);

/// A distributed load of intensity q_0 at P and q_1 at Q, PQ of the length l, is the force (q_0 + q_1) l/2 at
/// (q_0 + 2 q_1)/(3 (q_0 + q_1)) of PQ, or where q_0 = −q_1 a couple: the forces q_0 l/2 at a third and q_1 l/2 at two
/// thirds of PQ.
struct Centroid {
    bool is_couple = false;
    Exact place;  ///< share of PQ; of a couple the arm as a share of PQ
};
Centroid centroid_of(const DistributedLoad& load);
/// N, along the load's direction; of a couple the force at two thirds.
Exact force_of(const DistributedLoad& load, const Pose& pose);

/// N m on the first body, counter-clockwise positive.
inline Exact couple_of(const TorsionLoad& torsion) { return -torsion.stiffness * torsion.turned; }

}  // namespace kinegraph
