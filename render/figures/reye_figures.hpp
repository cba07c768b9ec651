// The figures of a contact that wears by Reye's hypothesis.
#pragma once

#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// A pad or block on its plane with the pressures below it and the centroid of their figure, found graphically; a
/// disc's face with its radii; a shoe in or on its drum with the pressures and their resultant. Kind and id "contact".
Figure reye_contact_figure(const DrawingContext& context, double room_x, double room_y);
/// The same as a question has it: without the pressures.
Figure reye_question_figure(const DrawingContext& context, double room_x, double room_y);
/// Pressure over the radius of a disc, worn in and new, or along a shoe. Kind "plot", id "pressures".
Figure reye_pressure_figure(const DrawingContext& context, double room_x, double room_y);

}  // namespace kinegraph::render
