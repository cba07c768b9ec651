// The sheet: lays out figures, equations, tables and steps of a solution on pages, without overlaps. What does not fit
// goes to further pages. Computes no mechanics.
#pragma once

#include <string>
#include <vector>

#include "render/content/sheet_options.hpp"
#include "render/page/page.hpp"
#include "render/text/text.hpp"
#include "render/text/words.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

/// The solution, the question or the key, by `options.kind`, on one or more pages.
std::vector<Page> lay_out(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

/// The results table as plain text for a terminal.
std::string results_table(const Solution& solution, Language language);

}  // namespace kinegraph::render
