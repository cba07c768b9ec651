// Couplers: the links through which the motion of a driver passes on to others, each with its transmission angle.
// Contains no positions.
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// A coupler, the pin B at which it drives the follower, the pin A at which it is driven, and the follower's hinge or
/// guide on the frame.
struct Coupler {
    PointIndex a, b, hinge;
    JointIndex pin, guide;  ///< pin: the joint at B; a hinge or a guide, the other is none
    BodyIndex body, follower;
};

/// Those that the driver (by its index) moves, from the driven body onwards.
std::vector<Coupler> couplers_of(const Mechanism& mechanism, int driver);
/// The same by name: that of the pin, with the follower where a coupler before it has that name. None without drivers.
std::vector<std::pair<std::string, Coupler>> named_couplers(const Mechanism& mechanism, int driver);

/// The transmission angle, from 0 to π/2, at the places of the coupler's pins: between their line and the follower's
/// link, or the normal of its guide. `foot`: the follower's hinge. `along`: the direction of its guide, zero if it has
/// none.
double transmission_angle(const VectorOf<double>& a, const VectorOf<double>& b, const VectorOf<double>& foot,
                          const VectorOf<double>& along);
/// In a Pose, or in the Places of another position.
template <class Drawn>
double transmission_angle(const Coupler& coupler, const Drawn& drawn) {
    const auto rough = [](const auto& v) {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, Vector>)
            return to_double(v);
        else
            return v;
    };
    const auto at = [&](PointIndex point) { return rough(drawn.points[at_index(point)]); };
    const bool slides = coupler.guide != none;
    return transmission_angle(at(coupler.a), at(coupler.b), slides ? at(coupler.b) : at(coupler.hinge),
                              slides ? rough(drawn.guides[at_index(coupler.guide)]) : VectorOf<double>());
}

}  // namespace kinegraph
