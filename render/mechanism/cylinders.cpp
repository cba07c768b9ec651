// Cylinders: the driven slides between two moving bodies that are drawn as a piston in a barrel.
#include <cmath>

#include "render/mechanism/layout.hpp"

namespace kinegraph::render::drawing {

namespace {

bool is_driven(const Mechanism& mechanism, JointIndex joint) {
    const auto moves = [&](const Driver& driver) {
        const auto* slide = std::get_if<SlideDriver>(&driver);
        return slide && slide->joint == joint;
    };
    const auto pushes = [&](const Effort& effort) {
        const auto* actuator = std::get_if<ActuatorEffort>(&effort);
        return actuator && actuator->joint == joint;
    };
    return std::any_of(mechanism.drivers.begin(), mechanism.drivers.end(), moves) ||
           std::any_of(mechanism.efforts.begin(), mechanism.efforts.end(), pushes);
}

/// Distance along a slide of the body's farthest corner. Empty if a corner lies off the axis, or there is none.
std::optional<double> farthest_on_axis(const Layout& layout, const Joint& slide, BodyIndex body) {
    const Spot at = layout.spot(slide), along = layout.guide(slide);
    std::optional<double> found;
    for (const PointIndex corner : layout.subject.corners[at_index(body)]) {
        const Spot d = layout.spot(corner) - at;
        if (std::abs(cross(along, d)) > 0.3) return std::nullopt;
        if (!found || std::abs(dot(along, d)) > std::abs(*found) + 1e-9) found = dot(along, d);
    }
    return found;
}

std::optional<Cylinder> cylinder_at(const Layout& layout, const Joint& joint) {
    const JointIndex index = layout.mechanism.index_of(joint);
    if (!is_slide(joint) || joint.connects(frame) || !is_driven(layout.mechanism, index)) return std::nullopt;
    const auto rod = farthest_on_axis(layout, joint, joint.bodies[0]),
               barrel = farthest_on_axis(layout, joint, joint.bodies[1]);
    if (!rod || !barrel) return std::nullopt;
    const double shrink = layout.measures.shrink;
    const double sense = *rod > *barrel ? 1 : -1, whole = sense * (*rod - *barrel);
    if (whole < 24 * shrink) return std::nullopt;
    // The piston stands at the joint's point, if that lies well inside the barrel.
    const double wanted = -sense * *barrel;
    const double piston = wanted > 0.25 * whole && wanted < 0.75 * whole ? wanted : 0.5 * whole;
    const double open_end = std::min(piston + 0.2 * whole, whole - 5 * shrink),
                 closed_end = std::min(5.0 * shrink, piston - 2);
    const Spot at = layout.spot(joint), along = layout.guide(joint);
    const Spot foot = at + *barrel * along, onward = sense * along;
    return Cylinder{
        index, at + *rod * along, foot + piston * onward, {foot + closed_end * onward, foot + open_end * onward}};
}

}  // namespace

std::vector<Cylinder> cylinders_in(const Layout& layout) {
    std::vector<Cylinder> found;
    for (const Joint& joint : layout.mechanism.joints)
        if (auto cylinder = cylinder_at(layout, joint)) found.push_back(*cylinder);
    return found;
}

}  // namespace kinegraph::render::drawing
