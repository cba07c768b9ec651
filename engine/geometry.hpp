// Projective points and lines over exact rationals. Finite geometry is CGAL's (in geometry.cpp, the only file that sees it);
// the thin layer of points and lines at infinity, which CGAL has not, is ours.
#pragma once

#include "engine/exact.hpp"

namespace kinegraph {

/// A projective point: finite (w = 1) or at infinity (w = 0, then (x, y) is its direction).
struct ProjectivePoint {
    Exact x, y, w = 1;
    bool at_infinity() const { return w.is_zero(); }
    Vector place() const { return {x, y}; }
};

/// a x + b y + c w = 0; the line at infinity is (0, 0, 1).
struct ProjectiveLine {
    Exact a, b, c;
    bool at_infinity() const { return a.is_zero() && b.is_zero(); }
    Vector direction() const { return {-b, a}; }
};

/// The line through a place along a direction ≠ 0, or the line at infinity through a point at infinity.
ProjectiveLine line_through(const ProjectivePoint& point, const Vector& direction);
/// The join of two points that differ.
ProjectiveLine line_joining(const ProjectivePoint& p, const ProjectivePoint& q);
/// The finite meet of two lines that are not parallel.
ProjectivePoint finite_meet(const ProjectiveLine& l, const ProjectiveLine& m);
/// The point at infinity of a finite line.
ProjectivePoint point_at_infinity_of(const ProjectiveLine& l);
/// True where the point is exactly on the line (projective incidence).
bool incident(const ProjectivePoint& p, const ProjectiveLine& l);

}  // namespace kinegraph
