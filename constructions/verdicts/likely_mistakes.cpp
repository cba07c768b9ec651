#include "constructions/verdicts/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/file/units.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace {

/// Connected components of bodies (union-find).
class Groups {
public:
    explicit Groups(std::size_t count) {
        for (const BodyIndex body : indices<BodyIndex>(count)) parent_.push_back(body);
    }
    BodyIndex of(BodyIndex body) const {
        while (parent_[at_index(body)] != body) body = parent_[at_index(body)];
        return body;
    }
    void join(const std::vector<BodyIndex>& bodies) {
        for (const BodyIndex body : bodies) {
            const auto [low, high] = std::minmax({of(bodies.front()), of(body)});
            parent_[at_index(high)] = low;
        }
    }

private:
    std::vector<BodyIndex> parent_;
};

class Search {
public:
    Search(const Mechanism& mechanism, const Pose& pose) : mechanism_(mechanism), pose_(pose) {
        joints_of_.resize(mechanism.bodies.size());
        for (const Joint& joint : mechanism.joints)
            for (const BodyIndex body : joint.bodies) joints_of_[at_index(body)].push_back(&joint);
    }

    std::vector<Message> run() {
        find_unjoined_pins();
        find_unsupported_bodies();
        find_groups_off_the_frame();
        return std::move(found_);
    }

private:
    /// Points at the same place, rounded to 1e-9 of the drawing: points drawn twice there are meant to be one.
    std::vector<std::vector<PointIndex>> places() const {
        const double step = pose_.size.to_double() * 1e-9;
        std::map<std::pair<double, double>, std::vector<PointIndex>> by_place;
        for (const PointIndex point : indices_of(mechanism_.points)) {
            const Vector& at = pose_.at(point);
            by_place[{std::round(at.x.to_double() / step), std::round(at.y.to_double() / step)}].push_back(point);
        }
        std::vector<std::vector<PointIndex>> places;
        for (auto& [at, points] : by_place) places.push_back(std::move(points));
        std::sort(places.begin(), places.end());  // in the file's order
        return places;
    }

    void find_unjoined_pins() {
        std::vector<std::vector<BodyIndex>> carriers(mechanism_.points.size());
        for (const BodyIndex body : indices_of(mechanism_.bodies))
            for (const PointIndex point : mechanism_.body(body).points) carriers[at_index(point)].push_back(body);
        for (const std::vector<PointIndex>& place : places()) {
            Groups groups(mechanism_.bodies.size());
            for (const Joint& joint : mechanism_.joints)
                if (joint.pair().is_clamp() || std::find(place.begin(), place.end(), joint.point) != place.end())
                    groups.join(joint.bodies);
            std::optional<std::pair<BodyIndex, PointIndex>> first;
            for (const PointIndex point : place) {
                for (const BodyIndex body : carriers[at_index(point)]) {
                    if (!first) first = {body, point};
                    if (groups.of(first->first) == groups.of(body)) continue;
                    miss_pin(first->first, first->second, body, point);
                    groups.join({first->first, body});
                }
            }
        }
    }

    /// Two bodies need one pin, however many points they share.
    void miss_pin(BodyIndex first, PointIndex at, BodyIndex second, PointIndex other) {
        if (!unjoined_.insert({first, second}).second) return;
        named_.insert({first, second});
        found_.push_back({lang::sentences::unjoined_pin,
                          {body(first), body(second), point(at), point(other == at ? PointIndex() : other),
                           hinge(at, first, second)}});
    }

    void find_unsupported_bodies() {
        for (const BodyIndex index : indices<BodyIndex>(mechanism_.bodies.size(), frame.next())) {
            const auto& joints = joints_of_[at_index(index)];
            if (named_.contains(index) || joints.size() > 1) continue;
            if (joints.empty())
                found_.push_back({lang::sentences::body_without_joint, {body(index), hinge_with_frame(index)}});
            else if (joints.front()->pair().freedoms() > 0 && !is_driven_or_held(index))
                found_.push_back({lang::sentences::body_of_one_joint,
                                  {body(index), file_name(*joints.front()), hinge_with_frame(index)}});
            else
                continue;
            named_.insert(index);
        }
    }

    void find_groups_off_the_frame() {
        Groups groups(mechanism_.bodies.size());
        for (const Joint& joint : mechanism_.joints) groups.join(joint.bodies);
        std::map<BodyIndex, std::vector<BodyIndex>> apart;
        for (const BodyIndex body : indices<BodyIndex>(mechanism_.bodies.size(), frame.next()))
            if (groups.of(body) != frame) apart[groups.of(body)].push_back(body);
        for (const auto& [root, bodies] : apart) {
            if (std::any_of(bodies.begin(), bodies.end(), [&](BodyIndex each) { return named_.contains(each); }))
                continue;
            Names names;
            std::string hinge;
            for (const BodyIndex each : bodies) {
                names.push_back(mechanism_.body(each).name);
                if (hinge.empty()) hinge = hinge_with_frame(each);
            }
            found_.push_back({lang::sentences::off_the_frame, {names, body(frame), hinge}});
        }
    }

    bool is_driven_or_held(BodyIndex body) const {
        const auto at_joint = [&](JointIndex joint) { return mechanism_.joint(joint).connects(body); };
        const auto moves = [&](const auto& driver) {
            if constexpr (requires { driver.joint; })
                return at_joint(driver.joint);
            else if constexpr (requires { driver.relative_to; })
                return driver.body == body || driver.relative_to == body;
            else
                return driver.body == body;
        };
        const auto holds = [&](const auto& effort) {
            if constexpr (requires { effort.joint; })
                return at_joint(effort.joint);
            else if constexpr (requires { effort.from; })
                return effort.body == body || effort.from == body;
            else
                return effort.body == body;
        };
        const auto springs = [&](const auto& load) {
            if constexpr (requires { load.bodies; })
                return load.bodies[0] == body || load.bodies[1] == body;
            else
                return false;
        };
        const auto any = [](const auto& list, const auto& concerns) {
            return std::any_of(list.begin(), list.end(), [&](const auto& each) { return std::visit(concerns, each); });
        };
        return any(mechanism_.drivers, moves) || any(mechanism_.efforts, holds) || any(mechanism_.loads, springs);
    }

    /// At the body's first point without a joint; empty if all have one.
    std::string hinge_with_frame(BodyIndex body) const {
        const auto& joints = joints_of_[at_index(body)];
        for (const PointIndex point : mechanism_.body(body).points)
            if (std::none_of(joints.begin(), joints.end(), [&](const Joint* joint) { return joint->point == point; }))
                return hinge(point, frame, body);
        return {};
    }

    std::string hinge(PointIndex at, BodyIndex first, BodyIndex second) const {
        return "{\"revolute\": " + quoted(mechanism_.point(at).name) + ", \"bodies\": [" +
               quoted(mechanism_.body(first).name) + ", " + quoted(mechanism_.body(second).name) + "]}";
    }
    BodyName body(BodyIndex index) const { return {mechanism_.body(index).name}; }
    PointName point(PointIndex index) const { return {index == none ? std::string() : mechanism_.point(index).name}; }

    const Mechanism& mechanism_;
    const Pose& pose_;
    std::vector<std::vector<const Joint*>> joints_of_;
    std::set<BodyIndex> named_;
    std::set<std::pair<BodyIndex, BodyIndex>> unjoined_;
    std::vector<Message> found_;
};

/// Drivers and input forces in another number than the freedoms. Without any nothing is said: the centres are wanted,
/// or whether the loads balance. With redundant constraints the freedoms of this position may be those of an instant,
/// and another driver is no remedy; nor is it at a dead point, where a driver determines nothing.
std::vector<Message> unequal_counts(const Mechanism& mechanism, const Mobility& mobility) {
    std::vector<Message> found;
    if (!mobility.redundant.empty()) return found;
    const Count freedoms{mobility.effective};
    const int drivers = static_cast<int>(mechanism.drivers.size());
    const int efforts = static_cast<int>(mechanism.efforts.size());
    if (drivers > mobility.effective)
        found.push_back({lang::sentences::drivers_without_freedom, {freedoms, Count{drivers}}});
    else if (drivers > 0 && mobility.driven < mobility.effective && mobility.idle_drivers.empty())
        found.push_back({lang::sentences::freedoms_without_driver, {freedoms, Count{mobility.driven}}});
    if (efforts > 0 && efforts < mobility.effective)
        found.push_back({lang::sentences::freedoms_without_effort, {freedoms, Count{efforts}}});
    else if (efforts > mobility.effective)
        found.push_back({lang::sentences::efforts_without_freedom, {freedoms, Count{efforts}}});
    return found;
}

}  // namespace

std::vector<Message> likely_mistakes(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility,
                                     bool counted) {
    const int efforts = static_cast<int>(mechanism.efforts.size());
    // In a mechanism without drivers, input forces and loads one freedom is intended: its instant centres are wanted.
    const bool bare = mechanism.drivers.empty() && mechanism.efforts.empty() && mechanism.loads.empty();
    const int meant = std::max({mobility.driven, efforts, bare ? 1 : 0});
    // For loads on bodies without joints or drivers the resultant is wanted.
    const bool adrift = mechanism.joints.empty() && mechanism.drivers.empty() && !mechanism.loads.empty();
    if (mechanism.motion || adrift) return {};
    std::vector<Message> found;
    if (mobility.effective > meant) found = Search(mechanism, pose).run();
    // A missing joint explains a freedom too many.
    return found.empty() && counted ? unequal_counts(mechanism, mobility) : found;
}

}  // namespace kinegraph
