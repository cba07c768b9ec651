// The flow of the text: sections into the runs that the figures leave, then into the columns of further pages, with the figures
// that stand there.
#pragma once

#include <vector>

#include "render/sheet/figure_pages.hpp"
#include "render/sheet/sheet_parts.hpp"

namespace kinegraph::render {

/// The pages of figures with all sections on them, and as many further ones as they take.
std::vector<Sheet> flow_text(const DrawingContext& context, const SheetFormat& format, WantedFigures& wanted,
                             const FigurePages& pages, std::vector<Section> sections);

}  // namespace kinegraph::render
