// Distances from named lines, and the ends of leaders on them.
#include "render/page/label_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kinegraph::render::lettering {

bool is_beyond(const LabelRequest& request, Spot spot, double distance) {
    const Spot half = *request.toward - request.anchor, d = spot - request.anchor;
    return std::abs(d.x) > std::abs(half.x) + distance || std::abs(d.y) > std::abs(half.y) + distance;
}

double distance_to_line(const LabelRequest& request, Spot spot) {
    const Spot half = *request.toward - request.anchor, d = spot - request.anchor;
    const double t = std::clamp(dot(d, half) / std::max(dot(half, half), 1e-12), -1.0, 1.0);
    return length(d - t * half);
}

double distance_to_line(const LabelRequest& request, const InkBox& box) {
    const Spot half = *request.toward - request.anchor;
    double least = std::min(distance_to_box(request.anchor + half, box), distance_to_box(request.anchor - half, box));
    const Spot x = box.half.x * box.axis, y = box.half.y * turned(box.axis);
    for (const Spot corner : {x + y, x - y, y - x, -1.0 * x - y})
        least = std::min(least, distance_to_line(request, box.centre + corner));
    return least;
}

bool lie_on_one_line(const LabelRequest& a, const LabelRequest& b) {
    constexpr double beside = 0.4;  // mm
    const Spot along = unit(*a.toward - a.anchor), half = *b.toward - b.anchor, d = b.anchor - a.anchor;
    return std::abs(cross(along, d + half)) < beside && std::abs(cross(along, d - half)) < beside;
}

const std::vector<Spot>& LeaderEnds::ends_of(std::size_t label) const {
    std::vector<Spot>& ends = ends_[label];
    if (!ends.empty()) return ends;
    const LabelRequest& request = requests_[label];
    if (!request.is_of_vector || !names_a_line(request)) return ends = {request.anchor};
    constexpr double clear = 1.2;  // mm: a dot on one shaft, and half of an arrowhead beside it
    double most = -1;
    Spot clearest = request.anchor;
    for (const double at : {0.0, -0.3, 0.3, -0.6, 0.6, -0.9, 0.9}) {
        const Spot end = request.anchor + at * (*request.toward - request.anchor);
        double away = clear;
        for (std::size_t other = 0; other < requests_.size(); ++other)
            if (other != label && names_a_line(requests_[other]) && !is_beyond(requests_[other], end, away))
                away = std::min(away, distance_to_line(requests_[other], end));
        if (away >= clear) ends.push_back(end);
        if (away > most) most = away, clearest = end;
    }
    if (ends.empty()) ends = {clearest};
    return ends;
}

Spot LeaderEnds::nearest(std::size_t label, const InkBox& box) const {
    const std::vector<Spot>& ends = ends_of(label);
    if (ends.size() == 1) return ends.front();
    const Spot along = unit(*requests_[label].toward - requests_[label].anchor);
    const auto dearness = [&](Spot end) {
        const Spot at = end - box.centre;
        const Spot way =
            at - Spot{std::clamp(at.x, -box.half.x, box.half.x), std::clamp(at.y, -box.half.y, box.half.y)};
        return length(way) + std::abs(dot(way, along));
    };
    Spot best = ends.front();
    double least = dearness(best);
    for (const Spot end : ends)
        if (const double price = dearness(end); price < least) best = end, least = price;
    return best;
}

}  // namespace kinegraph::render::lettering
