#include "engine/motion/place_rules.hpp"

#include <cmath>

#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"

namespace kinegraph::closing {
namespace {

/// A point of a body, relative to the body's reference as drawn.
Spot local_place(const Pose& pose, const Closure& closure, BodyIndex body, PointIndex point) {
    return rough(closure.seen(pose.at(point)) - closure.bodies[at_index(body)].reference);
}
/// The current place of such a point.
Spot world(const BodyPlaces& bodies, BodyIndex body, const Spot& local) {
    const BodyPlaceOf<double>& at = bodies[at_index(body)];
    return at.at + faced(at.facing, local);
}

}  // namespace

PlaceRules::PlaceRules(const Mechanism& mechanism, const Pose& pose, const Closure& closure,
                       const std::vector<Carrier>& carriers)
    : unit_(closure.unit.to_double()), origin_(rough(closure.origin)), points_(carriers.size()) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
        points_[i].carrier = carriers[i];
        if (carriers[i].body != none) points_[i].local = local_place(pose, closure, carriers[i].body, PointIndex(i));
    }
    for (const JointIndex joint : indices_of(mechanism.joints)) add_joint(mechanism, pose, closure, joint);
}

void PlaceRules::add_joint(const Mechanism& mechanism, const Pose& pose, const Closure& closure, JointIndex index) {
    const Joint& joint = mechanism.joint(index);
    const PlanePair& pair = joint.pair();
    JointRule& rule = joints_.emplace_back();
    if (pair.has_common_point()) return;
    rule.bodies = {joint.bodies[0], joint.bodies[1]};
    rule.point = joint.point;
    rule.guide = rough(pose.guides[at_index(index)]);
    rule.tangent = rough(pose.tangents[at_index(index)]);
    rule.normal = rough(pose.normals[at_index(index)]);
    rule.touches = pair.touches();
    rule.meshes = pair.meshes();
    rule.is_arc = joint.arc != none;
    rule.locals = {local_place(pose, closure, joint.bodies[0], joint.point),
                   local_place(pose, closure, joint.bodies[1], rule.is_arc ? joint.arc : joint.point)};
    if (pair.has_guide() && !rule.is_arc) rule.turns_with = joint.bodies[1];
    if (!pair.touches()) return;
    rule.pressure = rough(unit_along(direction_of(joint.pressure_angle.value_or(Angle{}), pose.bits), pose.bits));
    const auto sides = sides_of(mechanism, pose, joint);
    KG_ASSERT(sides.has_value(), "a closure has the profiles of every contact");
    for (std::size_t side = 0; side < 2; ++side) {
        const ContactSide& of = (*sides)[side];
        rule.is_straight[side] = of.straight;
        rule.reaches[side] = of.reach.to_double() / unit_;
        if (of.straight) rule.turns_with = joint.bodies[side];
        if (of.centre == none) continue;
        rule.locals[side] = local_place(pose, closure, joint.bodies[side], of.centre);
        if (rule.first_circle < 0) rule.first_circle = static_cast<int>(side);
    }
}

/// The contact of two profiles: on the normal through the centre of one, or on the line of both centres.
Spot PlaceRules::contact_point(const BodyPlaces& bodies, const JointRule& rule) const {
    const std::array<Spot, 2> centres{world(bodies, rule.bodies[0], rule.locals[0]),
                                      world(bodies, rule.bodies[1], rule.locals[1])};
    for (std::size_t side = 0; side < 2; ++side) {
        if (!rule.is_straight[side]) continue;
        const Spot tangent = faced(bodies[at_index(rule.turns_with)].facing, rule.tangent);
        const double size = nearest::hypot(tangent.x, tangent.y);
        return centres[1 - side] - (rule.reaches[1 - side] / size) * quarter_turn(tangent);
    }
    const double apart = rule.reaches[0] - rule.reaches[1];
    return (rule.reaches[0] / apart) * centres[1] - (rule.reaches[1] / apart) * centres[0];
}

void PlaceRules::read(const BodyPlaces& bodies, Places& places) const {
    places.origin = origin_;
    places.points.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const PointRule& rule = points_[i];
        const Spot at = rule.carrier.body != none ? world(bodies, rule.carrier.body, rule.local)
                                                  : contact_point(bodies, joints_[at_index(rule.carrier.contact)]);
        places.points[i] = unit_ * at;
    }
    for (auto* list : {&places.guides, &places.normals, &places.tangents}) list->resize(joints_.size());
    for (std::size_t k = 0; k < joints_.size(); ++k) {
        const JointRule& rule = joints_[k];
        if (rule.point == none) continue;
        Spot &guide = places.guides[k], &normal = places.normals[k], &tangent = places.tangents[k];
        if (!rule.touches) {
            guide = rule.is_arc ? Spot{} : faced(bodies[at_index(rule.turns_with)].facing, rule.guide);
            normal = rule.is_arc ? unit_ * (world(bodies, rule.bodies[0], rule.locals[0]) -
                                            world(bodies, rule.bodies[1], rule.locals[1]))
                                 : quarter_turn(guide);
            continue;
        }
        if (rule.turns_with != none) {
            tangent = faced(bodies[at_index(rule.turns_with)].facing, rule.tangent);
            normal = quarter_turn(tangent);
        } else {
            const std::size_t side = rule.first_circle < 0 ? 0 : static_cast<std::size_t>(rule.first_circle);
            normal = unit_ * world(bodies, rule.bodies[side], rule.locals[side]) - places.points[at_index(rule.point)];
            tangent = -quarter_turn(normal);
        }
        if (rule.meshes) normal = faced(rule.pressure, tangent);
    }
}

double PlaceRules::slid(const BodyPlaces& bodies, JointIndex joint) const {
    const JointRule& rule = joints_[at_index(joint)];
    const Spot guide = faced(bodies[at_index(rule.turns_with)].facing, rule.guide);
    const Spot apart = world(bodies, rule.bodies[0], rule.locals[0]) - world(bodies, rule.bodies[1], rule.locals[1]);
    return unit_ * dot(guide, apart) / nearest::hypot(guide.x, guide.y);
}

}  // namespace kinegraph::closing
