#include "engine/number/geometry.hpp"

#include <CGAL/Intersections_2/Line_2_Line_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/mpq_class.h>

#include <boost/variant/get.hpp>
#include <cmath>
#include <utility>
#include <variant>

#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {

using Kernel = CGAL::Simple_cartesian<mpq_class>;

// In and out of the kernel: the same rationals, in lowest terms on both sides.
Kernel::Vector_2 cgal_vector(const Exact& x, const Exact& y) { return {x.rational(), y.rational()}; }
Kernel::Point_2 cgal_point(const Exact& x, const Exact& y) { return {x.rational(), y.rational()}; }
Kernel::Point_2 cgal(const ProjectivePoint& p) { return cgal_point(p.x, p.y); }
Kernel::Point_2 cgal(const Vector& place) { return cgal_point(place.x, place.y); }
Kernel::Line_2 cgal(const ProjectiveLine& l) { return {l.a.rational(), l.b.rational(), l.c.rational()}; }
Exact exact(mpq_class number) { return Exact::in_lowest_terms(std::move(number)); }
ProjectiveLine projective(const Kernel::Line_2& l) { return {exact(l.a()), exact(l.b()), exact(l.c())}; }

/// The same line with whole coefficients. Between whole numbers the kernel's products and differences have no fraction
/// to bring to lowest terms; so a meet of lines with long coefficients costs less than half.
Kernel::Line_2 with_whole_coefficients(const ProjectiveLine& l) {
    const mpq_class &a = l.a.rational(), &b = l.b.rational(), &c = l.c.rational();
    const mpz_class common = lcm(lcm(a.get_den(), b.get_den()), c.get_den());
    const auto whole = [&](const mpq_class& number) {
        return mpq_class(mpz_class(common / number.get_den() * number.get_num()));
    };
    return {whole(a), whole(b), whole(c)};
}

/// The point in what CGAL gives as an intersection, a variant: Boost's in CGAL 5, the standard library's since CGAL 6.
template <class Intersection>
const Kernel::Point_2* point_of(const Intersection& found) {
    if constexpr (requires { std::get_if<Kernel::Point_2>(&found); }) {
        return std::get_if<Kernel::Point_2>(&found);
    } else {
        return boost::get<Kernel::Point_2>(&found);
    }
}

}  // namespace

Exact sum_of_products(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
    return exact(cgal_vector(a, c) * cgal_vector(b, d));
}

Exact difference_of_products(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
    return exact(CGAL::determinant(cgal_vector(a, d), cgal_vector(c, b)));
}

ProjectiveLine finite_line_through(const ProjectivePoint& p, const Vector& d) {
    KG_ASSERT(!p.at_infinity() && !d.is_zero(), "a line needs a finite point and a direction");
    return projective({cgal(p), cgal_vector(d.x, d.y)});
}

ProjectiveLine finite_join(const ProjectivePoint& p, const ProjectivePoint& q) {
    KG_ASSERT(!p.at_infinity() && !q.at_infinity() && !(p.x == q.x && p.y == q.y),
              "a finite line joins two finite points that differ");
    return projective({cgal(p), cgal(q)});
}

ProjectivePoint finite_meet(const ProjectiveLine& l, const ProjectiveLine& m) {
    const auto found = CGAL::intersection(with_whole_coefficients(l), with_whole_coefficients(m));
    const Kernel::Point_2* point = found ? point_of(*found) : nullptr;
    KG_ASSERT(point != nullptr, "lines that are not parallel meet in a point");
    return {exact(point->x()), exact(point->y()), 1};
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
