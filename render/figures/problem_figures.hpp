// Figures of problems that stand in place of joints.
#pragma once

#include <cstddef>

#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

// ----- The figures of a Hertzian contact: the bodies to scale, the pressure over the face of contact with its plan,
// the stresses below it.

/// The profiles of both bodies in the plane across the contact's shorter axis, with radii and force. Kind and id
/// "contact".
Figure hertz_bodies_figure(const DrawingContext& context, double room_x, double room_y);
/// The semi-ellipse of pressure across the contact, and below it the face of contact in plan at the same scale. Kind
/// and id "pressure".
Figure hertz_pressure_figure(const DrawingContext& context, double room_x, double room_y);
/// Stresses on the axis over the depth, with the greatest shear. Kind "plot", id "stresses".
Figure hertz_stress_figure(const DrawingContext& context, double room_x, double room_y);

// ----- The figures of an impact: the bodies with their velocities, the velocity plane, and Routh's diagram of
// impulses.

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

// ----- The figures of the motion of a point: the trajectory to scale with what is known at the instant; the hodograph;
// the centre of curvature by the altitude of a right triangle; the way, the speed and the components of the
// acceleration over the interval.

Figure trajectory_figure(const DrawingContext& context, double room_x, double room_y);
/// Without what is to be found.
Figure trajectory_question_figure(const DrawingContext& context, double room_x, double room_y);
Figure hodograph_figure(const DrawingContext& context, double room_x, double room_y);
Figure curvature_centre_figure(const DrawingContext& context, double room_x, double room_y);
Figure way_figure(const DrawingContext& context, double room_x, double room_y);
Figure speed_figure(const DrawingContext& context, double room_x, double room_y);
Figure components_figure(const DrawingContext& context, double room_x, double room_y);

// ----- The figures of motions in the large: a body in two positions with the bisectors and the pole; in three
// positions with the fixed pivots of two of its points.

/// The body in its positions alone.
Figure positions_question_figure(const DrawingContext& context, double room_x, double room_y);
Figure finite_displacement_figure(const DrawingContext& context, std::size_t displacement, double room_x,
                                  double room_y);
Figure pivots_figure(const DrawingContext& context, double room_x, double room_y);

// ----- The figures of a contact that wears by Reye's hypothesis.

/// A pad or block on its plane with the pressures below it and the centroid of their figure, found graphically; a
/// disc's face with its radii; a shoe in or on its drum with the pressures and their resultant. Kind and id "contact".
Figure reye_contact_figure(const DrawingContext& context, double room_x, double room_y);
/// The same as a question has it: without the pressures.
Figure reye_question_figure(const DrawingContext& context, double room_x, double room_y);
/// Pressure over the radius of a disc, worn in and new, or along a shoe. Kind "plot", id "pressures".
Figure reye_pressure_figure(const DrawingContext& context, double room_x, double room_y);

}  // namespace kinegraph::render
