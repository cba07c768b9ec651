#include "engine/solution/sliding.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/number/functions.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

using Spot = VectorOf<double>;

/// Whether the name is one letter with digits, which can be joined to another such name: BA, O2A.
bool is_short(const std::string& name) {
    const auto digit = [](char c) { return c == '*' || std::isdigit(static_cast<unsigned char>(c)) != 0; };
    return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
           std::all_of(name.begin() + 1, name.end(), digit);
}

/// Whether several bodies carry a point together, because a pin connects them there.
bool are_pinned(const Mechanism& mechanism, PointIndex point, BodyIndex one, BodyIndex other) {
    return one == other || std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
               return joint.pair().is_hinge() && joint.point == point && joint.connects(one) && joint.connects(other);
           });
}

}  // namespace

Spot direction_of_sliding(const Spot& guide, const Spot& tangent, const Spot& normal) {
    const auto unit = [](const Spot& a) { return (1 / nearest::hypot(a.x, a.y)) * a; };
    if (guide.x != 0 || guide.y != 0) return unit(guide);
    return unit(tangent.x != 0 || tangent.y != 0 ? tangent : quarter_turn(normal));
}

Spot direction_of_sliding(const Pose& pose, JointIndex joint) {
    const std::size_t i = at_index(joint);
    return direction_of_sliding(to_double(pose.guides[i]), to_double(pose.tangents[i]), to_double(pose.normals[i]));
}

std::string relative_name(const std::string& of, const std::string& to) {
    return is_short(of) && is_short(to) ? of + to : of + "," + to;
}

bool is_of_sliding(const Quantity& vector, JointIndex index, bool second_order, const Mechanism& mechanism) {
    const Joint& joint = mechanism.joint(index);
    const Quantity::Kind kind = second_order ? Quantity::Kind::acceleration : Quantity::Kind::velocity;
    if (vector.kind != kind || vector.component != Quantity::Component::whole || vector.point == none) return false;
    // A body in relative translation has one relative velocity, whichever point it is drawn at.
    const bool is_between_moving = joint.bodies[1] != frame;
    if (vector.point != joint.point && !(is_between_moving && joint.pair().is_sleeve())) return false;
    if (!are_pinned(mechanism, vector.point, vector.body, joint.bodies[0])) return false;
    if (!is_between_moving) return vector.part == Quantity::Part::whole;
    return vector.part == Quantity::Part::sliding && are_pinned(mechanism, vector.point, vector.other, joint.bodies[1]);
}

std::optional<Symbol> symbol_of_sliding(const Solution& solution, JointIndex joint, bool second_order) {
    // The joint's own point is preferred.
    const DrawnVector* elsewhere = nullptr;
    for (const DrawnVector& vector : solution.protocol.vectors) {
        if (!is_of_sliding(vector.quantity, joint, second_order, solution.mechanism)) continue;
        if (vector.quantity.point == solution.mechanism.joint(joint).point) return vector.symbol;
        if (elsewhere == nullptr) elsewhere = &vector;
    }
    return elsewhere == nullptr ? std::nullopt : std::optional(elsewhere->symbol);
}

Symbol name_of_sliding(const Solution& solution, JointIndex index, bool second_order) {
    if (auto symbol = symbol_of_sliding(solution, index, second_order)) return *std::move(symbol);
    const Mechanism& mechanism = solution.mechanism;
    const Joint& joint = mechanism.joint(index);
    const bool is_of_point = std::any_of(mechanism.points.begin(), mechanism.points.end(),
                                         [&](const NamedPoint& point) { return point.name == joint.name; });
    return {second_order ? Symbol::Letter::a : Symbol::Letter::v, joint.name,
            is_of_point && joint.bodies[1] != frame ? "rel" : ""};
}

std::string number_of_drive(const PointDriver& driver, const Mechanism& mechanism) {
    int all = 0, own = 0;
    for (const Driver& each : mechanism.drivers) {
        const auto* other = std::get_if<PointDriver>(&each);
        if (other == nullptr || other->at != driver.at) continue;
        ++all;
        if (other->where == driver.where) own = all;
    }
    return all > 1 ? std::to_string(own) : std::string();
}

Symbol along_drive(Symbol::Letter letter, const PointDriver& driver, const Mechanism& mechanism) {
    return {letter, mechanism.point(driver.at).name, "∥" + number_of_drive(driver, mechanism)};
}

}  // namespace kinegraph
