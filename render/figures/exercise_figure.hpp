// The mechanism as an exercise hands it out, where it stands beside the solution's: a place of its own on the paper.
#pragma once

#include "render/figures/figure.hpp"

namespace kinegraph::render {

/// exercise_figure in its place: `within`, mm about the origin of its coordinates, is what it may cover. Names, arrows
/// of loads and the scale bar stay in it as far as they find room there; dimensions that would leave it are left out
/// (the data are told in words).
Figure exercise_figure_within(const DrawingContext& context, double scale, const Box& within);

}  // namespace kinegraph::render
