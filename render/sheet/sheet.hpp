// The sheet: figures, equations, tables and steps of a solution laid out on pages, nothing overlapping, nothing cut; what does
// not fit goes to further pages. Computes no mechanics.
#pragma once

#include <string>
#include <vector>

#include "engine/solution.hpp"
#include "render/figures/figure.hpp"
#include "render/page/page.hpp"
#include "render/sheet/sheet_parts.hpp"
#include "render/text/text.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

class Crew;

struct SheetOptions {
    Paper paper = Paper::a4;
    Language language = Language::en;
    Theme theme;
    bool joukowsky = false;  ///< with the lever figure, where forces and velocities are known
    Orientation orientation = Orientation::landscape;
    Dimensions dimensions = Dimensions::automatic;  ///< of the given data, on the mechanism figure
    std::string author = "", date = "";             ///< in the title block as given, where given
    SolutionDetail detail = SolutionDetail::full;   ///< of a solution
    SheetKind kind = SheetKind::solution;
    bool grid = false;  ///< a question has blank rooms for its polygons, with pole and grid
    // What is bound with these pages: how many come before and after them, and how many figures before.
    std::size_t pages_before = 0, pages_after = 0;
    int figures_before = 0;
    Crew* crew = nullptr;  ///< draws figures side by side, where there is one; the sheet is the same
};

/// The worked solution, the question or the key, as asked for, on one or more pages.
std::vector<Page> lay_out(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

/// The results table as plain text for a terminal.
std::string results_table(const Solution& solution, Language language);

}  // namespace kinegraph::render
