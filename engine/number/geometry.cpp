#include "engine/number/geometry.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/constructions/kernel_ftC2.h>
#include <CGAL/mpq_class.h>

#include <utility>

#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {

using Kernel = CGAL::Simple_cartesian<mpq_class>;

Kernel::Point_2 finite(const ProjectivePoint& p) { return {p.x.rational(), p.y.rational()}; }
Kernel::Line_2 finite(const ProjectiveLine& l) { return {l.a.rational(), l.b.rational(), l.c.rational()}; }

/// A line as one of CGAL's formulas gives it: `make(a, b, c)`. (CGAL's own lines would hold a copy of every number.)
template <class Make>
ProjectiveLine line_of(const Make& make) {
    mpq_class a, b, c;
    make(a, b, c);
    return {Exact::in_lowest_terms(std::move(a)), Exact::in_lowest_terms(std::move(b)),
            Exact::in_lowest_terms(std::move(c))};
}

/// The same line with whole coefficients.
struct WholeLine {
    explicit WholeLine(const ProjectiveLine& l) {
        const mpq_class &la = l.a.rational(), &lb = l.b.rational(), &lc = l.c.rational();
        const mpz_class common = lcm(lcm(la.get_den(), lb.get_den()), lc.get_den());
        a = common / la.get_den() * la.get_num();
        b = common / lb.get_den() * lb.get_num();
        c = common / lc.get_den() * lc.get_num();
    }
    mpz_class a, b, c;
};

Exact ratio(mpz_class numerator, const mpz_class& denominator) {
    return Exact(mpq_class(std::move(numerator), denominator));
}

}  // namespace

ProjectiveLine finite_line_through(const ProjectivePoint& point, const Vector& direction) {
    KG_ASSERT(!direction.is_zero(), "a line needs a direction");
    return line_of([&](mpq_class& a, mpq_class& b, mpq_class& c) {
        CGAL::line_from_point_directionC2(point.x.rational(), point.y.rational(), direction.x.rational(),
                                          direction.y.rational(), a, b, c);
    });
}

ProjectiveLine finite_join(const ProjectivePoint& p, const ProjectivePoint& q) {
    KG_ASSERT(p.x != q.x || p.y != q.y, "two places that coincide have no join");
    return line_of([&](mpq_class& a, mpq_class& b, mpq_class& c) {
        CGAL::line_from_pointsC2(p.x.rational(), p.y.rational(), q.x.rational(), q.y.rational(), a, b, c);
    });
}

// CGAL's intersection is the same over fractions: each of its products and differences is brought to lowest terms,
// where only the two coordinates need be.
ProjectivePoint finite_meet(const ProjectiveLine& l, const ProjectiveLine& m) {
    const WholeLine one(l), other(m);
    const mpz_class across = one.a * other.b - other.a * one.b;
    KG_ASSERT(across != 0, "lines that are not parallel meet");
    return {ratio(one.b * other.c - other.b * one.c, across), ratio(other.a * one.c - one.a * other.c, across), 1};
}

bool incident(const ProjectivePoint& p, const ProjectiveLine& l) {
    if (!p.at_infinity() && !l.at_infinity()) return finite(l).has_on(finite(p));
    return (l.a * p.x + l.b * p.y + l.c * p.w).is_zero();
}

}  // namespace kinegraph
