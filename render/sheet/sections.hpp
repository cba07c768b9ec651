// The text of the sheet: results, steps with their equations, bodies, forces, centres, mobility, remarks, each a section of rows
// set to the width of a column. Owns their order and headings; chooses no place.
#pragma once

#include <vector>

#include "render/sheet/figure_pages.hpp"
#include "render/sheet/sheet_parts.hpp"
#include "render/sheet/wanted_figures.hpp"

namespace kinegraph::render {

/// mm² that the text will take, roughly: enough to choose whether it shares a page with the figures.
double estimated_text(const Solution& solution, const SheetFormat& format);

/// All sections. What is known of a body's forces stands with its step, where the figure has it not, in rows that may be left
/// out.
std::vector<Section> write_sections(const DrawingContext& context, const SheetFormat& format, const WantedFigures& figures,
                                    const FigurePages& pages);
std::vector<Section> without_spare_rows(std::vector<Section> sections);

}  // namespace kinegraph::render
