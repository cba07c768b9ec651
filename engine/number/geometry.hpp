// Projective points and lines over any number. Over exact rationals lines and incidence are CGAL's (in geometry.cpp,
// the only file that sees it); the meet, which CGAL brings to lowest terms at each step, and the thin layer of points
// and lines at infinity, which CGAL has not, are ours. Over doubles, for replays, the same formulas stand here.
#pragma once

#include "engine/number/exact.hpp"

namespace kinegraph {

/// A projective point: finite (w = 1) or at infinity (w = 0, then (x, y) is its direction).
template <class Number>
struct PointOf {
    Number x{}, y{}, w = 1;
    bool at_infinity() const { return is_zero(w); }
    VectorOf<Number> place() const { return {x, y}; }
    /// Of finite points: the vector from the second to the first.
    friend VectorOf<Number> operator-(const PointOf& to, const PointOf& from) { return {to.x - from.x, to.y - from.y}; }
};
using ProjectivePoint = PointOf<Exact>;
/// Of finite points.
inline double distance(const ProjectivePoint& p, const ProjectivePoint& q) { return distance(p.x, p.y, q.x, q.y); }

/// a x + b y + c w = 0; the line at infinity is (0, 0, 1).
template <class Number>
struct LineOf {
    Number a{}, b{}, c{};
    bool at_infinity() const { return is_zero(a) && is_zero(b); }
    VectorOf<Number> direction() const { return {-b, a}; }
};
using ProjectiveLine = LineOf<Exact>;

/// The finite line through a finite place along a direction ≠ 0.
ProjectiveLine finite_line_through(const ProjectivePoint& point, const Vector& direction);
/// The join of two finite places that differ.
ProjectiveLine finite_join(const ProjectivePoint& p, const ProjectivePoint& q);
/// The finite meet of two finite lines that are not parallel.
ProjectivePoint finite_meet(const ProjectiveLine& l, const ProjectiveLine& m);
/// True where the point is exactly on the line (projective incidence).
bool incident(const ProjectivePoint& p, const ProjectiveLine& l);

inline LineOf<double> finite_line_through(const PointOf<double>& point, const VectorOf<double>& direction) {
    return {-direction.y, direction.x, direction.y * point.x - direction.x * point.y};
}
inline LineOf<double> finite_join(const PointOf<double>& p, const PointOf<double>& q) {
    return finite_line_through(p, q.place() - p.place());
}
inline PointOf<double> finite_meet(const LineOf<double>& l, const LineOf<double>& m) {
    const double w = l.a * m.b - l.b * m.a;
    return {(l.b * m.c - l.c * m.b) / w, (l.c * m.a - l.a * m.c) / w, 1};
}

/// The line through a place along a direction ≠ 0, or the line at infinity through a point at infinity.
template <class Number>
LineOf<Number> line_through(const PointOf<Number>& point, const VectorOf<Number>& direction) {
    if (point.at_infinity()) return {0, 0, 1};
    return finite_line_through(point, direction);
}
/// The join of two points that differ.
template <class Number>
LineOf<Number> line_joining(const PointOf<Number>& p, const PointOf<Number>& q) {
    if (p.at_infinity() && q.at_infinity()) return {0, 0, 1};
    if (p.at_infinity()) return line_through(q, p.place());
    if (q.at_infinity()) return line_through(p, q.place());
    return finite_join(p, q);
}
/// The point at infinity of a finite line.
template <class Number>
PointOf<Number> point_at_infinity_of(const LineOf<Number>& l) {
    return {-l.b, l.a, 0};
}

}  // namespace kinegraph
