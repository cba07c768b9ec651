// How a sheet is asked for: paper, language, look, what it says, what it is bound with.
#pragma once

#include <cstddef>
#include <string>

#include "render/content/sheet_parts.hpp"
#include "render/figures/figure.hpp"
#include "render/page/page.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

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
};

}  // namespace kinegraph::render
