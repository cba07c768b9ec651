#include "engine/mechanism/couplers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

/// Breadth-first from the driven bodies, through gears, rolling contacts and welds: a coupler is driven at the first
/// pin reached, and drives all followers at its other pins; the search goes on from these. A coupler that a driver
/// moves drives its followers too, but no force has to pass along it from pin to pin: it has no transmission angle.
class CouplerSearch {
public:
    CouplerSearch(const Mechanism& mechanism, int driver) : mechanism_(mechanism) {
        for (const Driver& each : mechanism.drivers)
            for (const BodyIndex body : moved_by(each)) driven_.push_back(body);
        for (const BodyIndex body : moved_by(mechanism.drivers[at_index(driver)])) reach(body);
        // the call appends to the list
        for (std::size_t next = 0; next < reached_.size();) go_on_from(reached_[next++]);
    }
    std::vector<Coupler> all() && { return std::move(chains_); }

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
    std::vector<Coupler> chains_;
};

}  // namespace

std::vector<Coupler> couplers_of(const Mechanism& mechanism, int driver) {
    return CouplerSearch(mechanism, driver).all();
}

std::vector<std::pair<std::string, Coupler>> named_couplers(const Mechanism& mechanism, int driver) {
    std::vector<std::pair<std::string, Coupler>> named;
    if (at_index(driver) >= mechanism.drivers.size()) return named;
    for (const Coupler& coupler : couplers_of(mechanism, driver)) {
        std::string name = mechanism.joint(coupler.pin).name;
        const auto is_taken = [&](const auto& each) { return each.first == name; };
        if (std::any_of(named.begin(), named.end(), is_taken)) name += " on " + mechanism.body(coupler.follower).name;
        if (std::none_of(named.begin(), named.end(), is_taken)) named.emplace_back(name, coupler);
    }
    return named;
}

double transmission_angle(const VectorOf<double>& a, const VectorOf<double>& b, const VectorOf<double>& foot,
                          const VectorOf<double>& along) {
    const VectorOf<double> rod = b - a;
    const VectorOf<double> link = along.x == 0 && along.y == 0 ? foot - b : quarter_turn(along);
    // Of directions that are parallel within the data the rounding of their coordinates is left.
    constexpr double noise = 1e-15;
    const double across = std::abs(cross(rod, link)), along_both = std::abs(dot(rod, link));
    return across <= noise * along_both ? 0 : nearest::atan2(across, along_both);
}

}  // namespace kinegraph
