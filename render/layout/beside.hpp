// Places a block in a free corner beside a figure.
#pragma once

#include <vector>

#include "render/page/block.hpp"
#include "render/page/figure.hpp"

namespace kinegraph::render {

/// Moves the figure within the room and places the block in a free corner. False if no corner is free.
bool set_beside(std::vector<Mark>& marks, Figure& figure, const Block& block, const Box& room);

}  // namespace kinegraph::render
