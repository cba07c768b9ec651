// The table of a motion's extremes, and in a line each what else a reader wants of it: strokes, change points, largest
// speeds.
#pragma once

#include <cstddef>
#include <vector>

#include "render/page/block.hpp"
#include "render/sheet/cycle_sheet.hpp"

namespace kinegraph::render {

/// The extremes of the columns that are plotted, `width` mm wide; no row begins below `most_height`.
Block cycle_extremes(const DrawingContext& context, const CycleTable& table,
                     const std::vector<std::vector<std::size_t>>& plots, double width, double most_height);

}  // namespace kinegraph::render
