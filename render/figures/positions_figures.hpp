// The figures of motions in the large: a body in two positions with the bisectors and the pole; in three positions with
// the fixed pivots of two of its points.
#pragma once

#include <cstddef>

#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// The body in its positions alone.
Figure positions_question_figure(const DrawingContext& context, double room_x, double room_y);
Figure finite_displacement_figure(const DrawingContext& context, std::size_t displacement, double room_x,
                                  double room_y);
Figure pivots_figure(const DrawingContext& context, double room_x, double room_y);

}  // namespace kinegraph::render
