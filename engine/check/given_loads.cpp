#include "engine/check/given_loads.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "engine/number/functions.hpp"

namespace kinegraph::numeric {

GivenLoads::GivenLoads(const Mechanism& mechanism, const Pose& pose, const NumericMotion& motion)
    : pose_(pose), lacks_inertia_(mechanism.bodies.size(), false) {
    for (const Load& load : mechanism.loads) {
        std::visit([&](const auto& form) { take(form); }, load);
    }
    for (const Mass& mass : mechanism.masses) {
        if (mass.body != frame) take(mass, mechanism, motion);
    }
    const double size = pose.size.to_double();
    for (const Given& each : given_) {
        unit_ = std::max({unit_, nearest::hypot(each.force[0], each.force[1]), std::abs(each.couple) / size});
    }
    if (unit_ == 0) unit_ = 1;
}

void GivenLoads::take(const ForceLoad& load) {
    const Pair force =
        load.value ? rough(*load.value)
                   : load.magnitude->first.to_double() * unit_along(direction_of(load.magnitude->second, pose_), pose_);
    given_.push_back({load.pin == none ? load.body : frame, force, pose_.at(load.at), 0, load.pin});
}

void GivenLoads::take(const CoupleLoad& load) { given_.push_back({load.body, {}, {}, load.value.to_double()}); }

void GivenLoads::take(const SpringLoad& load) {
    const Vector& p = pose_.at(load.between[0]);
    const Vector& q = pose_.at(load.between[1]);
    if (p == q) return;  // the direction of the pull is undefined
    const Pair apart = rough(q - p);
    const double stretch = nearest::hypot(apart[0], apart[1]);
    const double size = load.elastic
                            ? load.elastic->stiffness.to_double() * (stretch - load.elastic->free_length.to_double())
                            : load.magnitude.to_double();
    const Pair pull = size * unit_along(q - p, pose_);
    given_.push_back({load.bodies[0], pull, p, 0});
    given_.push_back({load.bodies[1], -1 * pull, q, 0});
}

/// Simpson's rule, exact for the moments of a linear intensity; needs no centroid.
void GivenLoads::take(const DistributedLoad& load) {
    const Vector &p = pose_.at(load.from), &q = pose_.at(load.to);
    const Pair along = unit_along(direction_of(load.along, pose_), pose_);
    const Pair apart = rough(q - p);
    const double sixth = nearest::hypot(apart[0], apart[1]) / 6;
    const double first = load.intensity[0].to_double(), last = load.intensity[1].to_double();
    given_.push_back({load.body, sixth * first * along, p, 0});
    given_.push_back({load.body, 2 * sixth * (first + last) * along, Exact::ratio(1, 2) * (p + q), 0});
    given_.push_back({load.body, sixth * last * along, q, 0});
}

void GivenLoads::take(const TorsionLoad& load) {
    const double couple = -load.stiffness.to_double() * load.turned.to_double();
    given_.push_back({load.bodies[0], {}, {}, couple});
    given_.push_back({load.bodies[1], {}, {}, -couple});
}

/// Weight and inertia.
void GivenLoads::take(const Mass& mass, const Mechanism& mechanism, const NumericMotion& motion) {
    const Vector& centre = pose_.at(mass.centre);
    const double m = mass.mass.to_double();
    if (mechanism.gravity) given_.push_back({mass.body, m * rough(*mechanism.gravity), centre, 0});
    if (!mechanism.inertia_forces) return;
    const auto& state = motion.bodies[at_index(mass.body)];
    if (!state.acceleration_known) {
        lacks_inertia_[at_index(mass.body)] = m > 0 || !mass.inertia.is_zero();
        return;
    }
    given_.push_back(
        {mass.body, -m * motion.acceleration(mass.body, centre), centre, -mass.inertia.to_double() * state.alpha});
}

}  // namespace kinegraph::numeric
