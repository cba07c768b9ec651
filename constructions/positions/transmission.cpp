// The least transmission angle of a mechanism over its travel.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "constructions/positions/cycle.hpp"

namespace kinegraph {

namespace {

using Spot = VectorOf<double>;

/// A coupler, the pin B at which it drives the follower, the pin A at which it is driven, and the follower's hinge or
/// guide on the frame.
struct Chain {
    PointIndex a, b, hinge;
    JointIndex pin, guide;  // pin: the joint at B
    BodyIndex coupler, follower;
};

/// Breadth-first from the driven bodies, through gears, rolling contacts and welds: a coupler is driven at the first
/// pin reached, and drives all followers at its other pins; the search goes on from these. A coupler that a driver
/// moves drives its followers too, but no force has to pass along it from pin to pin: it has no transmission angle.
class Couplers {
public:
    Couplers(const Mechanism& mechanism, int driver) : mechanism_(mechanism) {
        for (const Driver& each : mechanism.drivers)
            for (const BodyIndex body : moved_by(each)) driven_.push_back(body);
        for (const BodyIndex body : moved_by(mechanism.drivers[at_index(driver)])) reach(body);
        // the call appends to the list
        for (std::size_t next = 0; next < reached_.size();) go_on_from(reached_[next++]);
    }
    std::vector<Chain> all() && { return std::move(chains_); }

private:
    /// The bodies between which the driver acts, without the frame.
    std::vector<BodyIndex> moved_by(const Driver& driver) const {
        std::vector<BodyIndex> bodies;
        if (const auto* spin = std::get_if<SpinDriver>(&driver)) bodies = {spin->body, spin->relative_to};
        if (const auto* slide = std::get_if<SlideDriver>(&driver)) bodies = mechanism_.joint(slide->joint).bodies;
        if (const auto* point = std::get_if<PointDriver>(&driver)) bodies = {point->body};
        std::erase(bodies, frame);
        return bodies;
    }
    void reach(BodyIndex body) {
        if (is_reached(body)) return;
        reached_.push_back(body);
        if (is_driven(body) && !on_frame(body)) push_followers(body, nullptr);
    }
    void go_on_from(BodyIndex body) {
        for (const Joint& joint : mechanism_.joints) {
            if (!joint.connects(body)) continue;
            const PlanePair& pair = joint.pair();
            for (const BodyIndex other : joint.bodies) {
                if (other == frame || is_reached(other)) continue;
                if (pair.is_clamp() || ((pair.meshes() || pair.rolls()) && on_frame(other))) {
                    reach(other);
                } else if (pair.is_hinge() && !on_frame(other)) {
                    reach(other);
                    if (!is_driven(other)) push_followers(other, &joint);
                }
            }
        }
    }
    /// `from`: the joint that drives the coupler; null where a driver does.
    void push_followers(BodyIndex coupler, const Joint* from) {
        for (const Joint& pin : mechanism_.joints) {
            if (!pin.pair().is_hinge() || &pin == from || !pin.connects(coupler)) continue;
            for (const BodyIndex follower : pin.bodies) {
                const Joint* foot = follower == frame || is_reached(follower) ? nullptr : foot_of(follower);
                if (foot == nullptr) continue;
                const bool hinged = foot->pair().is_hinge();
                if (from != nullptr)
                    chains_.push_back({from->point, pin.point, hinged ? foot->point : PointIndex(none),
                                       mechanism_.index_of(pin), hinged ? JointIndex(none) : mechanism_.index_of(*foot),
                                       coupler, follower});
                reach(follower);
            }
        }
    }
    bool is_reached(BodyIndex body) const {
        return std::find(reached_.begin(), reached_.end(), body) != reached_.end();
    }
    bool is_driven(BodyIndex body) const { return std::find(driven_.begin(), driven_.end(), body) != driven_.end(); }
    bool on_frame(BodyIndex body) const {
        return std::any_of(mechanism_.joints.begin(), mechanism_.joints.end(),
                           [&](const Joint& joint) { return joint.connects(body) && joint.connects(frame); });
    }
    const Joint* foot_of(BodyIndex follower) const {
        for (const Joint& joint : mechanism_.joints)
            if (joint.connects(follower) && joint.connects(frame) &&
                (joint.pair().is_hinge() || joint.pair().is_sleeve()))
                return &joint;
        return nullptr;
    }

    const Mechanism& mechanism_;
    std::vector<BodyIndex> driven_;  ///< by any driver
    std::vector<BodyIndex> reached_;
    std::vector<Chain> chains_;
};

Transmission least_of(const Chain& chain, Positions positions, const Travel& travel) {
    Places places;
    const auto angle_of = [&](Positions& there, double coordinate) -> double {
        if (!there.move_to(coordinate)) return std::numbers::pi;
        there.read(places);
        const auto at = [&](PointIndex point) { return places.points[at_index(point)]; };
        const Spot rod = at(chain.b) - at(chain.a);
        const Spot link =
            chain.guide == none ? at(chain.hinge) - at(chain.b) : quarter_turn(places.guides[at_index(chain.guide)]);
        return std::atan2(std::abs(cross(rod, link)), std::abs(dot(rod, link)));
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
    Transmission found{chain.coupler, chain.follower, chain.pin, std::numbers::pi, 0};
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
    for (const Chain& chain : Couplers(mechanism, driver).all())
        if (const Transmission found = least_of(chain, positions, travel); !least || found.least < least->least)
            least = found;
    return least;
}

}  // namespace kinegraph
