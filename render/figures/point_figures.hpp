// The figures of the motion of a point: the trajectory to scale with what is known at the instant; the hodograph; the
// centre of curvature by the altitude of a right triangle; the way, the speed and the components of the acceleration
// over the interval.
#pragma once

#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

Figure trajectory_figure(const DrawingContext& context, double room_x, double room_y);
/// Without what is to be found.
Figure trajectory_question_figure(const DrawingContext& context, double room_x, double room_y);
Figure hodograph_figure(const DrawingContext& context, double room_x, double room_y);
Figure curvature_centre_figure(const DrawingContext& context, double room_x, double room_y);
Figure way_figure(const DrawingContext& context, double room_x, double room_y);
Figure speed_figure(const DrawingContext& context, double room_x, double room_y);
Figure components_figure(const DrawingContext& context, double room_x, double room_y);

}  // namespace kinegraph::render
