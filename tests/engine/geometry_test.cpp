// Laws of finite points and lines over exact rationals, at random and where formulas like to fail: points that
// coincide, lines parallel to the axes and to each other, large and tiny coordinates. And the formulas over doubles
// against them: what is exact in doubles is equal, what is divided is rounded once.
#include "engine/number/geometry.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "engine/number/assert.hpp"

namespace kinegraph::geometry_test {
namespace {

constexpr int trials = 400;

/// Random numbers, places and lines; the same on every machine.
class Draw {
public:
    explicit Draw(std::uint64_t seed) : engine_(seed) {}

    int whole(int least, int most) {
        return least + static_cast<int>(engine_() % static_cast<std::uint64_t>(most - least + 1));
    }
    /// A small or a long fraction; one in four times one of few whole numbers, so that coordinates repeat.
    Exact number() {
        switch (whole(0, 3)) {
            case 0: return whole(-2, 2);
            case 1: return Exact::ratio(whole(-1000, 1000), whole(1, 60));
            case 2: return Exact::ratio(whole(-1000, 1000), 7) * Exact::power_of_two(200 * whole(-1, 1));
            default: return Exact::ratio(whole(1, 1000000), 999983) * Exact::ratio(whole(-9, 9), 1000003);
        }
    }
    Exact number_but_zero() {
        for (;;)
            if (Exact found = number(); !found.is_zero()) return found;
    }
    Vector place() { return {number(), number()}; }
    /// One in three parallel to an axis.
    Vector direction() {
        const int kind = whole(0, 5);
        if (kind < 2) return kind == 0 ? Vector{number_but_zero(), 0} : Vector{0, number_but_zero()};
        return {number_but_zero(), number()};
    }
    ProjectiveLine line() { return finite_line_through(point_at(place()), direction()); }

private:
    std::mt19937_64 engine_;
};

/// Calls `law(draw)` with many random numbers.
template <class Law>
void holds_at_random(std::uint64_t seed, const Law& law) {
    Draw draw(seed);
    for (int i = 0; i < trials && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        law(draw);
    }
}

bool same(const ProjectivePoint& p, const ProjectivePoint& q) { return p.x == q.x && p.y == q.y && p.w == q.w; }
bool same(const ProjectiveLine& l, const ProjectiveLine& m) { return l.a == m.a && l.b == m.b && l.c == m.c; }
ProjectiveLine times(const Exact& k, const ProjectiveLine& l) { return {k * l.a, k * l.b, k * l.c}; }
bool are_parallel(const ProjectiveLine& l, const ProjectiveLine& m) { return l.a * m.b == l.b * m.a; }
/// m = k l with k > 0.
template <class Number>
bool same_oriented(const LineOf<Number>& l, const LineOf<Number>& m) {
    return l.a * m.b == l.b * m.a && l.a * m.c == l.c * m.a && l.b * m.c == l.c * m.b && l.a * m.a + l.b * m.b > 0;
}
Exact plain_cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
Exact plain_dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }

TEST(Geometry, ProductsOfVectorsAreTheirSumsOfProducts) {
    holds_at_random(1, [](Draw& draw) {
        const Vector v = draw.place(), w = draw.place();
        EXPECT_EQ(cross(v, w), plain_cross(v, w));
        EXPECT_EQ(dot(v, w), plain_dot(v, w));
        EXPECT_EQ(cross(v, w), -cross(w, v));
        EXPECT_EQ(dot(v, w), dot(w, v));
        EXPECT_TRUE(cross(v, v).is_zero());
        EXPECT_EQ(square(cross(v, w)) + square(dot(v, w)), squared_length(v) * squared_length(w));
    });
}

TEST(Geometry, ALinePassesItsPointAlongItsDirection) {
    holds_at_random(2, [](Draw& draw) {
        const Vector p = draw.place(), d = draw.direction();
        const Exact k = draw.number_but_zero();
        const ProjectiveLine l = finite_line_through(point_at(p), d);
        EXPECT_TRUE(incident(point_at(p), l));
        EXPECT_EQ(l.direction(), -d);
        EXPECT_TRUE(same(finite_line_through(point_at(p), k * d), times(k, l)));
        EXPECT_TRUE(same(finite_line_through(point_at(p + k * d), d), l));
        EXPECT_EQ(offset(point_at(p + quarter_turn(d)), l).sign(), 1) << "positive on the left";
    });
}

TEST(Geometry, AJoinPassesBothPoints) {
    holds_at_random(3, [](Draw& draw) {
        const Vector p = draw.place(), q = p + draw.direction();
        const ProjectiveLine l = finite_join(point_at(p), point_at(q));
        EXPECT_TRUE(incident(point_at(p), l));
        EXPECT_TRUE(incident(point_at(q), l));
        EXPECT_TRUE(same(finite_join(point_at(q), point_at(p)), times(-1, l)));
        EXPECT_TRUE(same_oriented(l, finite_line_through(point_at(p), q - p)));
        EXPECT_TRUE(p.x != q.x || abs(l.a) == 1);
        EXPECT_TRUE(p.y != q.y || abs(l.b) == 1);
    });
}

TEST(Geometry, AMeetLiesOnBothLines) {
    int met = 0;
    holds_at_random(4, [&](Draw& draw) {
        const ProjectiveLine l = draw.line(), m = draw.line();
        if (are_parallel(l, m)) return;
        ++met;
        const ProjectivePoint p = finite_meet(l, m);
        EXPECT_EQ(p.w, Exact(1));
        EXPECT_TRUE(incident(p, l));
        EXPECT_TRUE(incident(p, m));
        EXPECT_TRUE(same(p, finite_meet(m, l)));
        EXPECT_TRUE(same(p, finite_meet(times(draw.number_but_zero(), l), times(draw.number_but_zero(), m))));
    });
    EXPECT_GT(met, trials / 2);
}

TEST(Geometry, JoinsFromAPointMeetThere) {
    int met = 0;
    holds_at_random(5, [&](Draw& draw) {
        const Vector p = draw.place(), q = draw.place(), r = draw.place();
        if (plain_cross(q - p, r - p).is_zero()) return;
        ++met;
        EXPECT_TRUE(same(finite_meet(finite_join(point_at(p), point_at(q)), finite_join(point_at(r), point_at(p))),
                         point_at(p)));
    });
    EXPECT_GT(met, trials / 2);
}

TEST(Geometry, TheSideIsThatOfTheTurn) {
    std::array<int, 3> seen{};
    holds_at_random(6, [&](Draw& draw) {
        const Vector p = draw.place(), q = p + draw.direction();
        // One in three on the line itself.
        const Vector r = draw.whole(0, 2) == 0 ? p + draw.number() * (q - p) : draw.place();
        const ProjectiveLine l = finite_join(point_at(p), point_at(q));
        const int side = offset(point_at(r), l).sign();
        ++seen.at(static_cast<std::size_t>(side + 1));
        EXPECT_EQ(side, plain_cross(q - p, r - p).sign());
        EXPECT_EQ(side, -offset(point_at(r), finite_join(point_at(q), point_at(p))).sign());
        EXPECT_EQ(side == 0, incident(point_at(r), l));
        const Exact k = draw.number_but_zero();
        EXPECT_EQ(offset(point_at(r), times(k, l)), k * offset(point_at(r), l));
    });
    for (const int count : seen) EXPECT_GT(count, trials / 10) << "left, on it, right";
}

TEST(Geometry, PlacesOfALineAreCollinear) {
    std::array<int, 2> seen{};
    holds_at_random(7, [&](Draw& draw) {
        const Vector p = draw.place(), q = draw.place();
        const Vector r = draw.whole(0, 1) == 0 ? p + draw.number() * (q - p) : draw.place();
        const bool found = collinear(p, q, r);
        ++seen.at(found ? 1 : 0);
        EXPECT_EQ(found, plain_cross(q - p, r - p).is_zero());
        EXPECT_EQ(found, collinear(q, r, p));
        EXPECT_EQ(found, collinear(r, q, p));
        EXPECT_TRUE(collinear(p, p, q));
        EXPECT_TRUE(collinear(p, q, p));
    });
    for (const int count : seen) EXPECT_GT(count, trials / 10);
}

TEST(Geometry, BetweenIsAPartOfTheSegment) {
    std::array<int, 2> seen{};
    holds_at_random(8, [&](Draw& draw) {
        const Vector p = draw.place(), d = draw.direction(), r = p + d;
        const Exact part = draw.whole(0, 1) == 0 ? Exact::ratio(draw.whole(-2, 12), 10) : draw.number();
        const Vector q = p + part * d;
        const bool found = is_between(p, q, r);
        ++seen.at(found ? 1 : 0);
        EXPECT_EQ(found, part.sign() > 0 && part < 1);
        EXPECT_EQ(found, is_between(r, q, p));
        EXPECT_FALSE(is_between(p, p, r)) << "an end is not between";
        EXPECT_FALSE(is_between(p, r, p)) << "nothing is between a place and itself";
        const Vector beside = draw.place();
        EXPECT_EQ(is_between(p, beside, r), plain_dot(p - beside, r - beside).sign() < 0);
    });
    for (const int count : seen) EXPECT_GT(count, trials / 10);
}

TEST(Geometry, TheFootIsNearest) {
    holds_at_random(9, [](Draw& draw) {
        const Vector p = draw.place(), on = draw.place(), d = draw.direction();
        const ProjectiveLine l = finite_line_through(point_at(on), d);
        const Vector foot = foot_of_perpendicular(p, l);
        EXPECT_TRUE(incident(point_at(foot), l));
        EXPECT_TRUE(plain_dot(p - foot, d).is_zero());
        EXPECT_EQ(foot_of_perpendicular(foot, l), foot);
        EXPECT_EQ(foot_of_perpendicular(p, times(draw.number_but_zero(), l)), foot);
        EXPECT_EQ(squared_distance(p, l), squared_distance(p, foot));
        EXPECT_LE(squared_distance(p, l), squared_distance(p, on));
    });
}

TEST(Geometry, SquaredDistances) {
    holds_at_random(10, [](Draw& draw) {
        const Vector p = draw.place(), q = draw.place();
        const ProjectiveLine l = draw.line();
        EXPECT_EQ(squared_distance(p, q), plain_dot(q - p, q - p));
        EXPECT_EQ(squared_distance(p, q), squared_distance(q, p));
        EXPECT_EQ(squared_distance(p, q).is_zero(), p == q);
        EXPECT_TRUE(squared_distance(p, p).is_zero());
        EXPECT_EQ(squared_distance(p, l) * (square(l.a) + square(l.b)), square(offset(point_at(p), l)));
        EXPECT_EQ(squared_distance(p, l), squared_distance(p, times(draw.number_but_zero(), l)));
        EXPECT_EQ(squared_distance(p, l).is_zero(), incident(point_at(p), l));
        const double near = length(p - foot_of_perpendicular(p, l));
        EXPECT_NEAR(distance(p, l), near, 4e-16 * near);
    });
}

TEST(Geometry, PointsAndLinesAtInfinity) {
    const ProjectiveLine far{0, 0, 1};
    holds_at_random(11, [&](Draw& draw) {
        const Vector d = draw.direction(), p = draw.place();
        const ProjectivePoint there{d.x, d.y, 0};
        const ProjectiveLine l = line_joining(point_at(p), there);
        EXPECT_TRUE(incident(point_at(p), l));
        EXPECT_TRUE(incident(there, l));
        EXPECT_TRUE(same(l, line_joining(there, point_at(p))));
        EXPECT_TRUE(incident(there, far));
        EXPECT_FALSE(incident(point_at(p), far));
        EXPECT_TRUE(same(line_through(there, d), far));
        EXPECT_TRUE(same(line_joining(there, ProjectivePoint{-d.y, d.x, 0}), far));
        EXPECT_TRUE(incident(point_at_infinity_of(l), l));
        EXPECT_TRUE(incident(point_at_infinity_of(l), finite_line_through(point_at(draw.place()), d)));
        EXPECT_FALSE(incident(ProjectivePoint{-d.y, d.x, 0}, l));
    });
}

TEST(Geometry, WhatHasNoAnswerIsOurFault) {
    const ProjectivePoint p = point_at(Vector{1, 2}), there{1, 1, 0};
    const ProjectiveLine l = finite_line_through(p, {1, 3}), far{0, 0, 1};
    EXPECT_THROW(finite_join(p, p), Fault);
    EXPECT_THROW(finite_join(p, there), Fault);
    EXPECT_THROW(finite_line_through(p, {0, 0}), Fault);
    EXPECT_THROW(finite_meet(l, l), Fault);
    EXPECT_THROW(finite_meet(l, finite_line_through(point_at(Vector{0, 0}), {2, 6})), Fault) << "parallel";
    EXPECT_THROW(finite_meet(l, far), Fault);
    EXPECT_THROW(foot_of_perpendicular({0, 0}, far), Fault);
    EXPECT_THROW(squared_distance(Vector{0, 0}, far), Fault);
}

// --- doubles against exact rationals ---------------------------------------------------------------------------------

/// Whole coordinates up to 500 times a power of two: products of three and their sums have no rounding in doubles.
class DrawInDoubles {
public:
    explicit DrawInDoubles(Draw& draw)
        : draw_(draw),
          scale_(Exact::power_of_two(std::array{-150, 0, 150}.at(static_cast<std::size_t>(draw.whole(0, 2))))) {}
    Vector place() { return {scale_ * draw_.whole(-500, 500), scale_ * draw_.whole(-500, 500)}; }
    Vector direction() {
        for (;;)
            if (const Vector found = place() - place(); !found.is_zero())
                return draw_.whole(0, 3) == 0 && !found.x.is_zero() ? Vector{found.x, 0} : found;
    }

private:
    Draw& draw_;
    Exact scale_;
};

VectorOf<double> near(const Vector& v) { return {v.x.to_double(), v.y.to_double()}; }
PointOf<double> near(const ProjectivePoint& p) { return {p.x.to_double(), p.y.to_double(), p.w.to_double()}; }
LineOf<double> near(const ProjectiveLine& l) { return {l.a.to_double(), l.b.to_double(), l.c.to_double()}; }
bool same(const PointOf<double>& p, const PointOf<double>& q) { return p.x == q.x && p.y == q.y && p.w == q.w; }
bool same(const LineOf<double>& l, const LineOf<double>& m) { return l.a == m.a && l.b == m.b && l.c == m.c; }

TEST(GeometryInDoubles, LinesAreTheExactOnes) {
    holds_at_random(21, [](Draw& random) {
        DrawInDoubles draw(random);
        const Vector p = draw.place(), d = draw.direction(), q = p + d, r = draw.place();
        const ProjectiveLine through = finite_line_through(point_at(p), d);
        EXPECT_TRUE(same(finite_line_through(point_at(near(p)), near(d)), near(through)));
        const ProjectiveLine join = finite_join(point_at(p), point_at(q));
        EXPECT_TRUE(same_oriented(finite_join(point_at(near(p)), point_at(near(q))), near(join)));
        EXPECT_EQ(offset(point_at(near(r)), near(through)), offset(point_at(r), through).to_double());
        EXPECT_EQ(sign_of(offset(point_at(near(r)), finite_join(point_at(near(p)), point_at(near(q))))),
                  sign_of(offset(point_at(r), join)));
        EXPECT_EQ(cross(near(p), near(r)), cross(p, r).to_double());
        EXPECT_EQ(dot(near(p), near(r)), dot(p, r).to_double());
    });
}

TEST(GeometryInDoubles, AMeetIsTheNearestToTheExactOne) {
    int met = 0;
    holds_at_random(22, [&](Draw& random) {
        DrawInDoubles draw(random);
        const ProjectiveLine l = finite_line_through(point_at(draw.place()), draw.direction());
        const ProjectiveLine m = finite_line_through(point_at(draw.place()), draw.direction());
        if (are_parallel(l, m)) return;
        ++met;
        EXPECT_TRUE(same(finite_meet(near(l), near(m)), near(finite_meet(l, m))));
    });
    EXPECT_GT(met, trials / 2);
}

TEST(GeometryInDoubles, AtInfinity) {
    holds_at_random(23, [](Draw& random) {
        DrawInDoubles draw(random);
        const Vector p = draw.place(), d = draw.direction();
        const ProjectivePoint there{d.x, d.y, 0}, across{-d.y, d.x, 0};
        const ProjectiveLine l = line_joining(point_at(p), there);
        EXPECT_TRUE(same(line_joining(point_at(near(p)), near(there)), near(l)));
        EXPECT_TRUE(same(line_joining(near(there), near(across)), near(line_joining(there, across))));
        EXPECT_TRUE(same(line_through(near(there), near(d)), near(line_through(there, d))));
        EXPECT_TRUE(same(point_at_infinity_of(near(l)), near(point_at_infinity_of(l))));
    });
}

}  // namespace
}  // namespace kinegraph::geometry_test
