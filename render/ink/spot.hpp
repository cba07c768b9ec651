// Spots (2D points) and boxes of a drawing, mm, y downwards, with their vector algebra.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/number/functions.hpp"

namespace kinegraph::render {

/// A point or a vector on the sheet, mm.
struct Spot {
    double x = 0;
    double y = 0;
    bool operator==(const Spot&) const = default;
};

inline Spot operator+(Spot a, Spot b) { return {a.x + b.x, a.y + b.y}; }
inline Spot operator-(Spot a, Spot b) { return {a.x - b.x, a.y - b.y}; }
inline Spot operator*(double s, Spot a) { return {s * a.x, s * a.y}; }
inline double dot(Spot a, Spot b) { return a.x * b.x + a.y * b.y; }
inline double cross(Spot a, Spot b) { return a.x * b.y - a.y * b.x; }
/// sqrt is correctly rounded on every machine; std::hypot is not.
inline double length(Spot a) { return std::sqrt(a.x * a.x + a.y * a.y); }
/// a / |a|; (1, 0) for the zero vector.
inline Spot unit(Spot a) {
    const double l = length(a);
    return l > 0 ? Spot{a.x / l, a.y / l} : Spot{1, 0};
}
/// A quarter turn clockwise on paper.
inline Spot turned(Spot a) { return {-a.y, a.x}; }
/// From a spot to the nearest place between two others.
inline double distance_to_segment(Spot spot, Spot from, Spot to) {
    const Spot along = to - from;
    const double whole = dot(along, along);
    const double share = whole > 0 ? std::clamp(dot(spot - from, along) / whole, 0.0, 1.0) : 0;
    return length(spot - from - share * along);
}
/// polar_spot: the unit vector at an angle (radians, clockwise on paper). angle_of: its inverse, in (−π, π].
inline Spot polar_spot(double angle) { return {nearest::cos(angle), nearest::sin(angle)}; }
inline double angle_of(Spot a) { return nearest::atan2(a.y, a.x); }

struct Box {
    Spot min, max;
    double width() const { return max.x - min.x; }
    double height() const { return max.y - min.y; }
    Spot middle() const { return {0.5 * (min.x + max.x), 0.5 * (min.y + max.y)}; }
    /// Grows to include the argument.
    void include(const Box& other) {
        min = {std::min(min.x, other.min.x), std::min(min.y, other.min.y)};
        max = {std::max(max.x, other.max.x), std::max(max.y, other.max.y)};
    }
    void include(Spot spot) { include(Box{spot, spot}); }
    bool operator==(const Box&) const = default;
};
inline Box rectangle(double left, double top, double right, double bottom) { return {{left, top}, {right, bottom}}; }

}  // namespace kinegraph::render
