// The solution step by step: each page adds one statement to its figure. New marks are in the accent colour, older ones
// grey; beside it stand the sentence with its equation, and the mechanism at small size.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// One page for each statement, by section. Primary centres, which only name the pairs, share pages; so does a
/// statement that neither draws nor reads anything, with its neighbour. A figure is drawn once, complete, and its marks
/// are revealed up to the statement of the page: nothing moves between pages. A page without new lines has in the
/// accent colour what the statement is read off. The last page is the closed polygon of forces. A solution without
/// statements gives one page with the mechanism.
std::vector<Page> lay_out_steps(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

/// What a page emphasises: the names of labels, `data-name`s and centres; groups.
struct Cited {
    std::set<std::string> names;
    std::set<GroupId> groups;
};
/// The marks of a figure that belong to no statement, or to one with `page_of` (page by statement) not after `page`.
/// Marks of `page`, and those that are `cited`, are in the accent colour; earlier ones are grey.
std::vector<Mark> revealed(const std::vector<Mark>& marks, const std::vector<std::size_t>& page_of, std::size_t page,
                           const Theme& theme, const Cited& cited = {});

}  // namespace kinegraph::render
