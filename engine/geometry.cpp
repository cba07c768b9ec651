#include "engine/geometry.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <CGAL/mpq_class.h>

#include "engine/assert.hpp"

namespace kinegraph {
namespace {

using Kernel = CGAL::Simple_cartesian<mpq_class>;

Kernel::Point_2 finite(const ProjectivePoint& p) { return {p.x.rational(), p.y.rational()}; }
Kernel::Line_2 finite(const ProjectiveLine& l) { return {l.a.rational(), l.b.rational(), l.c.rational()}; }
ProjectiveLine projective(const Kernel::Line_2& l) { return {Exact(l.a()), Exact(l.b()), Exact(l.c())}; }

}  // namespace

ProjectiveLine finite_line_through(const ProjectivePoint& point, const Vector& direction) {
    KG_ASSERT(!direction.is_zero(), "a line needs a direction");
    return projective(Kernel::Line_2(finite(point), Kernel::Vector_2(direction.x.rational(), direction.y.rational())));
}

ProjectiveLine finite_join(const ProjectivePoint& p, const ProjectivePoint& q) {
    KG_ASSERT(p.place() != q.place(), "two places that coincide have no join");
    return projective(Kernel::Line_2(finite(p), finite(q)));
}

ProjectivePoint finite_meet(const ProjectiveLine& l, const ProjectiveLine& m) {
    const auto met = CGAL::intersection(finite(l), finite(m));
    KG_ASSERT(met, "lines that are not parallel meet");
    const auto* point = boost::get<Kernel::Point_2>(&*met);
    KG_ASSERT(point != nullptr, "lines that do not coincide meet in one point");
    return {Exact(point->x()), Exact(point->y()), 1};
}

bool incident(const ProjectivePoint& p, const ProjectiveLine& l) {
    if (!p.at_infinity() && !l.at_infinity()) return finite(l).has_on(finite(p));
    return (l.a * p.x + l.b * p.y + l.c * p.w).is_zero();
}

}  // namespace kinegraph
