// Blank rooms to draw in: for each polygon that is sought a grid as large as it needs, with its pole or its start.
#pragma once

#include <vector>

#include "render/content/title_block.hpp"
#include "render/figures/figure.hpp"

namespace kinegraph::render {

/// Rooms for all figures but the first, on as many sheets as they need behind those there are.
void add_blank_rooms(const DrawingContext& context, const SheetFormat& format, const std::vector<Figure>& figures,
                     std::vector<std::vector<Mark>>& sheets);

}  // namespace kinegraph::render
