// Options of a sheet: paper, language, theme, content, and its place among other pages.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "render/content/kept_scales.hpp"
#include "render/content/sheet_parts.hpp"
#include "render/figures/figure.hpp"
#include "render/page/page.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

struct SheetOptions {
    Paper paper = Paper::a4;
    Language language = Language::en;
    Theme theme;
    bool joukowsky = false;  ///< with the lever figure if forces and velocities are known
    Orientation orientation = Orientation::landscape;
    Dimensions dimensions = Dimensions::automatic;         ///< of given data, on the mechanism figure
    std::string author = "", date = "";                    ///< for the title block; empty: none
    SolutionDetail detail = SolutionDetail::full;          ///< of a solution
    SuperposedLoads superposed = SuperposedLoads::joined;  ///< each: the full solution only
    SheetKind kind = SheetKind::solution;
    bool with_sentences = true;        ///< of slides: a film has them as captions
    int growing = 0;                   ///< of slides for a film: pictures before each, in which its new lines grow
    std::optional<KeptScales> kept{};  ///< of figures, as far as a page can hold them; none: those of this sheet alone
    bool grid = false;                 ///< a question has blank areas for its polygons, with pole and grid
    // Pages before and after these in the same document, and figures before.
    std::size_t pages_before = 0, pages_after = 0;
    int figures_before = 0;
};

}  // namespace kinegraph::render
