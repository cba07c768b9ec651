// Clutter: strokes kept as bars with half their width.
#include "render/mechanism/clutter.hpp"

namespace kinegraph::render::drawing {

void Clutter::add(const std::vector<Mark>& marks) {
    for (const Mark& mark : marks) {
        const auto* path = std::get_if<Path>(&mark);
        if (!path) continue;
        Spot pen, start;
        const double half = path->stroked ? path->pen.width / 2 : 0;
        for (const Segment& segment : path->segments) {
            if (const auto* m = std::get_if<MoveTo>(&segment)) {
                pen = start = m->to;
            } else if (const auto* l = std::get_if<LineTo>(&segment)) {
                strokes_.push_back({{pen, l->to}, half});
                pen = l->to;
            } else if (const auto* a = std::get_if<ArcTo>(&segment)) {
                pen = a->centre + a->radius * polar_spot(a->to);
                strokes_.push_back({{a->centre, a->centre}, a->radius});
            } else if (std::holds_alternative<Close>(segment)) {
                strokes_.push_back({{pen, start}, half});
            }
        }
    }
}

void Clutter::add_arc(Spot centre, double radius, double from, double sweep) {
    constexpr int pieces = 6;
    for (int i = 0; i < pieces; ++i)
        add(centre + radius * polar_spot(from + sweep * i / pieces),
            centre + radius * polar_spot(from + sweep * (i + 1) / pieces));
}

double Clutter::along(Spot from, Spot to) const {
    constexpr int pieces = 16;
    int met = 0;
    for (int i = 0; i <= pieces; ++i) {
        const Spot at = from + (static_cast<double>(i) / pieces) * (to - from);
        if (std::any_of(strokes_.begin(), strokes_.end(), [&](const Stroke& stroke) {
                const double near = stroke.half + 1.2;
                const auto [tail, tip] = stroke.bar;
                // Most are far away: the box round a stroke tells.
                return at.x > std::min(tail.x, tip.x) - near && at.x < std::max(tail.x, tip.x) + near &&
                       at.y > std::min(tail.y, tip.y) - near && at.y < std::max(tail.y, tip.y) + near &&
                       distance(at, stroke.bar) < near;
            }))
            ++met;
    }
    return static_cast<double>(met) / (pieces + 1);
}

double Clutter::along_arc(Spot centre, double radius, double from, double sweep) const {
    constexpr int pieces = 4;
    double sum = 0;
    for (int i = 0; i < pieces; ++i)
        sum += along(centre + radius * polar_spot(from + sweep * i / pieces),
                     centre + radius * polar_spot(from + sweep * (i + 1) / pieces));
    return sum / pieces;
}

}  // namespace kinegraph::render::drawing
