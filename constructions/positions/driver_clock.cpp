#include "constructions/positions/driver_clock.hpp"

#include <cmath>
#include <utility>

#include "engine/mechanism/drivers.hpp"

namespace kinegraph {
namespace {

/// The driver's rate if it can serve as a clock; else zero.
double rate_along(const Mechanism& mechanism, const Course& course) {
    const auto rates = [&](int driver) { return rates_of(mechanism.drivers[at_index(driver)]); };
    const Rates own = rates(course.driver);
    for (const Course::Along& each : course.along) {
        const double along = each.per.to_double() * own.first.to_double();
        if (std::abs(rates(each.driver).first.to_double() - along) > 1e-9 * std::abs(along)) return 0;
    }
    return own.second.is_zero() ? own.first.to_double() : 0;
}

}  // namespace

DriverClock::DriverClock(const Mechanism& mechanism, const Course& course)
    : driver_(at_index(course.driver)), law_(law_of(mechanism.drivers[driver_])), rate_(rate_along(mechanism, course)) {
    if (law_ == nullptr) return;
    curve_ = LawCurve(*law_);
    drawn_ = {law_->drawn.to_double(), curve_.at(law_->drawn.to_double()).s};
}

double DriverClock::go_to(double at) {
    if (law_ == nullptr) return at;
    state_ = curve_.at(drawn_.first + at);
    time_ = at;
    return state_.s - drawn_.second;
}

void DriverClock::put_rates(Mechanism& moved) const {
    if (law_ == nullptr) return;
    Driver& driver = moved.drivers[driver_];
    driver = with_rates(std::move(driver), {Exact::from_double(state_.first), Exact::from_double(state_.second)});
}

}  // namespace kinegraph
