// Cylinders: the driven slides between two moving bodies that are drawn as a piston in a barrel.
#include <algorithm>
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

/// Distances along a slide of the body's corners. Empty if one lies off the axis, or there is none.
std::vector<double> corners_on_axis(const Layout& layout, const Joint& slide, BodyIndex body) {
    const Spot at = layout.spot(slide), along = layout.guide(slide);
    std::vector<double> found;
    for (const PointIndex corner : layout.subject.corners[at_index(body)]) {
        const Spot d = layout.spot(corner) - at;
        if (std::abs(cross(along, d)) > 0.3) return {};
        found.push_back(dot(along, d));
    }
    return found;
}
double farthest(const std::vector<double>& corners) {
    double found = corners.front();
    for (const double corner : corners)
        if (std::abs(corner) > std::abs(found) + 1e-9) found = corner;
    return found;
}

std::optional<Cylinder> cylinder_at(const Layout& layout, const Joint& joint) {
    const JointIndex index = layout.mechanism.index_of(joint);
    if (!is_slide(joint) || joint.connects(frame) || !is_driven(layout.mechanism, index)) return std::nullopt;
    const std::vector<double> of_rod = corners_on_axis(layout, joint, joint.bodies[0]),
                              of_barrel = corners_on_axis(layout, joint, joint.bodies[1]);
    if (of_rod.empty() || of_barrel.empty()) return std::nullopt;
    const double rod = farthest(of_rod), barrel = farthest(of_barrel);
    const double shrink = layout.measures.shrink;
    const double sense = rod > barrel ? 1 : -1, whole = sense * (rod - barrel);
    if (whole < 10 * shrink) return std::nullopt;
    // The piston stands at the joint's point, if that lies well inside the barrel.
    const double wanted = -sense * barrel, at_an_end = std::min(5.0 * shrink, 0.25 * whole);
    const double piston = wanted > 0.25 * whole && wanted < 0.75 * whole ? wanted : 0.5 * whole;
    const double open_end = std::min(piston + 0.2 * whole, whole - at_an_end),
                 closed_end = std::min(at_an_end, piston - 2);
    // A barrel does not reach past its rod's end, as a guide may: its points are before the open end.
    const auto is_past = [&](double corner) { return sense * (corner - barrel) > open_end; };
    if (std::any_of(of_barrel.begin(), of_barrel.end(), is_past)) return std::nullopt;
    const Spot at = layout.spot(joint), along = layout.guide(joint);
    const Spot foot = at + barrel * along, onward = sense * along;
    return Cylinder{
        index, at + rod * along, foot + piston * onward, {foot + closed_end * onward, foot + open_end * onward}};
}

}  // namespace

std::vector<Cylinder> cylinders_in(const Layout& layout) {
    std::vector<Cylinder> found;
    for (const Joint& joint : layout.mechanism.joints)
        if (auto cylinder = cylinder_at(layout, joint)) found.push_back(*cylinder);
    return found;
}

}  // namespace kinegraph::render::drawing
