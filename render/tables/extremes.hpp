// Extremes of a cycle: minimum, maximum and zeros of a column: those found by following it, else interpolated between
// the rows. Independent of drawing.
#pragma once

#include <utility>
#include <vector>

#include "engine/sentences/column.hpp"

namespace kinegraph::render {

/// A value of a column, SI, and its position: the driver's coordinate, or the time if the driver has a law.
struct Extreme {
    double at = 0, value = 0;
};

/// The column followed between its rows; null if it was not.
const FollowedColumn* followed_of(const CycleTable& table, std::size_t column);
/// Whether the column has no minimum, or no maximum: it grows without limit.
bool is_unbounded(const CycleTable& table, std::size_t column, bool below);

/// Minimum and maximum; of a column without limit those of its rows. Each is refined by the parabola through three rows
/// if the neighbouring second differences are similar (so not at a jump). At a limit position the value there is used.
/// Zeros for an empty table.
std::pair<Extreme, Extreme> extremes_of(const CycleTable& table, std::size_t column);
/// The same for any values, one per row.
std::pair<Extreme, Extreme> extremes_of(const CycleTable& table, const std::vector<double>& values);

/// Whether an extreme is that of a row beside positions without one: what there is towards them is not known.
bool is_beside_gap(const CycleTable& table, const Extreme& extreme);

/// Positions of its zeros, in the order of the rows; not intervals on which it stays zero.
std::vector<double> zeros_of(const CycleTable& table, std::size_t column);

/// Rounding level of a column: values up to 1e-9 of the largest value of all columns with its unit count as zero.
double rounding_of(const CycleTable& table, std::size_t column);
/// Whether the column varies by no more than rounding.
bool is_constant(const CycleTable& table, std::size_t column);

}  // namespace kinegraph::render
