// The derivatives of closure equations, in symbols, and their values: the second half of
// engine/equations/equations.cpp.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "engine/equations/equations.hpp"

namespace kinegraph {

/// Writes the rows of equations whose letters, loops and laws are there, and evaluates them; `rates` by letter: first
/// and second derivative in time of what is free.
void complete(Equations& equations, const Mechanism& mechanism, const Pose& pose,
              const std::vector<std::pair<Exact, Exact>>& rates);

/// First and second derivative in time of a side's vector (m/s, m/s²), as far as its letters' rates are known.
std::pair<std::optional<std::array<double, 2>>, std::optional<std::array<double, 2>>> change_of(
    const Equations& equations, const Equations::Side& side);

/// Of a side as drawn, m.
std::array<double, 2> value_of(const Equations& equations, const Equations::Side& side);
double value_of(const Equations& equations, const Equations::Angle& angle);
/// Of a sum in the drawn position, rates as found.
double value_of(const Equations& equations, const Equations::Sum& sum);

}  // namespace kinegraph
