#include "engine/check/numeric_result.hpp"

#include <algorithm>
#include <cmath>

#include "engine/number/functions.hpp"
#include "engine/sentences/result_catalogue.hpp"

namespace kinegraph {
namespace {

using Components = std::array<double, 2>;

double length(const Components& a) { return nearest::hypot(a[0], a[1]); }
Components difference(const Components& a, const Components& b) { return {a[0] - b[0], a[1] - b[1]}; }

std::optional<Components> numeric_sliding(const NumericMotion& motion, const Joint& joint, const Vector& place,
                                          Quantity::Kind kind) {
    const BodyIndex i = joint.bodies[0], j = joint.bodies[1];
    const auto &slider = motion.bodies[at_index(i)], &guide = motion.bodies[at_index(j)];
    if (!slider.velocity_known || !guide.velocity_known) return std::nullopt;
    const Components velocity = difference(motion.velocity(i, place), motion.velocity(j, place));
    if (kind == Quantity::Kind::sliding_velocity) return velocity;
    if (!slider.acceleration_known || !guide.acceleration_known) return std::nullopt;
    const Components coriolis{-2 * guide.omega * velocity[1], 2 * guide.omega * velocity[0]};
    if (kind == Quantity::Kind::sliding_coriolis) return coriolis;
    return difference(difference(motion.acceleration(i, place), motion.acceleration(j, place)), coriolis);
}

}  // namespace

std::optional<Components> numeric_centre(const NumericMotion& motion, const Quantity& centre) {
    const auto &first = motion.bodies[at_index(centre.body)], &second = motion.bodies[at_index(centre.other)];
    if (!first.velocity_known || !second.velocity_known) return std::nullopt;
    const double omega = second.omega - first.omega;
    // Below this the quotient does not determine the place.
    constexpr double least_relative_spin = 1e-6;
    if (!(std::abs(omega) > least_relative_spin * std::max(std::abs(first.omega), std::abs(second.omega))))
        return std::nullopt;
    const Vector origin;
    const Components relative = difference(motion.velocity(centre.other, origin), motion.velocity(centre.body, origin));
    return Components{-relative[1] / omega, relative[0] / omega};
}

std::optional<Components> numeric_curvature(const NumericMotion& motion, const Quantity& quantity,
                                            const Vector& beside) {
    const auto& state = motion.bodies[at_index(quantity.body)];
    if (!state.velocity_known || !state.acceleration_known) return std::nullopt;
    const Components a = motion.acceleration(quantity.body, beside);
    if (quantity.kind == Quantity::Kind::radius) {
        const Components v = motion.velocity(quantity.body, beside);
        const double speed = length(v), across = std::abs(v[0] * a[1] - v[1] * a[0]);
        return across > 0 ? std::optional(Components{speed * speed * speed / across, 0}) : std::nullopt;
    }
    if (state.omega == 0) return std::nullopt;
    const double square = state.omega * state.omega, whole = square * square + state.alpha * state.alpha;
    if (quantity.kind == Quantity::Kind::inflection_diameter) return Components{length(a) / square, 0};
    return Components{beside.x.to_double() + (square * a[0] - state.alpha * a[1]) / whole,
                      beside.y.to_double() + (square * a[1] + state.alpha * a[0]) / whole};
}

std::optional<Components> numeric_result(const NumericMotion& motion, const Mechanism& mechanism, const Pose& pose,
                                         const Quantity& quantity) {
    const ResultKind& row = result_kind(quantity);
    if (row.subject == ResultKind::Subject::joint) {
        const Joint& joint = mechanism.joint(quantity.joint);
        return numeric_sliding(motion, joint, pose.at(joint.point), quantity.kind);
    }
    const auto& state = motion.bodies[at_index(quantity.body)];
    if (!(row.is_velocity() ? state.velocity_known : state.acceleration_known)) return std::nullopt;
    if (row.turns()) return Components{row.is_velocity() ? state.omega : state.alpha, 0};
    const Vector& place = pose.at(quantity.point);
    return row.is_velocity() ? motion.velocity(quantity.body, place) : motion.acceleration(quantity.body, place);
}

}  // namespace kinegraph
