// Loads whose size depends on the drawing: the force of an elastic spring, the resultant of a distributed load, the
// couple of a torsion spring. Exact except for lengths, which the compass gives.
#pragma once

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// N, along the line through the spring's points; positive in tension. Elastic: k (l − l_0).
Exact pull_of(const SpringLoad& spring, const Pose& pose);

/// The resultant of a distributed load of intensity q_0 at P and q_1 at Q, PQ of length l: the force (q_0 + q_1) l/2 at
/// the fraction (q_0 + 2 q_1)/(3 (q_0 + q_1)) of PQ. Where q_0 = −q_1 it is a couple: the forces q_0 l/2 at one third
/// and q_1 l/2 at two thirds of PQ.
struct Centroid {
    bool is_couple = false;
    Exact place;  ///< fraction of PQ; for a couple the arm as a fraction of PQ
};
Centroid centroid_of(const DistributedLoad& load);
/// N, along the load's direction; for a couple the force at two thirds.
Exact force_of(const DistributedLoad& load, const Pose& pose);

/// N m on the first body, counter-clockwise positive.
inline Exact couple_of(const TorsionLoad& torsion) { return -torsion.stiffness * torsion.turned; }

}  // namespace kinegraph
