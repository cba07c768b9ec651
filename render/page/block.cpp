// Blocks: see block.hpp.
#include "render/page/block.hpp"

#include <algorithm>

#include "render/page/shapes.hpp"

namespace kinegraph::render {

void set(std::vector<Mark>& marks, const Block& block, Spot at) {
    std::vector<Mark> moved = block.marks;
    move(moved, at.x, at.y);
    marks.insert(marks.end(), moved.begin(), moved.end());
}

Block arranged(const std::vector<Block>& blocks, bool in_a_row) {
    Block all;
    for (const Block& block : blocks) {
        std::vector<Mark> marks = block.marks;
        if (in_a_row) {
            if (all.width > 0) all.width += 7;
            move(marks, all.width, 0);
            all.width += block.width;
            all.height = std::max(all.height, block.height);
        } else {
            if (all.height > 0) all.height += 5;
            move(marks, 0, all.height);
            all.height += block.height;
            all.width = std::max(all.width, block.width);
        }
        all.marks.insert(all.marks.end(), marks.begin(), marks.end());
    }
    return all;
}

}  // namespace kinegraph::render
