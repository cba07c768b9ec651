// Blank areas of a question: for each polygon to be drawn, a grid of the necessary size with its pole or starting
// point.
#pragma once

#include <vector>

#include "render/content/title_block.hpp"
#include "render/figures/figure.hpp"

namespace kinegraph::render {

/// Adds areas for all figures but the first, on as many additional sheets as they need.
void add_blank_rooms(const DrawingContext& context, const SheetFormat& format, const std::vector<Figure>& figures,
                     std::vector<std::vector<Mark>>& sheets);

}  // namespace kinegraph::render
