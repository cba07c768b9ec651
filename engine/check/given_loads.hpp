// The given loads on the bodies, for the check of the forces: the file's loads, springs by their length in the pose,
// distributed loads by Simpson's rule, weights, and −m a_G and −J_G α where the file requests inertia. Without the
// reactions of joints.
#pragma once

#include <vector>

#include "engine/check/check.hpp"
#include "engine/check/plane_pair.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph::numeric {

class GivenLoads {
public:
    /// A force at a place of a body or on the pin of a hinge, or a couple.
    struct Given {
        BodyIndex body = frame;  ///< `frame` for a load on a pin
        Pair force{};            ///< N
        Vector place;            ///< m
        double couple = 0;       ///< N m
        JointIndex pin = none;
    };

    /// `motion`: of the same mechanism, for the inertia.
    GivenLoads(const Mechanism& mechanism, const Pose& pose, const NumericMotion& motion);

    const std::vector<Given>& all() const { return given_; }
    /// The largest force, including couples divided by the drawing's size, N; 1 where nothing acts.
    double unit() const { return unit_; }
    /// Whether the body has inertia but its acceleration is unknown.
    bool lacks_inertia(BodyIndex body) const { return lacks_inertia_[at_index(body)]; }

private:
    void take(const ForceLoad& load);
    void take(const CoupleLoad& load);
    void take(const SpringLoad& load);
    void take(const DistributedLoad& load);
    void take(const TorsionLoad& load);
    void take(const Mass& mass, const Mechanism& mechanism, const NumericMotion& motion);

    const Pose& pose_;
    std::vector<Given> given_;
    double unit_ = 0;
    std::vector<bool> lacks_inertia_;  ///< by body
};

}  // namespace kinegraph::numeric
