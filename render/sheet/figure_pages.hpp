// Pages of figures: every wanted figure in a cell with its caption and the equations beside it, and the runs that are left for
// text.
#pragma once

#include <set>
#include <vector>

#include "render/sheet/sheet_parts.hpp"
#include "render/sheet/wanted_figures.hpp"

namespace kinegraph::render {

struct FigurePages {
    std::vector<Sheet> sheets;
    std::vector<Figure> drawn;       ///< in the order wanted
    std::set<std::size_t> unplaced;  ///< figures whose equations stand with the steps
    std::size_t force_page = 0;      ///< where forces begin
};

/// How many figures the first page takes.
std::size_t most_on_first_page(const SheetFormat& format);
/// Whether a figure is not at the scale that the file asks for.
bool misses(const Wanted& wanted, const Figure& figure);

/// All figures; `text_area` mm² of the first page are kept from them, in one strip, where that can be.
FigurePages place_figures(const DrawingContext& context, const SheetFormat& format, WantedFigures& figures, double text_area);

}  // namespace kinegraph::render
