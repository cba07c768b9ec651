// Beside a figure: see beside.hpp.
#include "render/sheet/beside.hpp"

#include <algorithm>

#include "render/page/free_room.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

bool is_free(const std::vector<Spot>& spots, Spot moved, const Box& box, double margin) {
    const Box wide = rectangle(box.min.x - margin - moved.x, box.min.y - margin - moved.y, box.max.x + margin - moved.x,
                               box.max.y + margin - moved.y);
    return std::none_of(spots.begin(), spots.end(),
                        [&](Spot s) { return s.x > wide.min.x && s.x < wide.max.x && s.y > wide.min.y && s.y < wide.max.y; });
}

void align(Figure& figure, const Box& room, double across, double down) {
    figure.move(room.min.x - figure.box.min.x + across * (room.width() - figure.box.width()),
                room.min.y - figure.box.min.y + down * (room.height() - figure.box.height()));
}

}  // namespace

void centre(Figure& figure, const Box& room) { align(figure, room, 0.5, 0.0); }

bool set_beside(std::vector<Mark>& marks, Figure& figure, const std::array<Block, 2>& blocks, const Box& room) {
    const std::vector<Spot> spots = covered(figure.marks);
    const double spare_x = room.width() - figure.box.width(), spare_y = room.height() - figure.box.height();
    if (spare_x < 0 || spare_y < 0) return false;
    for (const Block& block : blocks) {
        if (block.width > room.width() || block.height > room.height()) continue;
        const double right = room.max.x - block.width, bottom = room.max.y - block.height;
        const Spot top_left = room.min, top_right{right, room.min.y}, bottom_left{room.min.x, bottom},
                   bottom_right{right, bottom};
        // The figure stays in the middle and under its caption as far as the equations let it.
        struct Try {
            Spot corner;
            double across, down;
        };
        for (const Try& each :
             {Try{top_left, 0.5, 0}, Try{top_right, 0.5, 0}, Try{top_left, 0.75, 0}, Try{top_right, 0.25, 0}, Try{top_left, 1, 0},
              Try{top_right, 0, 0}, Try{bottom_right, 0.5, 0}, Try{bottom_left, 0.5, 0}, Try{bottom_right, 0, 0},
              Try{bottom_left, 1, 0}, Try{top_left, 0.5, 0.5}, Try{top_right, 0.5, 0.5}, Try{top_left, 1, 0.5},
              Try{top_right, 0, 0.5}, Try{top_left, 0.5, 1}, Try{top_right, 0.5, 1}, Try{top_left, 1, 1}, Try{top_right, 0, 1}}) {
            const Spot moved{room.min.x - figure.box.min.x + each.across * spare_x,
                             room.min.y - figure.box.min.y + each.down * spare_y};
            const Box box = rectangle(each.corner.x, each.corner.y, each.corner.x + block.width, each.corner.y + block.height);
            if (!is_free(spots, moved, box, clear)) continue;
            figure.move(moved.x, moved.y);
            set(marks, block, each.corner);
            return true;
        }
    }
    return false;
}

}  // namespace kinegraph::render
