// The sheet: lays out figures, equations, tables and steps of a solution on pages, without overlaps. What does not fit
// goes to further pages. Computes no mechanics.
#pragma once

#include <string>
#include <vector>

#include "engine/mechanism/exercise.hpp"
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

/// False if a vector to be found in a polygon is shorter on the solution's sheet than `readable_length`. True if there
/// are no such vectors.
bool is_readable(const Solution& solution, Condition::Polygon polygon, const SheetOptions& options, const Fonts& fonts);

/// The catalogue of pairs, the facts of `kinegraph pairs`: a card for each pair in the plane and in space, then
/// closure, links, chains and multiple hinges, in rows on pages. Uses paper, orientation, language and theme of
/// `options`.
std::vector<Page> lay_out_catalogue(const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
