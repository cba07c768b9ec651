// The sheet of a cycle: the mechanism with its paths, the table of extremes, and plots. Uses a fixed layout, not the
// page plan of single positions.
#pragma once

#include <cstddef>
#include <vector>

#include "render/figures/plot_figure.hpp"
#include "render/page/block.hpp"
#include "render/sheet/cam_notes.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// A plot is a list of at most four columns (indices) with the same unit. For a cam (`cam` is not null) the figure has
/// a column of its own on the first page, with the data beside it; `cam` has a caption for each plot.
std::vector<Page> lay_out_cycle(const Solution& drawn, const CycleTable& table,
                                const std::vector<std::vector<std::size_t>>& plots, const std::vector<Way>& ways,
                                const SheetOptions& options, const Fonts& fonts, const CamNotes* cam = nullptr);

/// The table of extremes: a line each for strokes, change points and largest speeds of the plotted columns, `width` mm
/// wide. No row begins below `most_height` mm.
Block cycle_extremes(const DrawingContext& context, const CycleTable& table,
                     const std::vector<std::vector<std::size_t>>& plots, double width, double most_height);

}  // namespace kinegraph::render
