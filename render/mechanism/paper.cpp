// Geometry on paper: clipping to a box, distances, directions of exact vectors.
#include "render/mechanism/paper.hpp"

#include <cmath>

namespace kinegraph::render::drawing {

Spot paper_direction(const Vector& v) {
    const Exact largest = std::max(abs(v.x), abs(v.y));
    if (largest.is_zero()) return {1, 0};
    return unit({(v.x / largest).to_double(), -(v.y / largest).to_double()});
}

bool contains(const Box& box, Spot spot) {
    return spot.x >= box.min.x && spot.x <= box.max.x && spot.y >= box.min.y && spot.y <= box.max.y;
}

Interval within(const Box& box, Spot from, Spot along) {
    Interval interval{-1e300, 1e300};
    const auto clip = [&](double start, double step, double low, double high) {
        if (std::abs(step) < 1e-12) {
            if (start < low || start > high) interval = {1, -1};
            return;
        }
        double a = (low - start) / step, b = (high - start) / step;
        if (a > b) std::swap(a, b);
        interval = {std::max(interval.from, a), std::min(interval.to, b)};
    };
    clip(from.x, along.x, box.min.x, box.max.x);
    clip(from.y, along.y, box.min.y, box.max.y);
    return interval;
}

double distance(Spot spot, const Bar& bar) { return distance_to_segment(spot, bar.from, bar.to); }

const Bar& longest_of(const std::vector<Bar>& bars) {
    return *std::max_element(bars.begin(), bars.end(),
                             [](const Bar& a, const Bar& b) { return length(a) < length(b) - 1e-9; });
}

}  // namespace kinegraph::render::drawing
