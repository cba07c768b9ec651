// Implementation of free_corner.hpp.
#include "render/layout/free_corner.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>

#include "render/page/free_room.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

/// Up to rounding: width_beside() gives exactly the width that is needed.
bool is_free(const std::vector<Spot>& spots, Spot moved, const Box& box, double margin) {
    constexpr double rounding = 1e-6;
    margin -= rounding;
    const Box wide = rectangle(box.min.x - margin - moved.x, box.min.y - margin - moved.y, box.max.x + margin - moved.x,
                               box.max.y + margin - moved.y);
    return std::none_of(spots.begin(), spots.end(), [&](Spot s) {
        return s.x > wide.min.x && s.x < wide.max.x && s.y > wide.min.y && s.y < wide.max.y;
    });
}

}  // namespace

bool set_beside(std::vector<Mark>& marks, Figure& figure, const Block& block, const Box& room) {
    const std::vector<Spot> spots = covered(figure.marks);
    const double spare_x = room.width() - figure.box.width(), spare_y = room.height() - figure.box.height();
    if (spare_x < 0 || spare_y < 0 || block.width > room.width() || block.height > room.height()) return false;
    const double left = figure.box.height() - block.height;
    // Prefers positions of the figure near the middle and near its caption.
    const auto sets = [&](std::initializer_list<double> lows) {
        for (const double down : {0.0, 0.5, 1.0})
            for (const double aside : {0.5, 0.6, 0.7, 0.8, 0.9, 1.0})
                for (const double low : lows)
                    for (const bool right : {false, true}) {
                        const double across = right ? 1 - aside : aside, top = room.min.y + down * spare_y;
                        const Spot corner{right ? room.max.x - block.width : room.min.x,
                                          low > 0 ? std::min(top + low * left, room.max.y - block.height) : room.min.y};
                        const Spot moved{room.min.x - figure.box.min.x + across * spare_x, top - figure.box.min.y};
                        const Box box = rectangle(corner.x, corner.y, corner.x + block.width, corner.y + block.height);
                        if (corner.y < room.min.y || !is_free(spots, moved, box, clear)) continue;
                        figure.move(moved.x, moved.y);
                        set(marks, block, corner);
                        return true;
                    }
        return false;
    };
    // A block half way down a tall figure leaves less white in one piece than one in its corner.
    constexpr double tall = 30;  // mm, above the height of the block
    return (left > tall && sets({0.5})) || sets({0, 1});
}

double width_beside(const Figure& figure, const Block& block) {
    const Box& box = figure.box;
    if (block.height > box.height()) return std::numeric_limits<double>::infinity();
    double least = std::numeric_limits<double>::infinity();
    const std::vector<Spot> spots = covered(figure.marks);
    for (const bool bottom : {false, true}) {
        // Free widths left and right of what is drawn at the height of the block; less than none where a stroke's edge
        // is outside of the box.
        double left = box.width(), right = box.width();
        for (const Spot& spot : spots) {
            const double down = bottom ? box.max.y - spot.y : spot.y - box.min.y;
            if (down > block.height + clear) continue;
            left = std::min(left, spot.x - box.min.x);
            right = std::min(right, box.max.x - spot.x);
        }
        least = std::min(least, block.width + clear - std::max(left, right));
    }
    return std::max(least, 0.0);
}

}  // namespace kinegraph::render
