// A sheet drawn, with its figures where they stand: what a question and a key have in common with the solution.
#pragma once

#include <vector>

#include "engine/solution/solution.hpp"
#include "render/content/sheet_options.hpp"
#include "render/page/page.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

struct DrawnSheet {
    std::vector<Page> pages;
    std::vector<Figure> figures;  ///< in the order of their numbers, each where it stands on its page
    Spot caption;                 ///< of the first: its top left corner …
    double caption_width = 0;     ///< … and the room it has
    bool keeps_to_rooms = true;   ///< no figure takes more than was planned for it
};

/// The worked solution, in the detail asked for.
DrawnSheet draw_solution(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
