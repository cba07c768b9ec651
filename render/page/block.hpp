// Blocks: what is set and measured, to be moved to its place. They know no sheet and no figure.
#pragma once

#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

/// Something set and measured, mm, its top left at the origin.
struct Block {
    std::vector<Mark> marks;
    double width = 0, height = 0;
};
/// A block with its top left at a place.
void set(std::vector<Mark>& marks, Block block, Spot at);
/// The same text smaller or larger; figures are never scaled.
Block scaled(Block block, double factor);

}  // namespace kinegraph::render
