#include "constructions/kinematics/degeneracy.hpp"
#include "lang/keys/sentences.hpp"

#include <algorithm>

namespace kinegraph {
namespace {

/// ω_b/ω_reference for all other moving bodies.
Ratios ratios_of(const Branch& branch, const Mechanism& mechanism) {
    const auto omega = [&](BodyIndex body) {
        return Symbol{Symbol::Letter::omega, mechanism.bodies[at_index(body)].name, ""};
    };
    Ratios ratios;
    for (const BodyIndex body : indices<BodyIndex>(branch.ratios.size(), BodyIndex(1)))
        if (body != branch.reference)
            ratios.push_back({omega(body), omega(branch.reference), branch.ratios[at_index(body)]});
    return ratios;
}

}  // namespace

std::optional<InstantMotion> degenerate_motion(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility) {
    if (mobility.redundant.empty() && mobility.idle_drivers.empty()) return std::nullopt;
    return instant_motion_of(mechanism, pose, mobility);
}

std::vector<Message> remarks_on_mobility(const Mechanism& mechanism, const Mobility& mobility,
                                         const std::optional<InstantMotion>& motion) {
    std::vector<Message> remarks;
    for (const Mobility::Redundant& redundant : mobility.redundant)
        remarks.push_back({lang::sentences::repeated_constraints,
                           {file_name(mechanism.joints[at_index(redundant.joint)]), Count{redundant.rows}}});
    if (!motion || motion->freedoms == 0) return remarks;

    const auto names = [&](const std::vector<BodyIndex>& bodies) {
        Names all;
        for (const BodyIndex body : bodies) all.push_back(mechanism.bodies[at_index(body)].name);
        return all;
    };
    if (!mobility.idle_drivers.empty()) {
        if (!motion->still.empty()) remarks.push_back({lang::sentences::still_bodies, {names(motion->still)}});
        std::vector<BodyIndex> asked;
        for (const int driver : mobility.idle_drivers) {
            const auto* spin = std::get_if<SpinDriver>(&mechanism.drivers[at_index(driver)]);
            const auto& unturning = motion->unturning;
            if (spin != nullptr && std::find(unturning.begin(), unturning.end(), spin->body) != unturning.end())
                asked.push_back(spin->body);
        }
        if (!asked.empty()) remarks.push_back({lang::sentences::unturning_bodies, {names(asked)}});
    }
    const Count freedoms{motion->freedoms};
    switch (motion->second_order) {
        case InstantMotion::SecondOrder::unasked:
        case InstantMotion::SecondOrder::free: break;
        case InstantMotion::SecondOrder::impossible:
            remarks.push_back({lang::sentences::instant_only, {freedoms}});
            break;
        case InstantMotion::SecondOrder::open:
            if (motion->conditions > 0)
                remarks.push_back({lang::sentences::bound_velocities, {freedoms, Count{motion->conditions}}});
            break;
        case InstantMotion::SecondOrder::branches: {
            const auto count = static_cast<int>(motion->branches.size());
            remarks.push_back({lang::sentences::change_point, {freedoms, Count{mobility.gruebler}, Count{count}}});
            for (int i = 0; i < count; ++i) {
                const Branch& branch = motion->branches[at_index(i)];
                if (branch.reference == none)
                    remarks.push_back({lang::sentences::branch_without_turning, {Count{i + 1}}});
                else
                    remarks.push_back({lang::sentences::branch, {Count{i + 1}, ratios_of(branch, mechanism)}});
            }
            break;
        }
    }
    return remarks;
}

std::vector<Message> remarks_on_lengths(const Mechanism& mechanism, const Pose& pose) {
    std::vector<Message> remarks;
    for (const BodyIndex body : mechanism.moving_bodies()) {
        std::vector<PointIndex> pins;
        bool has_others = false;  // a guide or a profile may define the body's size
        for (const Joint& joint : mechanism.joints) {
            if (!joint.connects(body)) continue;
            const bool is_pin = joint.pair().is_hinge() || (joint.pair().is_slot() && joint.bodies[0] == body);
            has_others = has_others || !is_pin;
            if (std::find(pins.begin(), pins.end(), joint.point) == pins.end()) pins.push_back(joint.point);
        }
        const auto is_at_first = [&](PointIndex pin) { return pose.at(pin) == pose.at(pins.front()); };
        if (has_others || pins.size() < 2 || !std::all_of(pins.begin(), pins.end(), is_at_first)) continue;
        Names names;
        for (const PointIndex pin : pins) names.push_back(mechanism.point(pin).name);
        remarks.push_back({lang::sentences::link_without_length, {BodyName{mechanism.body(body).name}, names}});
    }
    return remarks;
}

std::vector<Message> remarks_on_gravity(const Mechanism& mechanism) {
    if (!mechanism.gravity || mechanism.masses.empty()) return {};
    // From dwarf planets (Ceres: 0.28 m/s²) to the Sun (274 m/s²).
    constexpr double least = 0.1, most = 300;
    const double size = length(*mechanism.gravity);
    if (size == 0 || (size >= least && size <= most)) return {};
    const Unit& unit = mechanism.units.acceleration;
    return {{lang::sentences::strange_gravity, {Amount{size / unit.si.to_double(), unit.symbol}}}};
}

}  // namespace kinegraph
