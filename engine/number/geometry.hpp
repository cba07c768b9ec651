// Points and lines of the projective plane over any number type.
//
// Over exact rationals, the constructions (which make points, lines and numbers) and predicates (which decide) on
// finite points and lines use CGAL, in geometry.cpp, the only file that includes it. CGAL's Cartesian kernel over
// rationals does everything but the meet, which uses the homogeneous kernel over integers: the Cartesian one reduces
// every product and difference to lowest terms. With it the 66 instant centres of twelve bodies take 1.35 times the
// instructions of hand-written formulas, with the homogeneous one 1.13 times (a four-bar and Jansen's leg 1.02 times,
// the exam of 2001 1.07 times). The products of vectors (`dot`, `cross` of exact.hpp) use CGAL too, so that one formula
// decides all sides.
//
// Points and lines at infinity, which CGAL's Cartesian kernel lacks, are a thin layer at the end of this header. The
// same formulas over doubles, for replays, are here. The tests check the laws below, and doubles against CGAL
// (tests/engine/geometry_test.cpp).
//
// A line with coefficients (a, b, c) and one with (k a, k b, k c), k ≠ 0, are the same line; with k > 0 also the same
// oriented line, written l ~ m. Every precondition is asserted.
#pragma once

#include "engine/number/exact.hpp"

namespace kinegraph {

/// A projective point: finite (w = 1) or at infinity (w = 0, then (x, y) ≠ 0 is its direction).
template <class Number>
struct PointOf {
    Number x{}, y{}, w = 1;
    bool at_infinity() const { return is_zero(w); }
    /// Coordinates of a finite point; the direction of one at infinity.
    VectorOf<Number> place() const { return {x, y}; }
    /// Of finite points: the vector from the second to the first.
    friend VectorOf<Number> operator-(const PointOf& to, const PointOf& from) { return {to.x - from.x, to.y - from.y}; }
};
using ProjectivePoint = PointOf<Exact>;

/// The points with a x + b y + c w = 0; the line at infinity is (0, 0, 1).
template <class Number>
struct LineOf {
    Number a{}, b{}, c{};
    bool at_infinity() const { return is_zero(a) && is_zero(b); }
    /// Along a finite line, with its positive side (a x + b y + c > 0) on the right.
    VectorOf<Number> direction() const { return {-b, a}; }
};
using ProjectiveLine = LineOf<Exact>;

/// The finite point with these coordinates.
template <class Number>
PointOf<Number> point_at(const VectorOf<Number>& place) {
    return {place.x, place.y, 1};
}

// --- finite points and lines: constructions --------------------------------------------------------------------------

/// The line through a finite point p along d ≠ 0: (−d_y, d_x, c), where positive is the left of d.
///   offset(p, l) = 0,  l.direction() = −d,  line(p, k d) = k line(p, d) for k ≠ 0,  line(p + k d, d) = line(p, d)
ProjectiveLine finite_line_through(const ProjectivePoint& p, const Vector& d);

/// The line of two finite points that differ; positive is the left of p → q. Where its direction is parallel to an
/// axis, that coefficient is ±1.
///   join(p, q) = −join(q, p) ~ line(p, q − p),  offset(p, join(p, q)) = offset(q, join(p, q)) = 0
ProjectiveLine finite_join(const ProjectivePoint& p, const ProjectivePoint& q);

/// The point common to two finite lines that are not parallel.
///   meet(l, m) = meet(m, l) = meet(j l, k m) for j, k ≠ 0,  offset(meet(l, m), l) = offset(meet(l, m), m) = 0,
///   meet(join(p, q), join(p, r)) = p where p, q, r are not collinear
ProjectivePoint finite_meet(const ProjectiveLine& l, const ProjectiveLine& m);

/// The foot of the perpendicular from a place to a finite line.
///   offset(foot, l) = 0,  (p − foot) · l.direction() = 0,  foot(foot(p, l), l) = foot(p, l),  foot(p, k l) = foot(p,
///   l)
Vector foot_of_perpendicular(const Vector& p, const ProjectiveLine& l);

/// |p − q|²; |p − foot of the perpendicular|² for a finite line.
///   squared_distance(p, q) = squared_distance(q, p) ≥ 0, and 0 only where p = q
///   squared_distance(p, l) = squared_distance(p, k l) = offset(p, l)²/(a² + b²), and 0 only where p lies on l
Exact squared_distance(const Vector& p, const Vector& q);
Exact squared_distance(const Vector& p, const ProjectiveLine& l);

/// a x + b y + c of a finite point and a finite line: its signed distance times √(a² + b²), positive on the left of
/// p → q where the line is join(p, q); then it is cross(q − p, point − p) up to a positive factor.
///   offset(p, k l) = k offset(p, l)
template <class Number>
Number offset(const PointOf<Number>& p, const LineOf<Number>& l) {
    return Number(sum_of_products(l.a, p.x, l.b, p.y) + l.c);
}

/// The double nearest to √squared_distance(p, q), finite points. (CGAL only gives the square, and reducing it to lowest
/// terms would be wasted work.)
inline double distance(const ProjectivePoint& p, const ProjectivePoint& q) { return distance(p.x, p.y, q.x, q.y); }
/// √squared_distance(p, l) in double precision, for printing and drawing only; distances from 1e-150 to 1e150.
double distance(const Vector& p, const ProjectiveLine& l);

// --- finite points and lines: predicates -----------------------------------------------------------------------------

/// Whether p lies on l, also at infinity: a x + b y + c w = 0. All points at infinity lie on the line at infinity.
bool incident(const ProjectivePoint& p, const ProjectiveLine& l);
/// Whether one line passes through three places; true where two of them coincide. The order does not matter.
bool collinear(const Vector& p, const Vector& q, const Vector& r);
/// Whether the angle p q r is obtuse (180° included); of collinear places, whether q lies between p and r and is
/// neither. Symmetric in p and r.
bool is_between(const Vector& p, const Vector& q, const Vector& r);

// --- the same over doubles -------------------------------------------------------------------------------------------

inline LineOf<double> finite_line_through(const PointOf<double>& p, const VectorOf<double>& d) {
    return {-d.y, d.x, d.y * p.x - d.x * p.y};
}
/// (~ the exact one, whose coefficient is ±1 where the direction is parallel to an axis.)
inline LineOf<double> finite_join(const PointOf<double>& p, const PointOf<double>& q) {
    return finite_line_through(p, q.place() - p.place());
}
inline PointOf<double> finite_meet(const LineOf<double>& l, const LineOf<double>& m) {
    const double w = l.a * m.b - l.b * m.a;
    return {(l.b * m.c - l.c * m.b) / w, (l.c * m.a - l.a * m.c) / w, 1};
}

// --- points and lines at infinity ------------------------------------------------------------------------------------

/// The line through a point along a direction ≠ 0; through a point at infinity, whatever the direction, the line at
/// infinity.
template <class Number>
LineOf<Number> line_through(const PointOf<Number>& p, const VectorOf<Number>& d) {
    if (p.at_infinity()) return {0, 0, 1};
    return finite_line_through(p, d);
}
/// The join of two points that differ: incident with both. Of two at infinity it is the line at infinity.
template <class Number>
LineOf<Number> line_joining(const PointOf<Number>& p, const PointOf<Number>& q) {
    if (p.at_infinity() && q.at_infinity()) return {0, 0, 1};
    if (p.at_infinity()) return line_through(q, p.place());
    if (q.at_infinity()) return line_through(p, q.place());
    return finite_join(p, q);
}
/// The point at infinity of a finite line: its meet with the line at infinity and with each of its parallels.
template <class Number>
PointOf<Number> point_at_infinity_of(const LineOf<Number>& l) {
    return {-l.b, l.a, 0};
}

}  // namespace kinegraph
