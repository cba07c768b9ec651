// Drivers: properties that every kind of driver has: its rates, its law, whether its coordinate is an angle.
#pragma once

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// rad/s or m/s, rad/s² or m/s².
struct Rates {
    Exact first, second;
};
Rates rates_of(const Driver& driver);
/// The driver with other rates.
Driver with_rates(Driver driver, const Rates& rates);
const std::string& where_of(const Driver& driver);

/// Null: its rates are those of the file in every position.
const Law* law_of(const Driver& driver);
/// The rates of a driver with a law at the given displacement (rad or m) from the drawn position, when the law first
/// reaches it. Error: the range of the law, from the drawn position: the least and the greatest coordinate.
tl::expected<Rates, std::pair<double, double>> rates_at(const Law& law, double coordinate);

/// Whether its coordinate is an angle.
bool turns(const Driver& driver);

}  // namespace kinegraph
