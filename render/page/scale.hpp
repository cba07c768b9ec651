// Scales: the round numbers that drawings use. Independent of any drawing.
#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace kinegraph::render {

/// mantissa · 10^exponent, as the double nearest to that decimal (repeated products would not give 1/1000 for 10^-3).
double decimal(double mantissa, int exponent);

/// The smallest number of units per mm, of the series 1-2-2.5-5 × 10ⁿ, at which `extent` units fit into `room` mm. If
/// the file gives a scale (`asked`), that one.
double choose_scale(double extent_x, double extent_y, double room_x, double room_y, std::optional<double> asked);
/// The next coarser scale of the series.
inline double next_scale(double scale) { return choose_scale(1.001 * scale, 0, 1, 1, std::nullopt); }
/// The next finer one: no two neighbours of the series differ by more than a factor of 2.
inline double finer_scale(double scale) { return choose_scale(0.5 * scale, 0, 1, 1, std::nullopt); }
/// The coarsest scale of the series at which `extent` units are at least `least` mm.
inline double scale_that_shows(double extent, double least) {
    const double scale = choose_scale(extent, 0, least, 1, std::nullopt);
    return extent / scale < least * (1 - 1e-12) ? finer_scale(scale) : scale;
}

/// The scales of a finer series, 1-1.25-1.5-2-2.5-3-4-5-6-8 × 10ⁿ, from `finest` to below `coarsest`, the finest first.
std::vector<double> scales_between(double finest, double coarsest);

/// Marks an empty figure. Drawing functions that take a `coarsest` scale (units per mm) return an empty figure at
/// any_scale if the drawing would have to be coarser or would exceed its room.
constexpr double any_scale = std::numeric_limits<double>::infinity();

}  // namespace kinegraph::render
