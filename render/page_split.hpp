// How the room of a page is split among figures: all columns and rows of cells, valued by the size of what they would hold.
#pragma once

#include <optional>
#include <vector>

#include "render/sheet_parts.hpp"
#include "render/wanted_figures.hpp"

namespace kinegraph::render {

/// Cells of a page, columns of them or rows.
struct Split {
    std::vector<Box> cells;
    double value = -1e300;
};

/// What a figure of this size (mm) is worth: in steps of the scale, and small ones hardly anything.
double use_of(double size);
/// How large a figure would be drawn in a cell, and what that is worth. `force_scale`: as WantedFigures has it.
double worth(const Wanted& wanted, const Box& cell, std::optional<double> force_scale);
/// The split of an area among `count` figures from `first` on that is worth most, no cell over the title block.
Split best_split(const WantedFigures& figures, std::size_t first, std::size_t count, const Box& area, const SheetFormat& format);

}  // namespace kinegraph::render
