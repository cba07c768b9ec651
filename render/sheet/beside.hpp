// Beside a figure: where in a room the figure stands, and a block in a corner that it leaves free.
#pragma once

#include <array>
#include <vector>

#include "render/figures/figure.hpp"
#include "render/page/block.hpp"

namespace kinegraph::render {

/// A figure into the middle of a room across, and under its caption: what is left stays in one piece.
void centre(Figure& figure, const Box& room);
/// The first of the blocks that finds a corner of the room which the figure leaves free: the figure is moved, the block set.
bool set_beside(std::vector<Mark>& marks, Figure& figure, const std::array<Block, 2>& blocks, const Box& room);

}  // namespace kinegraph::render
