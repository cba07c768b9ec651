#include "engine/solution/magnitudes.hpp"

#include <algorithm>
#include <cmath>

#include "engine/drawing/spring_force.hpp"
#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {

using Kind = Quantity::Kind;

void raise(double& largest, double value) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
}

bool acts_as_couple(const Load& load) {
    return std::holds_alternative<CoupleLoad>(load) || std::holds_alternative<TorsionLoad>(load);
}

}  // namespace

std::vector<std::optional<double>> moduli_of_motion(const Protocol& protocol) {
    std::vector<std::optional<double>> moduli;
    moduli.reserve(protocol.vectors.size());
    for (const DrawnVector& vector : protocol.vectors) {
        if (protocol.polygons[at_index(vector.polygon)].plane == Plane::force)
            moduli.emplace_back();
        else
            moduli.emplace_back(protocol.modulus_of(vector));
    }
    return moduli;
}

Magnitudes::Magnitudes(const Solution& solution, const std::vector<std::optional<double>>& moduli)
    : mechanism_(solution.mechanism), pose_(solution.pose) {
    for (const CheckRow& row : solution.checks) {
        take(row.quantity, row.graphical);
        take(row.quantity, row.numeric);
    }
    for (std::size_t v = 0; v < moduli.size(); ++v)
        if (moduli[v]) take(solution.protocol.vectors[v].quantity, *moduli[v]);
    for (const FreeBody& body : solution.free_bodies)
        for (const AppliedForce& applied : body.forces) {
            raise(force_, length(applied.force));
            raise(couple_, applied.couple.to_double());
        }
    if (solution.virtual_work)
        for (const VirtualWork::Entry& entry : solution.virtual_work->entries) raise(power_, entry.power.to_double());
    take_what_is_given();
    tie_together(solution.pose.size.to_double());
}

void Magnitudes::take(const Quantity& quantity, double value) {
    switch (quantity.kind) {
        case Kind::velocity:
        case Kind::sliding_velocity: return raise(velocity_, value);
        case Kind::acceleration:
        case Kind::sliding_acceleration:
        case Kind::sliding_coriolis: return raise(acceleration_, value);
        case Kind::omega: return raise(omega_, value);
        case Kind::alpha: return raise(alpha_, value);
        case Kind::centre:
        case Kind::acceleration_pole:
        case Kind::radius:
        case Kind::inflection_diameter: return raise(place_, value);
        case Kind::force:
        case Kind::force_component: return raise(force_, value);
        case Kind::couple: return raise(couple_, value);
        default: return;
    }
}

void Magnitudes::take_what_is_given() {
    const auto drive = [&](const auto& given) {
        if constexpr (requires { given.omega; }) {
            raise(omega_, given.omega.to_double());
            raise(alpha_, given.alpha.to_double());
        } else {
            raise(velocity_, given.speed.to_double());
            raise(acceleration_, given.acceleration.to_double());
        }
    };
    for (const Driver& driver : mechanism_.drivers) std::visit(drive, driver);
    for (const Load& load : mechanism_.loads) {
        if (const auto* force = std::get_if<ForceLoad>(&load))
            raise(force_, force->value ? length(*force->value) : force->magnitude->first.to_double());
        if (const auto* couple = std::get_if<CoupleLoad>(&load)) raise(couple_, couple->value.to_double());
        if (const auto* spring = std::get_if<SpringLoad>(&load)) raise(force_, pull_of(*spring, pose_).to_double());
        if (const auto* distributed = std::get_if<DistributedLoad>(&load))
            raise(force_, force_of(*distributed, pose_).to_double());
        if (const auto* torsion = std::get_if<TorsionLoad>(&load)) raise(couple_, couple_of(*torsion).to_double());
    }
    for (const Mass& mass : mechanism_.masses)
        if (mechanism_.gravity) raise(force_, mass.mass.to_double() * length(*mechanism_.gravity));
}

void Magnitudes::tie_together(double size) {
    raise(place_, size);
    if (!(size > 0)) return;
    raise(omega_, velocity_ / size);
    raise(velocity_, omega_ * size);
    raise(acceleration_, omega_ * omega_ * size);
    raise(alpha_, acceleration_ / size);
    raise(acceleration_, alpha_ * size);
    raise(couple_, force_ * size);
    raise(force_, couple_ / size);
    raise(power_, force_ * velocity_);
}

double Magnitudes::of(const Quantity& quantity) const {
    switch (quantity.kind) {
        case Kind::unnamed: return 0;
        case Kind::velocity:
        case Kind::sliding_velocity: return velocity_;
        case Kind::acceleration:
        case Kind::sliding_acceleration:
        case Kind::sliding_coriolis: return acceleration_;
        case Kind::omega: return omega_;
        case Kind::alpha: return alpha_;
        case Kind::centre:
        case Kind::acceleration_pole:
        case Kind::radius:
        case Kind::inflection_diameter: return place_;
        case Kind::force:
        case Kind::force_component:
        case Kind::weight:
        case Kind::resultant:
        case Kind::bar: return force_;
        case Kind::couple:
        case Kind::resultant_couple: return couple_;
        case Kind::load: return acts_as_couple(mechanism_.loads[at_index(quantity.given)]) ? couple_ : force_;
        case Kind::inertia: return force_;
        case Kind::effort:
        case Kind::virtual_effort:
            return std::holds_alternative<CoupleEffort>(mechanism_.efforts[at_index(quantity.given)]) ? couple_
                                                                                                      : force_;
        case Kind::virtual_power: return power_;
    }
    KG_ASSERT(false, "a quantity has a kind");
}

bool Magnitudes::is_noise(const Quantity& quantity, double value) const {
    return std::abs(value) <= noise * of(quantity);
}

}  // namespace kinegraph
