// Subject of a drawing: shown points, the corners of each body, and the overall size.
#include "render/mechanism/subject.hpp"

namespace kinegraph::render::drawing {

namespace {

std::vector<Spot> units(const std::vector<Vector>& from, std::size_t count) {
    std::vector<Spot> to(count);
    for (std::size_t i = 0; i < std::min(count, from.size()); ++i)
        if (!from[i].is_zero()) to[i] = paper_direction(from[i]);
    return to;
}

/// Whether a stroke of the body leads to the joint: a pin, the moving part of a slide, or a tip.
bool holds(const Joint& joint, BodyIndex body) {
    return joint.pair().has_common_point() || (joint.pair().has_guide() && joint.bodies.front() == body) ||
           is_tip(joint, body);
}

bool is_within(const Box& box, Spot spot) {
    return spot.x >= box.min.x && spot.x <= box.max.x && spot.y >= box.min.y && spot.y <= box.max.y;
}

}  // namespace

Subject::Subject(const Solution& s)
    : solution(s),
      mechanism(s.mechanism),
      guides(units(s.pose.guides, mechanism.joints.size())),
      normals(units(s.pose.normals, mechanism.joints.size())),
      shown(s.pose.points.size(), false),
      mass_centre(s.pose.points.size(), false),
      corners(mechanism.bodies.size()) {
    for (const Vector& point : s.pose.points) points.push_back(paper_spot(point));
    show_points();
    join_corners();
    measure();
}

void Subject::show_points() {
    for (const Mass& mass : mechanism.masses)
        if (mass.centre != none) mass_centre[at_index(mass.centre)] = shown[at_index(mass.centre)] = true;
    for (const Load& load : mechanism.loads) {
        if (const auto* spring = std::get_if<SpringLoad>(&load))
            for (const PointIndex end : spring->between) shown[at_index(end)] = true;
        if (const auto* distributed = std::get_if<DistributedLoad>(&load))
            for (const PointIndex end : {distributed->from, distributed->to}) shown[at_index(end)] = true;
    }
    for (const Body& body : mechanism.bodies)
        for (const PointIndex point : body.points) shown[at_index(point)] = true;
    for (const Joint& joint : mechanism.joints)
        if (joint.point != none) shown[at_index(joint.point)] = true;
}

void Subject::add_corner(BodyIndex body, PointIndex point) {
    std::vector<PointIndex>& list = corners[at_index(body)];
    if (std::find(list.begin(), list.end(), point) == list.end()) list.push_back(point);
}

void Subject::join_corners() {
    for (const BodyIndex body : indices_of(mechanism.bodies))
        for (const PointIndex point : mechanism.body(body).points)
            if (!touches_there(body, point)) add_corner(body, point);
    for (const Joint& joint : mechanism.joints)
        for (const BodyIndex body : joint.bodies)
            if (joint.point != none && holds(joint, body)) add_corner(body, joint.point);
}

void Subject::measure() {
    const auto apart = [&](PointIndex p, PointIndex q) { return length(points[at_index(p)] - points[at_index(q)]); };
    for (std::size_t body = 1; body < corners.size(); ++body) {
        double reach = 0;
        for (const PointIndex p : corners[body])
            for (const PointIndex q : corners[body]) reach = std::max(reach, apart(p, q));
        if (reach > 0) shortest = std::min(shortest, reach);
    }
    for (const Joint& a : mechanism.joints)
        for (const Joint& b : mechanism.joints)
            if (is_fixed_pin(a) && is_fixed_pin(b) && apart(a.point, b.point) > 0)
                shortest = std::min(shortest, apart(a.point, b.point));
    std::vector<Box> covered;
    for (std::size_t p = 0; p < points.size(); ++p)
        if (shown[p]) covered.push_back({points[p], points[p]});
    for (const Body& body : mechanism.bodies)
        if (body.circle) {
            const Spot centre = points[at_index(body.circle->centre)];
            covered.push_back(grown({centre, centre}, body.circle->radius.to_double()));
        }
    if (!covered.empty()) box = covered.front();
    for (const Box& each : covered) box.include(each);
    // The centre of a curved slot is shown where the drawing grows little by it.
    constexpr double little = 0.25;
    const Box near = grown(box, little * std::max(box.width(), box.height()));
    for (const Joint& joint : mechanism.joints)
        if (is_curved_slot(joint) && is_within(near, points[at_index(joint.arc)])) {
            shown[at_index(joint.arc)] = true;
            box.include(points[at_index(joint.arc)]);
        }
}

bool Subject::touches_there(BodyIndex body, PointIndex point) const {
    bool touched = false;
    for (const Joint& joint : mechanism.joints) {
        if (!joint.connects(body) || joint.point != point) continue;
        if (joint.pair().has_common_point() || (joint.pair().has_guide() && joint.bodies.front() == body)) return false;
        // A contact without a profile is a point of the touching body.
        if (joint.pair().touches()) touched = joint.profiles.count(body) != 0 && !is_tip(joint, body);
    }
    return touched;
}

}  // namespace kinegraph::render::drawing
