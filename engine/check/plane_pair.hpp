// Plane vectors of the checks, as pairs of doubles with their own arithmetic. The checks share only the places of the
// pose with the constructions.
#pragma once

#include <array>

#include "engine/drawing/pose.hpp"

namespace kinegraph::numeric {

using Pair = std::array<double, 2>;

inline double inner(const Pair& a, const Pair& b) { return a[0] * b[0] + a[1] * b[1]; }
/// The component along z of a × b.
inline double outer(const Pair& a, const Pair& b) { return a[0] * b[1] - a[1] * b[0]; }
inline Pair operator*(double s, const Pair& a) { return {s * a[0], s * a[1]}; }
inline Pair operator+(const Pair& a, const Pair& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline Pair operator-(const Pair& a, const Pair& b) { return {a[0] - b[0], a[1] - b[1]}; }
/// z × a: turned by 90° counter-clockwise.
inline Pair quarter(const Pair& a) { return {-a[1], a[0]}; }

/// The nearest doubles.
inline Pair rough(const Vector& a) { return {a.x.to_double(), a.y.to_double()}; }
/// Unit vector along a direction ≠ 0, to the precision of the pose.
inline Pair unit_along(const Vector& direction, const Pose& pose) { return rough(unit_along(direction, pose.bits)); }

}  // namespace kinegraph::numeric
