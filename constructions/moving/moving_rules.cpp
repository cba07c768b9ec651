#include "constructions/moving/moving_rules.hpp"

#include <cmath>
#include <utility>

#include "engine/mechanism/drivers.hpp"
#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

using Rule = MovingGiven::Rule;

MovingGiven with(MovingGiven rule, Rule kind) {
    rule.rule = kind;
    return rule;
}
std::optional<MovingGiven> along(MovingGiven rule, const Bearing& bearing) {
    const auto* ends = std::get_if<Bearing::Between>(&bearing.form);
    if (ends == nullptr) return std::nullopt;
    rule.ends = {ends->from, ends->to};
    return with(rule, Rule::between);
}
double direction_of(const Vector& vector) { return nearest::atan2(vector.y.to_double(), vector.x.to_double()); }

std::vector<MovingSetting> settings_of(const Mechanism& mechanism, const Pose& pose) {
    using Kind = MovingSetting::Kind;
    std::vector<MovingSetting> all;
    const auto add = [&](MovingSetting each) {
        if (each.value != 0) all.push_back(std::move(each));
    };
    for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
        const Driver& driver = mechanism.drivers[i];
        if (law_of(driver) != nullptr) continue;
        const bool turning = turns(driver);
        const Rates rates = rates_of(driver);
        const std::string name = name_of_course(mechanism, driver);
        const int of = static_cast<int>(i);
        add({Kind::velocity, of, (turning ? "ω " : "v ") + name,
             turning ? QuantityKind::angular_velocity : QuantityKind::velocity, rates.first.to_double()});
        add({Kind::acceleration, of, (turning ? "α " : "a ") + name,
             turning ? QuantityKind::angular_acceleration : QuantityKind::acceleration, rates.second.to_double()});
    }
    for (std::size_t i = 0; i < mechanism.loads.size(); ++i) {
        const int of = static_cast<int>(i);
        if (const auto* couple = std::get_if<CoupleLoad>(&mechanism.loads[i]))
            add({Kind::load, of, couple->name, QuantityKind::moment, couple->value.to_double()});
        const auto* force = std::get_if<ForceLoad>(&mechanism.loads[i]);
        if (force == nullptr) continue;
        MovingSetting size{Kind::load, of, force->name, QuantityKind::force,
                           force->value ? length(*force->value) : force->magnitude->first.to_double()};
        // On a mechanism that moves the sense of a load in the file may depend on the position.
        if (mechanism.drivers.empty())
            size.direction =
                direction_of(force->value ? *force->value : kinegraph::direction_of(force->magnitude->second, pose));
        add(std::move(size));
    }
    if (!mechanism.motion) return all;
    const auto& given = mechanism.motion->velocities;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto* velocity = std::get_if<Vector>(&given[i].value);
        if (velocity == nullptr) continue;
        MovingSetting size{Kind::point_velocity, static_cast<int>(i), "v " + mechanism.point(given[i].point).name,
                           QuantityKind::velocity, length(*velocity)};
        size.direction = direction_of(*velocity);
        add(std::move(size));
    }
    return all;
}
}  // namespace

std::string name_of_course(const Mechanism& mechanism, const Driver& driver) {
    if (const auto* spin = std::get_if<SpinDriver>(&driver)) return mechanism.body(spin->body).name;
    if (const auto* slide = std::get_if<SlideDriver>(&driver)) return mechanism.joint(slide->joint).name;
    return mechanism.point(std::get<PointDriver>(driver).at).name;
}

MovingRules::MovingRules(const Mechanism& mechanism, const Pose& pose)
    : mechanism_(mechanism), pose_(pose), settings_(settings_of(mechanism, pose)) {}

std::optional<MovingGiven> MovingRules::of(const Given& given, int index) const {
    MovingGiven rule;
    rule.given = index;
    rule.index = given.index;
    switch (given.kind) {
        case Given::Kind::place: return with(rule, Rule::place);
        case Given::Kind::guide: return with(rule, Rule::guide);
        case Given::Kind::guide_unit: return with(rule, Rule::guide_unit);
        case Given::Kind::normal: return with(rule, Rule::normal);
        case Given::Kind::other_normal: return with(rule, Rule::other_normal);
        case Given::Kind::tangent: return with(rule, Rule::tangent);
        case Given::Kind::push: rule.factor = push_of(at_index(given.index)); return with(rule, Rule::normal);
        case Given::Kind::driver_velocity:
        case Given::Kind::driver_acceleration: return of_driver(rule, given.kind == Given::Kind::driver_velocity);
        case Given::Kind::effort_unit:
            return along(rule, std::get<ForceEffort>(mechanism_.efforts[at_index(given.index)]).along);
        case Given::Kind::load_force: return setting(rule, MovingSetting::Kind::load);
        case Given::Kind::act_velocity: return setting(rule, MovingSetting::Kind::point_velocity);
        case Given::Kind::load_unit:
        case Given::Kind::load_unit_back:
        case Given::Kind::load_magnitude: return of_load(rule, given.kind, mechanism_.loads[at_index(given.index)]);
        default: return std::nullopt;
    }
}

std::optional<MovingGiven> MovingRules::of_driver(MovingGiven rule, bool is_velocity) const {
    if (law_of(mechanism_.drivers[at_index(rule.index)]) == nullptr)
        return setting(rule, is_velocity ? MovingSetting::Kind::velocity : MovingSetting::Kind::acceleration);
    return with(rule, is_velocity ? Rule::rate : Rule::acceleration);
}

std::optional<MovingGiven> MovingRules::of_load(MovingGiven rule, Given::Kind kind, const Load& load) const {
    if (const auto* distributed = std::get_if<DistributedLoad>(&load)) {
        return kind == Given::Kind::load_unit ? along(rule, distributed->along) : std::nullopt;
    }
    if (const auto* torsion = std::get_if<TorsionLoad>(&load)) {
        rule.bodies = torsion->bodies;
        rule.factor = torsion->stiffness.to_double();
        rule.offset = torsion->turned.to_double();
        return with(rule, Rule::torsion);
    }
    if (const auto* spring = std::get_if<SpringLoad>(&load)) {
        rule.ends = spring->between;
        if (kind == Given::Kind::load_unit_back) std::swap(rule.ends[0], rule.ends[1]);
        if (kind != Given::Kind::load_magnitude) return with(rule, Rule::between);
        if (!spring->elastic) return std::nullopt;
        rule.factor = spring->elastic->stiffness.to_double();
        rule.offset = spring->elastic->free_length.to_double();
        return with(rule, Rule::spring);
    }
    const auto* force = std::get_if<ForceLoad>(&load);
    if (kind == Given::Kind::load_magnitude) return setting(rule, MovingSetting::Kind::load);
    if (force == nullptr || !force->magnitude) return std::nullopt;
    const auto size = setting(rule, MovingSetting::Kind::load);
    if (size && settings_[static_cast<std::size_t>(size->index)].direction) return with(*size, Rule::turned);
    return along(rule, force->magnitude->second);
}

std::optional<MovingGiven> MovingRules::setting(MovingGiven rule, MovingSetting::Kind kind) const {
    for (std::size_t i = 0; i < settings_.size(); ++i) {
        if (settings_[i].kind != kind || settings_[i].of != rule.index) continue;
        rule.index = static_cast<int>(i);
        return with(rule, Rule::setting);
    }
    return std::nullopt;
}

double MovingRules::push_of(std::size_t joint) const {
    const auto& pushes = mechanism_.joints[joint].pushes;
    return pushes && dot(*pushes, pose_.normals[joint]).sign() < 0 ? -1 : 1;
}

}  // namespace kinegraph
