#include "engine/mechanism/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

/// The kind of a number in the file, which decides its error and when it is exact by its form.
enum class Measure : std::uint8_t {
    length,
    angle,   ///< in degrees or radians
    number,  ///< a ratio, a component of a direction
    other    ///< in a unit: a velocity, a force …
};

/// Visits every number of the mechanism on which geometry, motion or forces depend, in the order of the file's
/// sections: see(number, measure, unit). A number that only chooses (`near`) is no datum.
template <class See>
class Numbers {
public:
    Numbers(Mechanism& mechanism, See see) : units_(mechanism.units), see_(see) {
        for (NamedPoint& point : mechanism.points)
            std::visit([&](auto& placement) { visit(placement); }, point.placement);
        for (Body& body : mechanism.bodies)
            if (body.circle) visit_length(body.circle->radius);
        for (Joint& joint : mechanism.joints) visit(joint);
        for (Driver& driver : mechanism.drivers) std::visit([&](auto& form) { visit(form); }, driver);
        for (Mass& mass : mechanism.masses) {
            see_(mass.mass, Measure::other, units_.mass.si);
            see_(mass.inertia, Measure::other, units_.inertia.si);
        }
        if (mechanism.gravity) visit(*mechanism.gravity, Measure::other, units_.acceleration);
        for (Load& load : mechanism.loads) std::visit([&](auto& form) { visit(form); }, load);
        for (Effort& effort : mechanism.efforts)
            if (auto* force = std::get_if<ForceEffort>(&effort)) visit(force->along);
        if (!mechanism.motion) return;
        for (GivenMotion& given : mechanism.motion->velocities) visit(given, units_.velocity);
        for (GivenMotion& given : mechanism.motion->accelerations) visit(given, units_.acceleration);
    }

private:
    void visit_length(Exact& value) { see_(value, Measure::length, units_.length.si); }
    void visit_length(Vector& place) {
        visit_length(place.x);
        visit_length(place.y);
    }
    void visit(Angle& angle) { see_(angle.value, Measure::angle, angle.in_degrees ? Exact(1) : Exact(0)); }
    void visit(Vector& vector, Measure measure, const Unit& unit) {
        see_(vector.x, measure, unit.si);
        see_(vector.y, measure, unit.si);
    }
    void visit(Bearing& bearing) {
        if (auto* angle = std::get_if<Angle>(&bearing.form)) visit(*angle);
        if (auto* vector = std::get_if<Vector>(&bearing.form)) visit(*vector, Measure::number, {"", 1});
    }
    void visit(Coordinates& placement) { visit_length(placement.at); }
    void visit(Polar& placement) {
        visit_length(placement.distance);
        visit(placement.angle);
    }
    void visit(Along& placement) {
        if (placement.is_ratio) return see_(placement.amount, Measure::number, Exact(1));
        visit_length(placement.amount);
    }
    void visit(Place& place) {
        if (auto* at = std::get_if<Vector>(&place)) visit_length(*at);
    }
    void visit(Curve& curve) {
        if (auto* circle = std::get_if<CircleCurve>(&curve)) {
            visit(circle->centre);
            visit_length(circle->radius);
            return;
        }
        auto& line = std::get<LineCurve>(curve);
        visit(line.through);
        visit(line.angle);
        visit(line.bearing);
    }
    void visit(Meet& placement) {
        visit(placement.first);
        visit(placement.second);
    }
    void visit(Joint& joint) {
        if (joint.along) visit(*joint.along);
        for (auto& each : joint.profiles)
            if (auto* line = std::get_if<LineProfile>(&each.second)) visit(line->along);
        if (joint.tangent) visit(*joint.tangent);
        if (joint.pressure_angle) visit(*joint.pressure_angle);
        if (joint.pushes) visit(*joint.pushes, Measure::number, {"", 1});
    }
    void visit(SpinDriver& driver) {
        see_(driver.omega, Measure::other, units_.angular_velocity.si);
        see_(driver.alpha, Measure::other, Exact(1));
    }
    void visit(SlideDriver& driver) {
        see_(driver.speed, Measure::other, units_.velocity.si);
        see_(driver.acceleration, Measure::other, units_.acceleration.si);
    }
    void visit(PointDriver& driver) {
        visit(driver.along);
        see_(driver.speed, Measure::other, units_.velocity.si);
        see_(driver.acceleration, Measure::other, units_.acceleration.si);
    }
    void visit(ForceLoad& load) {
        if (load.value) visit(*load.value, Measure::other, units_.force);
        if (!load.magnitude) return;
        see_(load.magnitude->first, Measure::other, units_.force.si);
        visit(load.magnitude->second);
    }
    void visit(CoupleLoad& load) { see_(load.value, Measure::other, units_.moment.si); }
    void visit(SpringLoad& load) {
        if (!load.elastic) return see_(load.magnitude, Measure::other, units_.force.si);
        see_(load.elastic->stiffness, Measure::other, Exact(1));
        see_(load.elastic->free_length, Measure::length, units_.length.si);
    }
    void visit(DistributedLoad& load) {
        for (Exact& intensity : load.intensity) see_(intensity, Measure::other, Exact(1));
        visit(load.along);
    }
    void visit(TorsionLoad& load) {
        see_(load.stiffness, Measure::other, Exact(1));
        see_(load.turned, Measure::other, Exact(1));
    }
    void visit(GivenMotion& given, const Unit& unit) {
        if (auto* vector = std::get_if<Vector>(&given.value)) return visit(*vector, Measure::other, unit);
        visit(std::get<Bearing>(given.value));
    }

    const Units units_;
    See see_;
};
template <class See>
void for_each_number(Mechanism& mechanism, See see) {
    Numbers<See>(mechanism, see);
}

/// Significant digits of a decimal; the maximum for a number without a finite decimal expansion (π, a third).
int digits_of(const Exact& value) {
    constexpr int endless = std::numeric_limits<int>::max();
    mpz_class rest;
    const mpz_class two = 2, five = 5;
    const auto twos = mpz_remove(rest.get_mpz_t(), value.rational().get_den_mpz_t(), two.get_mpz_t());
    const auto fives = mpz_remove(rest.get_mpz_t(), rest.get_mpz_t(), five.get_mpz_t());
    if (rest != 1) return endless;
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, std::max(twos, fives));
    const Exact whole = abs(value) * Exact(mpq_class(power));
    std::string digits = whole.rational().get_num().get_str();
    digits.erase(digits.find_last_not_of('0') + 1);
    return static_cast<int>(digits.size());
}

bool is_whole(const Exact& value) { return value.rational().get_den() == 1; }

/// Spreads consecutive numbers over all 64 bits (Steele, Lea, Flood: SplitMix).
std::uint64_t scattered(std::uint64_t number) {
    number += 0x9E3779B97F4A7C15U;
    number = (number ^ (number >> 30U)) * 0xBF58476D1CE4E5B9U;
    number = (number ^ (number >> 27U)) * 0x94D049BB133111EBU;
    return number ^ (number >> 31U);
}
/// A factor from ½ to 1, of either sign; its denominator is a prime, so that shifted decimals never coincide with
/// others.
Exact part_of_precision(std::uint64_t number, int sample) {
    constexpr std::int64_t parts = 257, least = 129;
    const std::uint64_t bits = scattered(number * shifted_drawings + static_cast<std::uint64_t>(sample));
    const std::int64_t part = least + static_cast<std::int64_t>(bits % (parts - least));
    return Exact::ratio((bits >> 32U) % 2 == 0 ? part : -part, parts);
}

}  // namespace

Exact inferred_share() { return Exact::ratio(1, 1000000000000); }

bool looks_rounded(const Mechanism& mechanism) {
    if (mechanism.precision) return false;
    bool found = false;
    Mechanism copy = mechanism;
    const auto is_computed = [&](const Exact& length) {
        return std::binary_search(mechanism.computed.begin(), mechanism.computed.end(), length);
    };
    for_each_number(copy, [&](const Exact& value, Measure measure, const Exact& unit) {
        found = found ||
                (measure == Measure::length && digits_of(value / unit) >= digits_of_a_program && !is_computed(value));
    });
    return found;
}

Mechanism shifted(const Mechanism& mechanism, const Exact& length, const Exact& share, int sample) {
    Mechanism moved = mechanism;
    moved.precision = length;
    const int digits = static_cast<int>(-nearest::log10(share.to_double()));
    std::uint64_t number = 0;
    for_each_number(moved, [&](Exact& value, Measure measure, const Exact& unit) {
        ++number;
        if (value.is_zero()) return;
        const Exact part = part_of_precision(number, sample);
        if (measure == Measure::length) {
            if (!is_whole(value / unit) || 2 * length >= unit) value += part * length;
            return;
        }
        const bool in_radians = measure == Measure::angle && unit.is_zero();
        if (digits_of(unit.is_zero() ? value : value / unit) < digits - 1) return;
        const Exact half_turn = in_radians ? pi() : Exact(180);
        value += part * share * (measure == Measure::angle ? half_turn / pi() : value);
    });
    return moved;
}

bool is_zero_within(const Vector& value, std::span<const Vector> shifted) {
    Exact spread;
    for (const Vector& each : shifted) spread = std::max(spread, squared_length(each - value));
    return squared_length(value) <= 16 * spread;
}

int bits_in_question(double share) { return std::max(1, static_cast<int>(-std::log2(share) / 3)); }

}  // namespace kinegraph
