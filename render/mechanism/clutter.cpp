// Clutter: strokes are stored as bars with half their width.
#include "render/mechanism/clutter.hpp"

#include <algorithm>

namespace kinegraph::render::drawing {

void Clutter::add(const Bar& bar, double half) {
    const double near = half + 1.2;
    const auto [tail, tip] = bar;
    strokes_.push_back({bar, near,
                        rectangle(std::min(tail.x, tip.x) - near, std::min(tail.y, tip.y) - near,
                                  std::max(tail.x, tip.x) + near, std::max(tail.y, tip.y) + near)});
}

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
                add(Bar{pen, l->to}, half);
                pen = l->to;
            } else if (const auto* a = std::get_if<ArcTo>(&segment)) {
                pen = a->centre + a->radius * polar_spot(a->to);
                if (path->filled)
                    add(Bar{a->centre, a->centre}, a->radius);
                else
                    add_arc(a->centre, a->radius, a->from, a->to - a->from);
            } else if (std::holds_alternative<Close>(segment)) {
                add(Bar{pen, start}, half);
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
    // Most strokes are far away; test bounding boxes first, that of the whole segment before the others.
    constexpr double rounding = 1e-6;
    const Spot low{std::min(from.x, to.x) - rounding, std::min(from.y, to.y) - rounding};
    const Spot high{std::max(from.x, to.x) + rounding, std::max(from.y, to.y) + rounding};
    std::vector<const Stroke*> about;
    for (const Stroke& stroke : strokes_)
        if (high.x > stroke.box.min.x && low.x < stroke.box.max.x && high.y > stroke.box.min.y &&
            low.y < stroke.box.max.y)
            about.push_back(&stroke);
    if (about.empty()) return 0;
    int met = 0;
    for (int i = 0; i <= pieces; ++i) {
        const Spot at = from + (static_cast<double>(i) / pieces) * (to - from);
        if (std::any_of(about.begin(), about.end(), [at](const Stroke* stroke) {
                const Box& box = stroke->box;
                return at.x > box.min.x && at.x < box.max.x && at.y > box.min.y && at.y < box.max.y &&
                       distance(at, stroke->bar) < stroke->near;
            }))
            ++met;
    }
    return static_cast<double>(met) / (pieces + 1);
}

double Clutter::along_arc(Spot centre, double radius, double from, double sweep, double enough) const {
    constexpr int pieces = 4;
    double sum = 0;
    Spot tail = centre + radius * polar_spot(from);
    for (int i = 0; i < pieces && sum / pieces < enough; ++i) {
        const Spot tip = centre + radius * polar_spot(from + sweep * (i + 1) / pieces);
        sum += along(tail, tip);
        tail = tip;
    }
    return sum / pieces;
}

}  // namespace kinegraph::render::drawing
