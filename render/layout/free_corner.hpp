// Places a block in a free corner beside a figure.
#pragma once

#include <vector>

#include "render/page/block.hpp"
#include "render/page/figure.hpp"

namespace kinegraph::render {

/// Moves the figure within the room and places the block in a free corner. False if no corner is free.
bool set_beside(std::vector<Mark>& marks, Figure& figure, const Block& block, const Box& room);

/// By how many mm a room must be wider than the figure for set_beside() to find a free corner; infinity if the block is
/// higher than the figure.
double width_beside(const Figure& figure, const Block& block);

}  // namespace kinegraph::render
