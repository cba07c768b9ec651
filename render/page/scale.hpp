// Scales: the round numbers that a drawing is scaled by. Knows no drawing.
#pragma once

#include <limits>
#include <optional>

namespace kinegraph::render {

/// m · 10^exponent, the double nearest to the decimal (10^-3 is not 1/1000 by repeated products).
double decimal(double mantissa, int exponent);

/// The largest scale of 1-2-2.5-5 × 10ⁿ units per mm at which `extent` units fit into `room` mm; the file's own where
/// it asks one.
double choose_scale(double extent_x, double extent_y, double room_x, double room_y, std::optional<double> asked);
/// The next coarser one of these after any scale.
inline double next_scale(double scale) { return choose_scale(1.001 * scale, 0, 1, 1, std::nullopt); }

/// Of the figures that take a `coarsest` scale (units per mm): one that would have to be drawn coarser, or leave its
/// room, comes empty and at any_scale; whoever sets such a limit has no use for it.
constexpr double any_scale = std::numeric_limits<double>::infinity();

}  // namespace kinegraph::render
