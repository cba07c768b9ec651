// Label boxes: the box of a label, and distances between boxes. Independent of places and prices.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/page/figure.hpp"
#include "render/page/ink_map.hpp"

namespace kinegraph::render::lettering {

constexpr Box nowhere{{1e300, 1e300}, {-1e300, -1e300}};

inline bool apart(const Box& a, const Box& b) {
    return a.min.x > b.max.x || b.min.x > a.max.x || a.min.y > b.max.y || b.min.y > a.max.y;
}
inline void enlarge(Box& box, Spot by) {
    box.min = {std::min(box.min.x, by.x), std::min(box.min.y, by.y)};
    box.max = {std::max(box.max.x, by.x), std::max(box.max.y, by.y)};
}
inline void enlarge(Box& box, const Box& by) {
    enlarge(box, by.min);
    enlarge(box, by.max);
}
/// The axis-aligned bounding box of a turned box.
inline Box extent_of(const InkBox& box) {
    const Spot reach = box.axis.y == 0 ? box.half : box.reach();  // most boxes are not turned
    return {box.centre - reach, box.centre + reach};
}

/// Distance of two boxes, at least one of which is turned: the largest gap along the four candidate separating axes.
double gap_between_turned(const InkBox& a, const InkBox& b, double enough);

/// Distance of two boxes: the largest gap along the candidate separating axes; negative if they overlap. Above `enough`
/// the result is only a lower bound.
inline double gap_between(const InkBox& a, const InkBox& b, double enough) {
    const Spot d = b.centre - a.centre;
    // Quick test: most pairs are far apart, so compare their bounding circles first.
    const double round = a.half.x + a.half.y + b.half.x + b.half.y + enough;
    if (std::abs(d.x) > round || std::abs(d.y) > round) return enough;
    if (a.axis.y == 0 && b.axis.y == 0)
        return std::max(std::abs(d.x) - a.half.x - b.half.x, std::abs(d.y) - a.half.y - b.half.y);
    return gap_between_turned(a, b, enough);
}

inline double distance_to_box(Spot spot, const InkBox& box) {
    const Spot at = box.local(spot);
    return length({std::max(std::abs(at.x) - box.half.x, 0.0), std::max(std::abs(at.y) - box.half.y, 0.0)});
}

/// A label's shaped text, or the number in a circle, and the half extents of its box.
class Lettered {
public:
    /// Text wider than `measure` ends in an ellipsis; a number in a circle is never cut.
    Lettered(const LabelRequest& request, const Fonts& fonts, double measure);

    Spot half() const { return half_; }
    /// The box of all ink of a label that stands in `box`: includes overhanging letters and the stroke of the circle.
    InkBox inked(InkBox box) const;
    /// Moves the shaped text out. Call once.
    ShapedLine take() { return std::move(shaped_); }

private:
    double balloon_;
    ShapedLine shaped_;
    double overhang_;
    Spot half_;
};

}  // namespace kinegraph::render::lettering
