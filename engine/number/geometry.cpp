#include "engine/number/geometry.hpp"

#include <CGAL/Intersections_2/Line_2_Line_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Simple_homogeneous.h>
#include <CGAL/constructions/kernel_ftC2.h>
#include <CGAL/mpq_class.h>
#include <CGAL/mpz_class.h>

#include <boost/variant/get.hpp>
#include <cmath>
#include <utility>
#include <variant>

#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {

using Kernel = CGAL::Simple_cartesian<mpq_class>;

// Conversions to and from the kernel: the same rationals, in lowest terms on both sides.
Kernel::Vector_2 cgal_vector(const Exact& x, const Exact& y) { return {x.rational(), y.rational()}; }
Kernel::Point_2 cgal_point(const Exact& x, const Exact& y) { return {x.rational(), y.rational()}; }
Kernel::Point_2 cgal(const ProjectivePoint& p) { return cgal_point(p.x, p.y); }
Kernel::Point_2 cgal(const Vector& place) { return cgal_point(place.x, place.y); }
Kernel::Line_2 cgal(const ProjectiveLine& l) { return {l.a.rational(), l.b.rational(), l.c.rational()}; }
Exact exact(mpq_class number) { return Exact::in_lowest_terms(std::move(number)); }

/// A line by one of the formulas that the kernel uses: `make(a, b, c)`. (A line object of the kernel would copy every
/// number.)
template <class Make>
ProjectiveLine line_of(const Make& make) {
    mpq_class a, b, c;
    make(a, b, c);
    return {exact(std::move(a)), exact(std::move(b)), exact(std::move(c))};
}

// Meets use CGAL's homogeneous kernel, with integer coefficients: the point has integer coordinates over a common
// denominator, and only the two quotients are reduced to lowest terms (measurements in the header).
using WholeKernel = CGAL::Simple_homogeneous<mpz_class>;

WholeKernel::Line_2 with_whole_coefficients(const ProjectiveLine& l) {
    const mpq_class &a = l.a.rational(), &b = l.b.rational(), &c = l.c.rational();
    const mpz_class common = lcm(lcm(a.get_den(), b.get_den()), c.get_den());
    const auto whole = [&](const mpq_class& number) { return mpz_class(common / number.get_den() * number.get_num()); };
    return {whole(a), whole(b), whole(c)};
}

/// The point in CGAL's result of an intersection, a variant: Boost's in CGAL 5, the standard library's since CGAL 6.
template <class Intersection>
const WholeKernel::Point_2* point_of(const Intersection& found) {
    if constexpr (requires { std::get_if<WholeKernel::Point_2>(&found); }) {
        return std::get_if<WholeKernel::Point_2>(&found);
    } else {
        return boost::get<WholeKernel::Point_2>(&found);
    }
}

}  // namespace

Exact sum_of_products(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
    return exact(cgal_vector(a, c) * cgal_vector(b, d));
}

Exact difference_of_products(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
    return exact(CGAL::determinant(a.rational(), d.rational(), c.rational(), b.rational()));
}

ProjectiveLine finite_line_through(const ProjectivePoint& p, const Vector& d) {
    KG_ASSERT(!p.at_infinity() && !d.is_zero(), "a line needs a finite point and a direction");
    return line_of([&](mpq_class& a, mpq_class& b, mpq_class& c) {
        CGAL::line_from_point_directionC2(p.x.rational(), p.y.rational(), d.x.rational(), d.y.rational(), a, b, c);
    });
}

ProjectiveLine finite_join(const ProjectivePoint& p, const ProjectivePoint& q) {
    KG_ASSERT(!p.at_infinity() && !q.at_infinity() && !(p.x == q.x && p.y == q.y),
              "a finite line joins two finite points that differ");
    return line_of([&](mpq_class& a, mpq_class& b, mpq_class& c) {
        CGAL::line_from_pointsC2(p.x.rational(), p.y.rational(), q.x.rational(), q.y.rational(), a, b, c);
    });
}

ProjectivePoint finite_meet(const ProjectiveLine& l, const ProjectiveLine& m) {
    const auto found = CGAL::intersection(with_whole_coefficients(l), with_whole_coefficients(m));
    const WholeKernel::Point_2* point = found ? point_of(*found) : nullptr;
    KG_ASSERT(point != nullptr, "lines that are not parallel meet in a point");
    return {Exact(mpq_class(point->hx(), point->hw())), Exact(mpq_class(point->hy(), point->hw())), 1};
}

Vector foot_of_perpendicular(const Vector& p, const ProjectiveLine& l) {
    KG_ASSERT(!l.at_infinity(), "a perpendicular meets a finite line");
    const Kernel::Point_2 foot = cgal(l).projection(cgal(p));
    return {exact(foot.x()), exact(foot.y())};
}

Exact squared_distance(const Vector& p, const Vector& q) { return exact(CGAL::squared_distance(cgal(p), cgal(q))); }

Exact squared_distance(const Vector& p, const ProjectiveLine& l) {
    KG_ASSERT(!l.at_infinity(), "a distance is one from a finite line");
    return exact(CGAL::squared_distance(cgal(p), cgal(l)));
}

double distance(const Vector& p, const ProjectiveLine& l) { return std::sqrt(squared_distance(p, l).to_double()); }

bool incident(const ProjectivePoint& p, const ProjectiveLine& l) {
    if (!p.at_infinity() && !l.at_infinity()) return cgal(l).has_on(cgal(p));
    return p.at_infinity() && (l.at_infinity() || sum_of_products(l.a, p.x, l.b, p.y).is_zero());
}

bool collinear(const Vector& p, const Vector& q, const Vector& r) { return CGAL::collinear(cgal(p), cgal(q), cgal(r)); }

bool is_between(const Vector& p, const Vector& q, const Vector& r) {
    return CGAL::angle(cgal(p), cgal(q), cgal(r)) == CGAL::OBTUSE;
}

}  // namespace kinegraph
