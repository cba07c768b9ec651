// The table of extremes of a cycle, with a line each for strokes, change points and largest speeds.
#pragma once

#include <cstddef>
#include <vector>

#include "render/page/block.hpp"
#include "render/sheet/cycle_sheet.hpp"

namespace kinegraph::render {

/// The extremes of the plotted columns, `width` mm wide. No row begins below `most_height` mm.
Block cycle_extremes(const DrawingContext& context, const CycleTable& table,
                     const std::vector<std::vector<std::size_t>>& plots, double width, double most_height);

}  // namespace kinegraph::render
