// The figures of an impact: the bodies with their velocities, the velocity plane, and Routh's diagram of impulses.
#pragma once

#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// The bodies to scale with centres, line and plane of impact, and their velocities before. Kind and id "contact".
Figure impact_bodies_figure(const DrawingContext& context, double room_x, double room_y);
/// The same with the velocities afterwards. Kind "contact", id "contact-after".
Figure impact_after_figure(const DrawingContext& context, double room_x, double room_y);
/// Velocities of the centres before and after from one pole: what they gain is parallel to the impulse. Kind
/// "velocity", id "velocities".
Figure impact_velocities_figure(const DrawingContext& context, double room_x, double room_y);
/// The relative velocity of the points in contact before and after, along normal and tangent. Kind "velocity", id
/// "restitution".
Figure impact_restitution_figure(const DrawingContext& context, double room_x, double room_y);
/// Tangential over normal impulse: its path, the lines of sticking and of greatest compression, the limit of friction.
/// Kind "plot", id "routh".
Figure impact_routh_figure(const DrawingContext& context, double room_x, double room_y);
bool has_routh_figure(const DrawingContext& context);

}  // namespace kinegraph::render
