#include "constructions/positions/noise_levels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "engine/mechanism/drivers.hpp"
#include "engine/number/functions.hpp"
#include "engine/sentences/result_catalogue.hpp"

namespace kinegraph {
namespace {

double length_of_vector(const Vector& v) { return nearest::hypot(v.x.to_double(), v.y.to_double()); }

/// The largest rates of a driver along its law, if it has one.
std::pair<double, double> largest_rates(const Driver& driver) {
    const Rates rates = rates_of(driver);
    std::pair most{std::abs(rates.first.to_double()), std::abs(rates.second.to_double())};
    const Law* law = law_of(driver);
    constexpr int samples = 64;
    for (int i = 0; law != nullptr && i < samples; ++i) {
        const LawState state = law->at(law->length() * (i + 0.5) / samples);
        most = {std::max(most.first, std::abs(state.first)), std::max(most.second, std::abs(state.second))};
    }
    return most;
}

}  // namespace

NoiseLevels::NoiseLevels(const Mechanism& mechanism, const Pose& pose) : size_(pose.size.to_double()) {
    for (const Driver& driver : mechanism.drivers) {
        const auto [first, second] = largest_rates(driver);
        const double reach = turns(driver) ? size_ : 1;
        usual_.velocity = std::max(usual_.velocity, first * reach);
        usual_.acceleration = std::max(usual_.acceleration, second * reach);
    }
    usual_.acceleration = std::max(usual_.acceleration, usual_.velocity * usual_.velocity / size_);
    for (const Load& load : mechanism.loads) add_load(load);
    for (const Mass& mass : mechanism.masses) {
        const double of_motion = mechanism.inertia_forces
                                     ? mass.mass.to_double() * usual_.acceleration +
                                           mass.inertia.to_double() * usual_.acceleration / (size_ * size_)
                                     : 0;
        const double weight = mechanism.gravity ? mass.mass.to_double() * length_of_vector(*mechanism.gravity) : 0;
        usual_.force = std::max(usual_.force, of_motion + weight);
    }
}

void NoiseLevels::add_load(const Load& load) {
    double force = 0;
    if (const auto* point = std::get_if<ForceLoad>(&load))
        force = point->value ? length_of_vector(*point->value) : std::abs(point->magnitude->first.to_double());
    else if (const auto* couple = std::get_if<CoupleLoad>(&load))
        force = std::abs(couple->value.to_double()) / size_;
    else if (const auto* spring = std::get_if<SpringLoad>(&load))
        force = spring->elastic
                    ? spring->elastic->stiffness.to_double() * std::max(size_, spring->elastic->free_length.to_double())
                    : std::abs(spring->magnitude.to_double());
    else if (const auto* distributed = std::get_if<DistributedLoad>(&load))
        force = size_ * std::max(std::abs(distributed->intensity[0].to_double()),
                                 std::abs(distributed->intensity[1].to_double()));
    else if (const auto* torsion = std::get_if<TorsionLoad>(&load))
        force = torsion->stiffness.to_double() * std::max(2 * std::numbers::pi, std::abs(torsion->turned.to_double())) /
                size_;
    usual_.force = std::max(usual_.force, force);
}

double NoiseLevels::Sizes::*NoiseLevels::Sizes::of(QuantityKind scale) {
    switch (scale) {
        case QuantityKind::velocity: return &Sizes::velocity;
        case QuantityKind::acceleration: return &Sizes::acceleration;
        case QuantityKind::force: return &Sizes::force;
        default: return nullptr;
    }
}

NoiseLevels::Sizes NoiseLevels::sizes_in(const std::vector<Column>& columns, const std::vector<double>& row) const {
    Sizes sizes = usual_;
    for (std::size_t i = 0; i < std::min(columns.size(), row.size()); ++i) {
        const Tolerance& tolerance = tolerance_of(columns[i].unit);
        if (double Sizes::*const size = Sizes::of(tolerance.scale))
            sizes.*size = std::max(sizes.*size, tolerance.back(std::abs(row[i]), size_));
    }
    return sizes;
}

std::vector<double> NoiseLevels::of_row(const std::vector<Column>& columns, const std::vector<double>& row) const {
    const Sizes sizes = sizes_in(columns, row);
    std::vector<double> levels;
    for (const Column& column : columns) levels.push_back(level(column, sizes));
    return levels;
}

double NoiseLevels::of_forces(const std::vector<Column>& columns, const std::vector<double>& row) const {
    Column force;
    force.kind = Column::Kind::result;
    force.unit = QuantityKind::force;
    return level(force, sizes_in(columns, row));
}

double NoiseLevels::level(const Column& column, const Sizes& sizes) const {
    constexpr double share = 0x1p-40;
    switch (column.kind) {
        case Column::Kind::turn:
        case Column::Kind::time:
        case Column::Kind::named:
        case Column::Kind::parameter: return 0;
        case Column::Kind::angle: return share;
        case Column::Kind::place_x:
        case Column::Kind::place_y:
        case Column::Kind::slid: return share * size_;
        case Column::Kind::result:
        case Column::Kind::along: break;
    }
    const Tolerance& tolerance = tolerance_of(column.unit);
    if (double Sizes::*const size = Sizes::of(tolerance.scale)) return share * tolerance.across(sizes.*size, size_);
    switch (column.unit) {
        case QuantityKind::power: return share * sizes.force * sizes.velocity;
        case QuantityKind::angle: return share;
        case QuantityKind::length: return share * size_;
        default: return 0;
    }
}

}  // namespace kinegraph
