// The solution as a sequence: every page adds one statement to the figure in which it is drawn. What is new is drawn in
// the accent, what stood before in grey; beside it the sentence with its equation, and the mechanism small.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// One page for each statement, section by section; primary centres, which only name the pairs, share pages, and a
/// statement that draws nothing and reads nothing off shares that of its neighbour. A figure is drawn once, finished,
/// and its marks are shown up to the page's statement: nothing moves from page to page. A page that adds no line has in
/// the accent what it is read off. The closed polygon of forces ends them; a solution without statements gives one page
/// with the mechanism.
std::vector<Page> lay_out_steps(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

/// Of a figure's marks those that belong to no statement, or to one that `page_of` (by statement) puts on `page` or
/// before. Those of `page` are in the accent, and so are those that carry a name `cited`; those from before are grey.
std::vector<Mark> revealed(const std::vector<Mark>& marks, const std::vector<std::size_t>& page_of, std::size_t page,
                           const Theme& theme, const std::set<std::string>& cited = {});

}  // namespace kinegraph::render
