// Sliding at a joint: see sliding.hpp.
#include "engine/sliding.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace kinegraph {
namespace {

using Spot = VectorOf<double>;

Spot rough(const Vector& a) { return {a.x.to_double(), a.y.to_double()}; }

/// A name that is one letter with digits reads well beside another such: BA, O2A.
bool is_short(const std::string& name) {
    const auto digit = [](char c) { return c == '*' || std::isdigit(static_cast<unsigned char>(c)) != 0; };
    return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
           std::all_of(name.begin() + 1, name.end(), digit);
}

/// Whether two bodies carry a point alike: a pin there holds them together.
bool are_pinned(const Mechanism& mechanism, PointIndex point, BodyIndex one, BodyIndex other) {
    return one == other || std::any_of(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
               return joint.pair().is_hinge() && joint.point == point && joint.connects(one) && joint.connects(other);
           });
}

}  // namespace

Spot direction_of_sliding(const Spot& guide, const Spot& tangent, const Spot& normal) {
    const auto unit = [](const Spot& a) { return (1 / std::hypot(a.x, a.y)) * a; };
    if (guide.x != 0 || guide.y != 0) return unit(guide);
    return unit(tangent.x != 0 || tangent.y != 0 ? tangent : quarter_turn(normal));
}

Spot direction_of_sliding(const Pose& pose, JointIndex joint) {
    const std::size_t i = at_index(joint);
    return direction_of_sliding(rough(pose.guides[i]), rough(pose.tangents[i]), rough(pose.normals[i]));
}

std::string relative_name(const std::string& of, const std::string& to) {
    return is_short(of) && is_short(to) ? of + to : of + "," + to;
}

bool is_of_sliding(const Quantity& vector, JointIndex index, bool second_order, const Mechanism& mechanism) {
    const Joint& joint = mechanism.joint(index);
    const Quantity::Kind kind = second_order ? Quantity::Kind::acceleration : Quantity::Kind::velocity;
    if (vector.kind != kind || vector.point != joint.point || vector.component != Quantity::Component::whole) return false;
    if (!are_pinned(mechanism, joint.point, vector.body, joint.bodies[0])) return false;
    if (joint.bodies[1] == frame) return vector.part == Quantity::Part::whole;
    return vector.part == Quantity::Part::sliding && are_pinned(mechanism, joint.point, vector.other, joint.bodies[1]);
}

std::optional<Symbol> symbol_of_sliding(const Solution& solution, JointIndex joint, bool second_order) {
    for (const DrawnVector& vector : solution.protocol.vectors)
        if (is_of_sliding(vector.quantity, joint, second_order, solution.mechanism)) return vector.symbol;
    return std::nullopt;
}

}  // namespace kinegraph
