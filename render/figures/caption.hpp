// Captions: "Fig. 1  Mechanism and instant centres  1 : 5". Owns how a scale is written.
#pragma once

#include <vector>

#include "render/figures/figure.hpp"

namespace kinegraph::render {

/// The scale of a figure in its caption, with that of what is drawn at another scale.
RichText scale_words(const DrawingContext& context, const Figure& figure);
/// 1 : 5, for a scale in metres per mm.
std::string ratio_words(double scale, Language language);

/// Sets the caption on one line of `width` mm, or on more if that is too narrow, with its top left at `at`. Returns its
/// height, mm.
double set_caption(std::vector<Mark>& marks, const DrawingContext& context, const Figure& figure, int number, Spot at,
                   double width);

/// The width of a caption in one line, mm.
double caption_width(const DrawingContext& context, const Figure& figure, int number);
/// The same with the scale on lines below.
double caption_width_without_scale(const DrawingContext& context, const Figure& figure, int number);

}  // namespace kinegraph::render
