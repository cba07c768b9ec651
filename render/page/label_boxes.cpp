// Overhang of letters beyond their advance widths, and the distance of turned boxes.
#include "render/page/label_boxes.hpp"

#include <limits>

namespace kinegraph::render::lettering {

namespace {

constexpr double forgiven = 0.3;  // mm of overhang that the margin absorbs

/// How far the ink of a line extends beyond its ends: f and J overhang their advance widths.
double overhang_of(const ShapedLine& line, const Fonts& fonts) {
    double out = 0;
    const auto look_at = [&](double x) { out = std::max({out, -x, x - line.width}); };
    for (const ShapedLine::Part& part : line.parts)
        for (const Glyph& glyph : part.glyphs)
            for (const Segment& segment : fonts.outline(glyph.face, glyph.index).segments) {
                if (const auto* m = std::get_if<MoveTo>(&segment)) look_at(glyph.origin.x + glyph.size * m->to.x);
                if (const auto* l = std::get_if<LineTo>(&segment)) look_at(glyph.origin.x + glyph.size * l->to.x);
                if (const auto* c = std::get_if<CurveTo>(&segment)) look_at(glyph.origin.x + glyph.size * c->to.x);
            }
    return out;
}

}  // namespace

double gap_between_turned(const InkBox& a, const InkBox& b, double enough) {
    const Spot d = b.centre - a.centre;
    double gap = -std::numeric_limits<double>::infinity();
    for (const Spot axis : {a.axis, turned(a.axis), b.axis, turned(b.axis)}) {
        const double reach_a = std::abs(dot(axis, a.axis)) * a.half.x + std::abs(cross(axis, a.axis)) * a.half.y;
        const double reach_b = std::abs(dot(axis, b.axis)) * b.half.x + std::abs(cross(axis, b.axis)) * b.half.y;
        gap = std::max(gap, std::abs(dot(axis, d)) - reach_a - reach_b);
        if (gap >= enough) break;
    }
    return gap;
}

Lettered::Lettered(const LabelRequest& request, const Fonts& fonts, double measure)
    : balloon_(request.balloon),
      shaped_(shaped_within(request.text, request.size, fonts, balloon_ > 0 ? 1e300 : measure)),
      overhang_(overhang_of(shaped_, fonts)),
      half_(balloon_ > 0 ? Spot{balloon_, balloon_}
                         : Spot{shaped_.width / 2 + std::max(0.0, overhang_ - forgiven),
                                (shaped_.ascent + shaped_.descent) / 2}) {}

InkBox Lettered::inked(InkBox box) const {
    constexpr double pen = 0.2;
    if (balloon_ > 0) return box.grown(pen);
    box.half.x += std::min(overhang_, forgiven);
    return box;
}

}  // namespace kinegraph::render::lettering
