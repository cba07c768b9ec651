// The frames of a film: the mechanism in one position after another, beside the plots of its cycle.
#pragma once

#include <vector>

#include "render/figures/plot_figure.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// A position of the mechanism, solved.
struct FilmFrame {
    double at = 0;  ///< coordinate of the driver, or time of its law: what the plots are over
    Solution solution;
};

/// A page for each frame. The mechanism has the same scale and its frame the same place on all of them; at most two
/// plots stand beside it, in which a line shows the position. Of `ways` the paths of points are drawn.
std::vector<Page> lay_out_film(const std::vector<FilmFrame>& frames, const CycleTable& table,
                               const std::vector<std::vector<std::size_t>>& plots, const std::vector<Way>& ways,
                               const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
