// Drivers: what a given motion is apart from its form: its rates, its law, whether it turns.
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

/// Null: its rates are those of the file wherever it is.
const Law* law_of(const Driver& driver);
/// The rates of a driver with a law, so far (rad or m) from the drawn position, when the law first comes there. Error:
/// how far it goes, from the drawn position: the least and the greatest coordinate.
tl::expected<Rates, std::pair<double, double>> rates_at(const Law& law, double coordinate);

/// Its coordinate is an angle.
bool turns(const Driver& driver);

}  // namespace kinegraph
