// The results of a solution, one after the other: the only enumeration of what a solution has found. Their names, units
// and signs are in the catalogue (engine/sentences/result_catalogue.hpp).
#pragma once

#include <algorithm>
#include <cstddef>

#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Calls `see(const Quantity&, const Recorded<T>&)` for each result that is known, T being Exact for a scalar and
/// Vector for a vector: bodies in the file's order, points that are not of the frame, slidings, actions at joints,
/// efforts.
template <class See>
void for_each_result(const Solution& solution, See see) {
    const auto show = [&](const Quantity& quantity, const auto& found) {
        if (found) see(quantity, found);
    };
    for (std::size_t b = 1; b < solution.bodies.size(); ++b) {
        show(omega_of(BodyIndex(b)), solution.bodies[b].omega);
        show(alpha_of(BodyIndex(b)), solution.bodies[b].alpha);
    }
    for (const PointMotion& point : solution.points) {
        if (std::find(point.bodies.begin(), point.bodies.end(), frame) != point.bodies.end()) continue;
        show(velocity_of(point), point.velocity);
        show(acceleration_of(point), point.acceleration);
    }
    for (const Sliding& sliding : solution.sliding) {
        show({.kind = Quantity::Kind::sliding_velocity, .joint = sliding.joint}, sliding.velocity);
        show({.kind = Quantity::Kind::sliding_acceleration, .joint = sliding.joint}, sliding.acceleration);
        show({.kind = Quantity::Kind::sliding_coriolis, .joint = sliding.joint}, sliding.coriolis);
    }
    for (const JointForce& action : solution.forces) {
        Quantity quantity = quantity_of(action);
        show(quantity, action.force);
        quantity.kind = Quantity::Kind::couple;
        if (solution.mechanism.joint(action.joint).pair().transmits_couple()) show(quantity, action.couple);
    }
    for (std::size_t e = 0; e < solution.efforts.size(); ++e)
        show({.kind = Quantity::Kind::effort, .given = static_cast<int>(e)}, solution.efforts[e].value);
}

}  // namespace kinegraph
