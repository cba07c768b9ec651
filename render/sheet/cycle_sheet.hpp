// The sheet of a cycle: the mechanism with its way, the extremes of the motion as a table, and plots, on one page or
// more. Apart from the sheets of single positions; takes figures as they come.
#pragma once

#include <vector>

#include "render/figures/plot_figure.hpp"
#include "render/sheet/cam_notes.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// Plots are lists of columns (indices) that share a unit, four at most each. Of a cam (`cam` is not null) the first
/// page has the figure in a column of its own, the data beside it; `cam` holds a caption for each plot.
std::vector<Page> lay_out_cycle(const Solution& drawn, const CycleTable& table,
                                const std::vector<std::vector<std::size_t>>& plots, const std::vector<Way>& ways,
                                const SheetOptions& options, const Fonts& fonts, const CamNotes* cam = nullptr);

}  // namespace kinegraph::render
