// The mechanism of an exercise, placed where it stands on the solution's sheet.
#pragma once

#include "render/figures/figure.hpp"

namespace kinegraph::render {

/// Draws exercise_figure() in a given area. `within`: that area, mm, relative to the origin of its coordinates. Names,
/// arrows of loads and the scale bar stay in it if they find space; dimensions that would leave it are omitted (the
/// text contains all data).
Figure exercise_figure_within(const DrawingContext& context, double scale, const Box& within);

}  // namespace kinegraph::render
