#include "engine/solution/magnitudes.hpp"

#include <algorithm>
#include <cmath>

#include "engine/drawing/spring_force.hpp"
#include "engine/sentences/result_catalogue.hpp"

namespace kinegraph {
namespace {

void raise(double& largest, double value) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
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
            raise(largest(QuantityKind::force), length(applied.force));
            raise(largest(QuantityKind::moment), applied.couple.to_double());
        }
    if (solution.virtual_work)
        for (const VirtualWork::Entry& entry : solution.virtual_work->entries)
            raise(largest(QuantityKind::power), entry.power.to_double());
    take_what_is_given();
    tie_together(solution.pose.size.to_double());
}

void Magnitudes::take(const Quantity& quantity, double value) {
    const ResultKind& row = result_kind(quantity);
    if (row.scale != ResultKind::Scale::unit) return;
    raise(largest(row.unit), value);
}

void Magnitudes::take_what_is_given() {
    const auto drive = [&](const auto& given) {
        if constexpr (requires { given.omega; }) {
            raise(largest(QuantityKind::angular_velocity), given.omega.to_double());
            raise(largest(QuantityKind::angular_acceleration), given.alpha.to_double());
        } else {
            raise(largest(QuantityKind::velocity), given.speed.to_double());
            raise(largest(QuantityKind::acceleration), given.acceleration.to_double());
        }
    };
    for (const Driver& driver : mechanism_.drivers) std::visit(drive, driver);
    for (const Load& load : mechanism_.loads) {
        if (const auto* force = std::get_if<ForceLoad>(&load))
            raise(largest(QuantityKind::force),
                  force->value ? length(*force->value) : force->magnitude->first.to_double());
        if (const auto* couple = std::get_if<CoupleLoad>(&load))
            raise(largest(QuantityKind::moment), couple->value.to_double());
        if (const auto* spring = std::get_if<SpringLoad>(&load))
            raise(largest(QuantityKind::force), pull_of(*spring, pose_).to_double());
        if (const auto* distributed = std::get_if<DistributedLoad>(&load))
            raise(largest(QuantityKind::force), force_of(*distributed, pose_).to_double());
        if (const auto* torsion = std::get_if<TorsionLoad>(&load))
            raise(largest(QuantityKind::moment), couple_of(*torsion).to_double());
    }
    for (const Mass& mass : mechanism_.masses)
        if (mechanism_.gravity)
            raise(largest(QuantityKind::force), mass.mass.to_double() * length(*mechanism_.gravity));
}

void Magnitudes::tie_together(double size) {
    raise(largest(QuantityKind::length), size);
    if (!(size > 0)) return;
    const auto share = [&](QuantityKind scale) {
        for (std::size_t i = 0; i < count_of_quantity_kinds; ++i) {
            const auto unit = static_cast<QuantityKind>(i);
            const Tolerance& tolerance = tolerance_of(unit);
            if (unit == scale || tolerance.scale != scale) continue;
            raise(largest(unit), tolerance.across(largest(scale), size));
            raise(largest(scale), tolerance.back(largest(unit), size));
        }
    };
    share(QuantityKind::velocity);
    const double omega = largest(QuantityKind::angular_velocity);
    raise(largest(QuantityKind::acceleration), omega * omega * size);
    share(QuantityKind::acceleration);
    share(QuantityKind::force);
    raise(largest(QuantityKind::power), largest(QuantityKind::force) * largest(QuantityKind::velocity));
}

double Magnitudes::of(const Quantity& quantity) const {
    return largest_.at(static_cast<std::size_t>(unit_kind_of(quantity, mechanism_)));
}

bool Magnitudes::is_noise(const Quantity& quantity, double value) const {
    return std::abs(value) <= noise * of(quantity);
}

}  // namespace kinegraph
