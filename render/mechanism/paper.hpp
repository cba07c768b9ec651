// Geometry on paper (mm, y downwards): conversion of the mechanism's places and directions, bars, boxes, and the choice
// of the cheapest place for a symbol. Independent of mechanisms.
#pragma once

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/number/exact.hpp"
#include "render/page/figure.hpp"
#include "render/page/labels.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render::drawing {

constexpr double overshoot = 7.0;    // of a construction line beyond its ends, mm
constexpr double same_place = 0.02;  // points nearer than this coincide on paper, mm
constexpr double pi_number = std::numbers::pi;

/// A place, with y downwards.
inline Spot paper_spot(const Vector& v) { return {v.x.to_double(), -v.y.to_double()}; }
/// A direction of any length as a unit vector, with y downwards.
Spot paper_direction(const Vector& v);
inline bool coincide(Spot a, Spot b) { return length(a - b) < same_place; }

inline Box grown(Box box, double by) { return {{box.min.x - by, box.min.y - by}, {box.max.x + by, box.max.y + by}}; }
bool contains(const Box& box, Spot spot);
/// The part of the line from + t·along inside the box, as an interval of t; empty (from > to) if the line misses it.
struct Interval {
    double from, to;
};
Interval within(const Box& box, Spot from, Spot along);

struct Bar {
    Spot from, to;
};
inline double length(const Bar& bar) { return length(bar.to - bar.from); }
inline Spot direction(const Bar& bar) { return unit(bar.to - bar.from); }
inline Spot middle(const Bar& bar) { return 0.5 * (bar.from + bar.to); }
double distance(Spot spot, const Bar& bar);
/// The longest bar; of equal ones the first.
const Bar& longest_of(const std::vector<Bar>& bars);

/// An arc about a centre, between two angles (radians, clockwise on paper).
struct Arc {
    Spot centre;
    double radius = 0, from = 0, to = 0;
    Spot at(double angle) const { return centre + radius * polar_spot(angle); }
};
inline Path arc(const Arc& a, Pen pen) { return render::arc(a.centre, a.radius, a.from, a.to, std::move(pen)); }

/// Keeps the cheapest of the offered choices; of equal prices the first.
template <class Choice>
struct Cheapest {
    Choice choice{};
    double price = 1e300;
    void offer(double asked, const Choice& offered) {
        if (asked >= price - 1e-9) return;
        price = asked;
        choice = offered;
    }
};

}  // namespace kinegraph::render::drawing
