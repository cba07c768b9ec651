// The least transmission angle of a mechanism over its travel.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "constructions/positions/cycle.hpp"
#include "engine/mechanism/couplers.hpp"

namespace kinegraph {

namespace {

Transmission least_of(const Coupler& chain, Positions positions, const Travel& travel) {
    Places places;
    const auto angle_of = [&](Positions& there, double coordinate) -> double {
        if (!there.move_to(coordinate)) return std::numbers::pi;
        there.read(places);
        return transmission_angle(chain, places);
    };
    const auto angle = [&](double coordinate) { return angle_of(positions, coordinate); };
    // As in at_limit(): by two positions near it, of a copy: from a limit no other position is reached.
    const auto angle_at_limit = [&](double limit, double inward) {
        constexpr double near = 1e-6;
        Positions there = positions;
        const double far = angle_of(there, limit + 4 * near * inward), close = angle_of(there, limit + near * inward);
        return std::max(far, close) < std::numbers::pi ? std::max(2 * close - far, 0.0) : std::numbers::pi;
    };
    constexpr int samples = 360;
    const double way = travel.to - travel.from, step = way / samples;
    Transmission found{chain.body, chain.follower, chain.pin, std::numbers::pi, 0};
    for (int i = 0; i <= samples; ++i) {
        const double coordinate = i == samples ? travel.to : travel.from + i * step;
        const double here = i == 0 && travel.starts_at_limit       ? angle_at_limit(travel.from, way)
                            : i == samples && travel.ends_at_limit ? angle_at_limit(travel.to, -way)
                                                                   : angle(coordinate);
        if (here < found.least) found.least = here, found.at = coordinate;
    }
    // Between the neighbours of the smallest sample there is one minimum.
    const double low_end = std::min(travel.from, travel.to), high_end = std::max(travel.from, travel.to);
    double low = std::max(found.at - std::abs(step), low_end), high = std::min(found.at + std::abs(step), high_end);
    for (int i = 0; i < 60; ++i) {
        const double third = (high - low) / 3;
        (angle(low + third) < angle(high - third) ? high : low) =
            angle(low + third) < angle(high - third) ? high - third : low + third;
    }
    const double middle = (low + high) / 2;
    if (const double here = angle(middle); here < found.least) found.least = here, found.at = middle;
    return found;
}

}  // namespace

std::optional<Transmission> transmission_of(const Mechanism& mechanism, const Positions& positions, int driver,
                                            const Travel& travel) {
    std::optional<Transmission> least;
    for (const Coupler& chain : couplers_of(mechanism, driver))
        if (const Transmission found = least_of(chain, positions, travel); !least || found.least < least->least)
            least = found;
    return least;
}

}  // namespace kinegraph
