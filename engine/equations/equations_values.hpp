// The derivatives of closure equations, in symbols, and their values: the second half of
// engine/equations/equations.cpp.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "engine/equations/equations.hpp"

namespace kinegraph {

/// Fills in the rows of equations that have their letters, loops and laws, and evaluates them; `rates` by letter: first
/// and second time derivative of the free letters.
void complete(Equations& equations, const Mechanism& mechanism, const Pose& pose,
              const std::vector<std::pair<Exact, Exact>>& rates);

/// First and second time derivative of a side's vector (m/s, m/s²), as far as its letters' rates are known.
std::pair<std::optional<std::array<double, 2>>, std::optional<std::array<double, 2>>> change_of(
    const Equations& equations, const Equations::Side& side);

/// The vector of a side as drawn, m.
std::array<double, 2> value_of(const Equations& equations, const Equations::Side& side);
double value_of(const Equations& equations, const Equations::Angle& angle);
/// The value of a sum in the drawn position, with the computed rates.
double value_of(const Equations& equations, const Equations::Sum& sum);

}  // namespace kinegraph
