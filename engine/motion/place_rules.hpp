// How places of points and directions of joints follow from the positions of the bodies, in doubles. Independent of the
// equations: it works for any positions of the bodies.
#pragma once

#include <array>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/closure.hpp"

namespace kinegraph {

/// The part of a position from which a program's givens follow, in doubles and m.
struct Places {
    using Spot = VectorOf<double>;
    Spot origin;                                  ///< of the closure
    std::vector<Spot> points;                     ///< by PointIndex, from `origin`
    std::vector<Spot> guides, normals, tangents;  ///< by JointIndex, as in Pose
};

namespace closing {

using Spot = VectorOf<double>;
/// By BodyIndex, places in the closure's unit.
using BodyPlaces = std::vector<BodyPlaceOf<double>>;

/// The nearest doubles.
inline Spot rough(const Vector& a) { return {a.x.to_double(), a.y.to_double()}; }

/// Lengths in the closure's unit.
struct PointRule {
    Carrier carrier;
    Spot local;  ///< from the carrier's reference
};
struct JointRule {
    BodyIndex turns_with;  ///< the body of the guide or of the straight profile; none if there is neither
    std::array<BodyIndex, 2> bodies;
    Spot guide, tangent, normal;      ///< as drawn
    std::array<Spot, 2> locals;       ///< guide: P on both; arc: P and C; profiles: their centres
    std::array<double, 2> reaches{};  ///< profiles: of the centres along the drawn normal
    std::array<bool, 2> is_straight{};
    int first_circle = -1;  ///< profiles: the side whose centre gives the normal where none is straight
    PointIndex point;
    bool is_arc = false, touches = false, meshes = false;
    Spot pressure{1, 0};
};

class PlaceRules {
public:
    PlaceRules() = default;
    /// `carriers`: by point, of the mechanism. `closure`: of the pose.
    PlaceRules(const Mechanism& mechanism, const Pose& pose, const Closure& closure,
               const std::vector<Carrier>& carriers);

    const std::vector<PointRule>& points() const { return points_; }  ///< by PointIndex
    const std::vector<JointRule>& joints() const { return joints_; }  ///< by JointIndex
    void read(const BodyPlaces& bodies, Places& places) const;
    /// Displacement along X of body i of a straight slide relative to j, since the drawn pose, m.
    double slid(const BodyPlaces& bodies, JointIndex joint) const;

private:
    void add_joint(const Mechanism& mechanism, const Pose& pose, const Closure& closure, JointIndex index);
    Spot contact_point(const BodyPlaces& bodies, const JointRule& rule) const;

    double unit_ = 1;  ///< of the closure, m
    Spot origin_;      ///< likewise
    std::vector<PointRule> points_;
    std::vector<JointRule> joints_;
};

}  // namespace closing
}  // namespace kinegraph
