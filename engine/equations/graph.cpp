#include "engine/equations/graph.hpp"

#include <variant>

#include "engine/motion/closure.hpp"
#include "lang/keys/positions.hpp"

namespace kinegraph::vector_loops {

bool AsDrawn::are_pinned_at(BodyIndex a, BodyIndex b, const Vector& place) const {
    return std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
        return joint.pair().has_common_point() && joint.connects(a) && joint.connects(b) &&
               pose.at(joint.point) == place;
    });
}

VectorGraph PairsAsEdges::graph() {
    collect_classes();
    collect_edges();
    if (!graph_.why_not.empty()) return std::move(graph_);
    hold_unsupported_bodies();
    take_drivers();
    return std::move(graph_);
}

void PairsAsEdges::collect_classes() {
    graph_.class_indices.resize(drawn_.mechanism.bodies.size());
    for (std::size_t i = 0; i < graph_.class_indices.size(); ++i) graph_.class_indices[i] = static_cast<int>(i);
    for (const Joint& joint : drawn_.mechanism.joints)
        if (joint.pair().holds_rotation)
            for (const BodyIndex body : joint.bodies)
                unite(graph_.class_of(joint.bodies.front()), graph_.class_of(body));
    graph_.classes.resize(graph_.class_indices.size());
    for (std::size_t i = 0; i < graph_.class_indices.size(); ++i)
        graph_.classes[at_index(graph_.class_indices[i])].bodies.emplace_back(i);
    graph_.classes.front().datum = Vector{1, 0};
}

void PairsAsEdges::unite(int a, int b) {
    for (int& each : graph_.class_indices)
        if (each == std::max(a, b)) each = std::min(a, b);
}

void PairsAsEdges::collect_edges() {
    for (const Joint& joint : drawn_.mechanism.joints) {
        if (joint.pair().has_common_point())
            add_pins(joint);
        else if (joint.pair().has_guide())
            add_guide(joint);
        else
            add_contact(joint);
        if (!graph_.why_not.empty()) return;
    }
}

Edge PairsAsEdges::edge_of(const Joint& joint, Edge::Kind kind, BodyIndex carrier, BodyIndex rider) const {
    Edge edge;
    edge.kind = kind;
    edge.joint = drawn_.mechanism.index_of(joint);
    edge.name = joint.name;
    edge.carrier = carrier;
    edge.rider = rider;
    edge.place = drawn_.pose.at(joint.point);
    return edge;
}

void PairsAsEdges::add_pins(const Joint& joint) {
    const BodyIndex base = joint.connects(frame) ? frame : joint.bodies.front();
    for (const BodyIndex body : joint.bodies) {
        if (body == base) continue;
        Edge edge = edge_of(joint, Edge::Kind::pin, base, body);
        edge.base = edge.head = edge.place;
        graph_.edges.push_back(std::move(edge));
    }
}

void PairsAsEdges::add_guide(const Joint& joint) {
    Edge edge =
        edge_of(joint, joint.arc == none ? Edge::Kind::guide : Edge::Kind::link, joint.bodies[1], joint.bodies[0]);
    if (!joint.pair().holds_rotation) edge.head = edge.place;
    if (joint.arc != none)
        edge.base = drawn_.pose.at(joint.arc);
    else
        edge.along = drawn_.pose.guide_units[at_index(edge.joint)];
    graph_.edges.push_back(std::move(edge));
}

void PairsAsEdges::add_contact(const Joint& joint) {
    const auto sides = sides_of(drawn_.mechanism, drawn_.pose, joint);
    if (!sides && !joint.pair().holds_tangent && !joint.pair().meshes()) return add_tangent(joint);
    if (!sides) {
        graph_.why_not = Words(lang::positions::joint_without_the_profiles_of_both, joint.name);
        return;
    }
    const auto centre = [&](std::size_t side) {
        return (*sides)[side].centre == none ? drawn_.pose.at(joint.point) : drawn_.pose.at((*sides)[side].centre);
    };
    const bool straight = (*sides)[0].straight || (*sides)[1].straight;
    const std::size_t round = (*sides)[0].straight ? 1 : 0;
    Edge edge =
        edge_of(joint, straight ? Edge::Kind::guide : Edge::Kind::link, joint.bodies[1 - round], joint.bodies[round]);
    edge.head = centre(round);
    if (straight)
        edge.along = drawn_.unit(drawn_.pose.tangents[at_index(edge.joint)]);
    else
        edge.base = centre(1 - round);
    if (!straight && drawn_.is_nothing((*edge.head - *edge.base).x) && drawn_.is_nothing((*edge.head - *edge.base).y)) {
        graph_.why_not = Words(lang::positions::joint_the_centres_of_curvature_coincide, joint.name);
        return;
    }
    Rolling rolling{edge.joint, -1,  joint.bodies[round], joint.bodies[1 - round], (*sides)[round].reach, {},
                    straight,   none};
    if (!straight) rolling.reach_of_carrier = (*sides)[1 - round].reach;
    edge.is_unsupported = !joint.pair().holds_normal;
    if (edge.is_unsupported && find_arm(rolling, joint, *edge.head, straight ? std::nullopt : edge.base)) {
        graph_.rollings.push_back(std::move(rolling));
        return;
    }
    if (joint.pair().holds_tangent) {
        rolling.edge = static_cast<int>(graph_.edges.size());
        graph_.rollings.push_back(std::move(rolling));
    }
    graph_.edges.push_back(std::move(edge));
}

void PairsAsEdges::add_tangent(const Joint& joint) {
    Edge edge = edge_of(joint, Edge::Kind::guide, joint.bodies[1], joint.bodies[0]);
    edge.head = edge.place;
    edge.along = drawn_.unit(drawn_.pose.tangents[at_index(edge.joint)]);
    graph_.by_tangent.push_back(edge.joint);
    graph_.edges.push_back(std::move(edge));
}

bool PairsAsEdges::find_arm(Rolling& rolling, const Joint& joint, const Vector& centre,
                            const std::optional<Vector>& other) const {
    std::vector<BodyIndex> candidates{joint.arm};
    for (const BodyIndex body : indices_of(drawn_.mechanism.bodies)) candidates.push_back(body);
    for (const BodyIndex arm : candidates) {
        const bool holds_rider = arm == rolling.rider || drawn_.are_pinned_at(arm, rolling.rider, centre);
        if (!holds_rider) continue;
        if (other &&
            (arm == rolling.carrier ? arm != rolling.rider : drawn_.are_pinned_at(arm, rolling.carrier, *other))) {
            rolling.arm = arm;
            return true;
        }
        if (other) continue;
        for (const Joint& guide : drawn_.mechanism.joints) {
            const JointIndex index = drawn_.mechanism.index_of(guide);
            if (!guide.pair().is_sleeve() || !guide.connects(arm) || !guide.connects(rolling.carrier)) continue;
            if (!drawn_.is_small(cross(drawn_.pose.guide_units[at_index(index)],
                                       drawn_.unit(drawn_.pose.tangents[at_index(rolling.joint)]))))
                continue;
            rolling.arm = arm;
            rolling.rack = index;
            return true;
        }
    }
    return false;
}

void PairsAsEdges::hold_unsupported_bodies() {
    std::vector<int> part(drawn_.mechanism.bodies.size());
    for (std::size_t i = 0; i < part.size(); ++i) part[i] = static_cast<int>(i);
    const auto join = [&](const Edge& edge) {
        const int a = part[at_index(edge.carrier)], b = part[at_index(edge.rider)];
        for (int& each : part)
            if (each == std::max(a, b)) each = std::min(a, b);
    };
    for (const Edge& edge : graph_.edges) join(edge);
    for (const BodyIndex body : drawn_.mechanism.moving_bodies()) {
        if (part[at_index(body)] == 0) continue;
        Edge edge;
        edge.kind = Edge::Kind::guide;
        edge.name = drawn_.name_of(body);
        edge.rider = body;
        edge.along = {1, 0};
        edge.is_unsupported = true;
        const auto& points = drawn_.mechanism.body(body).points;
        edge.place = points.empty() ? Vector{} : drawn_.pose.at(points.front());
        edge.base = Vector{};
        edge.head = edge.place;
        join(edge);
        graph_.edges.push_back(std::move(edge));
    }
}

void PairsAsEdges::take_drivers() {
    for (std::size_t i = 0; i < drawn_.mechanism.drivers.size(); ++i)
        std::visit([&](const auto& given) { take(given, static_cast<int>(i)); }, drawn_.mechanism.drivers[i]);
}

void PairsAsEdges::take(const SpinDriver& driver, int index) {
    const int own = graph_.class_of(driver.body), other = graph_.class_of(driver.relative_to);
    bool is_chained = false;  // the other body's rotation is counted from this one
    for (int each = other; each > 0; each = graph_.classes[at_index(each)].against)
        is_chained = is_chained || each == own;
    TurningClass& turning = graph_.classes[at_index(own)];
    if (own != 0 && own != other && turning.driver < 0 && !is_chained) {
        turning.driver = index;
        turning.against = other == 0 ? -1 : other;
    } else {
        graph_.driven_apart.push_back(index);
    }
}

void PairsAsEdges::take(const SlideDriver& driver, int index) {
    for (Edge& edge : graph_.edges)
        if (edge.joint == driver.joint && edge.kind == Edge::Kind::guide && edge.driver < 0) {
            edge.driver = index;
            return;
        }
    graph_.driven_apart.push_back(index);
}

void PairsAsEdges::take(const PointDriver& driver, int index) {
    const Vector along = drawn_.pose.driver_units[at_index(index)];
    for (Edge& edge : graph_.edges) {
        if (edge.kind != Edge::Kind::guide || edge.is_unsupported || edge.driver >= 0 || edge.joint == none) continue;
        if (graph_.class_of(edge.carrier) != 0 || graph_.class_of(edge.rider) != 0 || edge.carrier != frame) continue;
        const bool carries =
            edge.rider == driver.body || drawn_.are_pinned_at(edge.rider, driver.body, drawn_.pose.at(driver.at));
        if (!carries || !drawn_.is_small(cross(edge.along, along))) continue;
        edge.driver = index;
        edge.sense = dot(edge.along, along).sign();
        return;
    }
    Edge edge;
    edge.kind = Edge::Kind::guide;
    edge.name = drawn_.mechanism.point(driver.at).name;
    edge.rider = driver.body;
    edge.along = along;
    edge.is_unsupported = true;
    edge.place = drawn_.pose.at(driver.at);
    edge.head = edge.place;
    edge.driver = index;
    graph_.edges.push_back(std::move(edge));
}

}  // namespace kinegraph::vector_loops
