// A laid out sheet with the final positions of its figures. Question and key use the positions of the solution.
#pragma once

#include <vector>

#include "render/content/sheet_options.hpp"
#include "render/page/page.hpp"
#include "render/text/text.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

struct DrawnSheet {
    std::vector<Page> pages;
    std::vector<Figure> figures;  ///< in the order of their numbers, at their positions on the page
    Spot caption;                 ///< of figure 1: its top left corner
    double caption_width = 0;     ///< of figure 1: the width for it, mm
};

/// The scales of its figures.
KeptScales scales_of_solution(const Solution& solution, const SheetOptions& options, const Fonts& fonts);
/// The worked solution, with the detail of the options.
DrawnSheet draw_solution(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
