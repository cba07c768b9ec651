// A figure alone, for a book: the page is the figure with a narrow margin, without frame, title block or caption.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// What may be asked for: mechanism, centres, the ids of the polygons, lines-of-action, forces, body-NAME … in the sheet's order.
std::vector<std::string> figure_names(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

/// The figure, at the scale of the file's or the largest that two columns of the paper hold. Nothing where no figure has that
/// name.
std::optional<Page> lay_out_alone(const Solution& solution, const SheetOptions& options, const std::string& name,
                                  const Fonts& fonts);

/// Any figure, the page cut to it.
Page page_of_figure(const DrawingContext& context, Figure figure);

}  // namespace kinegraph::render
