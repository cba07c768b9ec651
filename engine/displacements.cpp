#include "engine/displacements.hpp"

#include <variant>

namespace kinegraph {
namespace {

using Pair = std::array<double, 2>;

const Equations::BodyState* state_of(const Equations& equations, BodyIndex body) {
    if (!equations.why_not.empty() || at_index(body) >= equations.bodies.size()) return nullptr;
    return &equations.bodies[at_index(body)];
}
std::optional<Pair> velocity_of(const Equations& equations, BodyIndex body, const Vector& place) {
    if (body == frame) return Pair{0, 0};
    const auto* state = state_of(equations, body);
    return state == nullptr ? std::nullopt : state->velocity_of(place);
}
std::optional<double> omega_of(const Equations& equations, BodyIndex body) {
    if (body == frame) return 0;
    const auto* state = state_of(equations, body);
    return state == nullptr ? std::nullopt : state->omega;
}
double dot(const Vector& a, const Pair& b) { return a.x.to_double() * b[0] + a.y.to_double() * b[1]; }

}  // namespace

std::vector<EffortValue> efforts_found(const Solution& solution) {
    std::vector<EffortValue> efforts = solution.efforts;
    if (!solution.displacements) return efforts;
    if (efforts.empty())
        for (const Effort& each : solution.mechanism.efforts)
            efforts.push_back({std::visit([](const auto& effort) { return effort.name; }, each), std::nullopt});
    for (const Displacements::Effort& each : solution.displacements->efforts) {
        EffortValue& effort = efforts[at_index(each.given)];
        if (!effort.value && each.value) effort.value = *each.value;
    }
    return efforts;
}

bool is_turn(const Driver& driver) { return std::holds_alternative<SpinDriver>(driver); }

std::string coordinate_name(const Mechanism& mechanism, const Driver& driver) {
    if (const auto* spin = std::get_if<SpinDriver>(&driver))
        return "theta " + mechanism.body(spin->body).name +
               (spin->relative_to == frame ? "" : " on " + mechanism.body(spin->relative_to).name);
    if (const auto* slide = std::get_if<SlideDriver>(&driver)) return "s " + mechanism.joint(slide->joint).name;
    return "s " + mechanism.point(std::get<PointDriver>(driver).at).name;
}

std::optional<double> work_by_ratios(const Equations& equations, const VirtualWork::Entry& entry) {
    double work = 0;
    if (!entry.force.is_zero()) {
        const auto moved = velocity_of(equations, entry.body, entry.at);
        if (!moved) return std::nullopt;
        work += dot(entry.force, *moved);
    }
    if (!entry.couple.is_zero()) {
        const auto turned = omega_of(equations, entry.body);
        if (!turned) return std::nullopt;
        work += entry.couple.to_double() * *turned;
    }
    return work;
}

std::optional<double> work_by_ratios(const Equations& equations, const Mechanism& mechanism, const Pose& pose, int effort) {
    const Effort& given = mechanism.efforts[at_index(effort)];
    if (const auto* couple = std::get_if<CoupleEffort>(&given)) {
        const auto on = omega_of(equations, couple->body), from = omega_of(equations, couple->from);
        if (!on || !from) return std::nullopt;
        return *on - *from;
    }
    if (const auto* force = std::get_if<ForceEffort>(&given)) {
        const auto moved = velocity_of(equations, force->body, pose.at(force->at));
        if (!moved) return std::nullopt;
        return dot(unit_along(direction_of(force->along, pose), pose.bits), *moved);
    }
    const JointIndex index = std::get<ActuatorEffort>(given).joint;
    const Joint& joint = mechanism.joint(index);
    const auto on = velocity_of(equations, joint.bodies[0], pose.at(joint.point)),
               from = velocity_of(equations, joint.bodies[1], pose.at(joint.point));
    if (!on || !from) return std::nullopt;
    return dot(pose.guide_units[at_index(index)], Pair{(*on)[0] - (*from)[0], (*on)[1] - (*from)[1]});
}

}  // namespace kinegraph
