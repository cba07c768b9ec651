// Captions: "Fig. 1  Mechanism and instant centres  1 : 5". Owns how a scale is written.
#pragma once

#include <vector>

#include "render/figures/figure.hpp"

namespace kinegraph::render {

/// A figure's scale as the caption says it, with what is drawn to another one.
RichText scale_words(const DrawingContext& context, const Figure& figure);
/// 1 : 5, of a figure in metres per mm.
std::string ratio_words(double scale, Language language);

/// On one line of `width` mm, or more where that is narrow, its top left at `at`; the height it takes.
double set_caption(std::vector<Mark>& marks, const DrawingContext& context, const Figure& figure, int number, Spot at,
                   double width);

}  // namespace kinegraph::render
