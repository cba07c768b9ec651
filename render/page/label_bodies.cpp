// Distances of numbers and leaders from the strokes of bodies and from named points.
#include "render/page/label_bodies.hpp"

#include <algorithm>
#include <cmath>

namespace kinegraph::render::lettering {

namespace {

constexpr double at_another_body = 20;  // a number that would be read as another's; a short leader is better
constexpr double over_a_body = 14;      // a leader, besides the price of the strokes it crosses
constexpr double past_a_point = 8;
constexpr double own_object = 1.7;  // what lies nearer to the end of a leader belongs to what it names, mm
constexpr double seen_apart = 0.3;  // two distances that differ by less look the same, mm
constexpr double passes = 1.3;      // nearer to a point than this a leader seems to end there, mm

}  // namespace

bool cross_each_other(Spot from, Spot to, const BodyStroke& stroke) {
    const auto side = [](Spot a, Spot b, Spot c) { return cross(b - a, c - a); };
    return side(from, to, stroke.from) * side(from, to, stroke.to) < 0 &&
           side(stroke.from, stroke.to, from) * side(stroke.from, stroke.to, to) < 0;
}

double Bodies::near_another(const LabelRequest& request, const InkBox& box) const {
    if (request.body == none || request.balloon <= 0) return 0;
    double own = 1e300, other = 1e300;
    for (const BodyStroke& stroke : strokes_) {
        double& least = stroke.body == request.body ? own : other;
        least = std::min(least, distance_to_segment(box.centre, stroke.from, stroke.to));
    }
    return other < own - seen_apart ? at_another_body : 0;
}

double Bodies::led_astray(std::size_t label, Spot from, Spot to) const {
    const LabelRequest& request = requests_[label];
    double price = 0;
    for (std::size_t first = 0, end = 0; first < strokes_.size(); first = end) {
        const BodyIndex body = strokes_[first].body;
        bool is_own = body == request.body, is_crossed = false;
        for (end = first; end < strokes_.size() && strokes_[end].body == body; ++end) {
            const BodyStroke& stroke = strokes_[end];
            is_crossed = is_crossed || cross_each_other(from, to, stroke);
            // A point belongs to all bodies that meet there.
            is_own = is_own ||
                     (request.body == none && distance_to_segment(request.anchor, stroke.from, stroke.to) < own_object);
        }
        if (is_crossed && !is_own) price += over_a_body;
    }
    for (std::size_t j = 0; j < requests_.size(); ++j) {
        const LabelRequest& other = requests_[j];
        if (j == label || other.toward || other.balloon > 0 || length(other.anchor - request.anchor) < own_object)
            continue;
        if (distance_to_segment(other.anchor, from, to) < passes) price += past_a_point;
    }
    return price;
}

}  // namespace kinegraph::render::lettering
