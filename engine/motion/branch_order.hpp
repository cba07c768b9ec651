// Order of the branches of a change point. It depends on the motion alone: neither on how the file is turned, moved or
// scaled, nor on the order of its points, bodies and joints.
#pragma once

#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// The instantaneous motion of a body: v of its place at the drawing's first point, over pose.size, and ω.
struct OriginVelocity {
    Vector v;
    Exact omega;
};

/// What a branch is ordered by.
struct BranchRank {
    /// Sum of the squares of the velocities of the joints' points and of ω times the size of the mechanism, over the
    /// square of the first driver's rate; infinite where that driver rests. Without drivers 1.
    double motion = 1;
    /// Products of two angular velocities, bodies by name, then of two velocities (dot), joints by name, as shares of
    /// the motion: the same in a mirrored file. Then their cross products, which a mirror reverses.
    std::vector<double> products;
};
/// `velocities` by BodyIndex, of any size.
BranchRank rank_of_branch(const Mechanism& mechanism, const Pose& pose, const std::vector<OriginVelocity>& velocities);

/// Whether the bodies move less on this branch; if they move alike, whether its first product that differs is greater.
bool comes_before(const BranchRank& rank, const BranchRank& other);

/// Whether a name stands before another: "9" before "10".
bool name_comes_before(const std::string& name, const std::string& other);

}  // namespace kinegraph
