// The figures of a Hertzian contact: the bodies to scale, the pressure over the face of contact with its plan, the
// stresses below it.
#pragma once

#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// The profiles of both bodies in the plane across the contact's shorter axis, with radii and force. Kind and id
/// "contact".
Figure hertz_bodies_figure(const DrawingContext& context, double room_x, double room_y);
/// The semi-ellipse of pressure across the contact, and below it the face of contact in plan at the same scale. Kind
/// and id "pressure".
Figure hertz_pressure_figure(const DrawingContext& context, double room_x, double room_y);
/// Stresses on the axis over the depth, with the greatest shear. Kind "plot", id "stresses".
Figure hertz_stress_figure(const DrawingContext& context, double room_x, double room_y);

}  // namespace kinegraph::render
