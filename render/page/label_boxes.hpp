// Label boxes: the box that a label takes wherever it stands, and how boxes lie to each other. Knows no place and no
// price.
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
/// The upright box round a turned one.
inline Box extent_of(const InkBox& box) {
    const Spot reach = box.axis.y == 0 ? box.half : box.reach();  // most are upright
    return {box.centre - reach, box.centre + reach};
}

/// Distance of two boxes, of which one at least is turned, along their worst of four separating axes.
double gap_between_turned(const InkBox& a, const InkBox& b, double enough);

/// Distance of two boxes along their worst separating axis; negative where they overlap. Above `enough`, only the fact
/// is reported.
inline double gap_between(const InkBox& a, const InkBox& b, double enough) {
    const Spot d = b.centre - a.centre;
    // Most pairs are far apart: their circles tell.
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

/// The letters of a label, or its number in a circle, and the box that they take.
class Lettered {
public:
    /// Text wider than `measure` ends in an ellipsis; a number in a circle never does.
    Lettered(const LabelRequest& request, const Fonts& fonts, double measure);

    Spot half() const { return half_; }
    /// The box of all ink where the label stands in a box: what leans out of it, the pen of the circle round a number.
    InkBox inked(InkBox box) const;
    /// To be set, once.
    ShapedLine take() { return std::move(shaped_); }

private:
    double balloon_;
    ShapedLine shaped_;
    double overhang_;
    Spot half_;
};

}  // namespace kinegraph::render::lettering
