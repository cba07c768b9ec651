// The solution as a sequence: every page adds one statement to the figure in which it is drawn. What is new is drawn in the
// accent, what stood before in grey; beside it the sentence with its equation, and the mechanism small.
#pragma once

#include <vector>

#include "render/sheet.hpp"

namespace kinegraph::render {

/// One page for each statement, in the order of the protocol; primary centres, which only name the pairs, share pages. A figure
/// is drawn once, finished, and its marks are shown up to the page's statement: nothing moves from page to page. A solution
/// without statements gives one page with the mechanism.
std::vector<Page> lay_out_steps(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

/// Of a figure's marks those that belong to no statement, or to one that `page_of` (by statement) puts on `page` or before.
std::vector<Mark> revealed(const std::vector<Mark>& marks, const std::vector<std::size_t>& page_of, std::size_t page,
                           const Theme& theme);

}  // namespace kinegraph::render
