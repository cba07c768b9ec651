// Beside a figure: a block in a corner of its room that it leaves free.
#pragma once

#include <vector>

#include "render/page/block.hpp"
#include "render/page/figure.hpp"

namespace kinegraph::render {

/// The figure is moved within the room, and the block set into a corner that it leaves free; false where there is none.
bool set_beside(std::vector<Mark>& marks, Figure& figure, const Block& block, const Box& room);

}  // namespace kinegraph::render
