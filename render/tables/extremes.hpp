// Extremes of a cycle: where a column is least, greatest and zero, between the rows as well as on them. Knows no
// drawing.
#pragma once

#include <utility>
#include <vector>

#include "engine/sentences/column.hpp"

namespace kinegraph::render {

/// A value of a column, SI, and where: the driver's coordinate, or the time where it has a law.
struct Extreme {
    double at = 0, value = 0;
};

/// The least and the greatest value; between three rows by the parabola through them, where their neighbours bend alike
/// (so not at a jump), and at the limits, where the place alone gives it. Of a table without rows: zeros.
std::pair<Extreme, Extreme> extremes_of(const CycleTable& table, std::size_t column);
/// The same of any values, one a row.
std::pair<Extreme, Extreme> extremes_of(const CycleTable& table, const std::vector<double>& values);

/// Where it passes zero, in the order of the rows; not where it stays there.
std::vector<double> zeros_of(const CycleTable& table, std::size_t column);

/// Beside what is this large a value of the column is rounding: 1e-9 of the largest of the columns of its unit.
double rounding_of(const CycleTable& table, std::size_t column);
/// It does not change, or by rounding only.
bool is_constant(const CycleTable& table, std::size_t column);

}  // namespace kinegraph::render
