// Figures of problems that a file states instead of joints. Room in mm.
#pragma once

#include <cstddef>

#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

// ----- A Hertzian contact: the bodies to scale, the pressure over the contact area with its plan, the stresses below.

/// The profiles of both bodies in the plane across the contact's shorter axis, with radii and force. Kind and id
/// "contact".
Figure hertz_bodies_figure(const DrawingContext& context, double room_x, double room_y);
/// The semi-ellipse of pressure across the contact, and below it the plan of the contact area at the same scale. Kind
/// and id "pressure".
Figure hertz_pressure_figure(const DrawingContext& context, double room_x, double room_y);
/// Stresses on the axis over the depth, with the maximum shear stress. Kind "plot", id "stresses".
Figure hertz_stress_figure(const DrawingContext& context, double room_x, double room_y);

// ----- An impact: the bodies with their velocities, the velocity plane, and Routh's diagram of impulses.

/// The bodies to scale with centres, line and plane of impact, and the velocities before the impact. Kind and id
/// "contact".
Figure impact_bodies_figure(const DrawingContext& context, double room_x, double room_y);
/// The same with the velocities after the impact. Kind "contact", id "contact-after".
Figure impact_after_figure(const DrawingContext& context, double room_x, double room_y);
/// Velocities of the centres before and after, from one pole: their changes are parallel to the impulse. Kind
/// "velocity", id "velocities".
Figure impact_velocities_figure(const DrawingContext& context, double room_x, double room_y);
/// Relative velocity of the points in contact before and after, along normal and tangent. Kind "velocity", id
/// "restitution".
Figure impact_restitution_figure(const DrawingContext& context, double room_x, double room_y);
/// Tangential over normal impulse: the path, the lines of sticking and of maximum compression, the friction limit. Kind
/// "plot", id "routh".
Figure impact_routh_figure(const DrawingContext& context, double room_x, double room_y);
bool has_routh_figure(const DrawingContext& context);

// ----- The motion of a point: the trajectory to scale with the known quantities of the instant; the hodograph; the
// centre of curvature by the altitude of a right triangle; path length, speed and components of the acceleration over
// the interval.

Figure trajectory_figure(const DrawingContext& context, double room_x, double room_y);
/// Without the quantities to be found.
Figure trajectory_question_figure(const DrawingContext& context, double room_x, double room_y);
Figure hodograph_figure(const DrawingContext& context, double room_x, double room_y);
Figure curvature_centre_figure(const DrawingContext& context, double room_x, double room_y);
Figure way_figure(const DrawingContext& context, double room_x, double room_y);
Figure speed_figure(const DrawingContext& context, double room_x, double room_y);
Figure components_figure(const DrawingContext& context, double room_x, double room_y);

// ----- Finite displacements: a body in two positions with the bisectors and the pole; in three positions with the
// fixed pivots of two of its points.

/// Only the body in its positions.
Figure positions_question_figure(const DrawingContext& context, double room_x, double room_y);
Figure finite_displacement_figure(const DrawingContext& context, std::size_t displacement, double room_x,
                                  double room_y);
Figure pivots_figure(const DrawingContext& context, double room_x, double room_y);

// ----- A contact with wear by Reye's hypothesis.

/// A pad or block on its plane with the pressures below it and their centroid, found graphically; the face of a disc
/// with its radii; a shoe in or on its drum with the pressures and their resultant. Kind and id "contact".
Figure reye_contact_figure(const DrawingContext& context, double room_x, double room_y);
/// The same for a question: without the pressures.
Figure reye_question_figure(const DrawingContext& context, double room_x, double room_y);
/// Pressure over the radius of a disc, new and worn in, or along a shoe. Kind "plot", id "pressures".
Figure reye_pressure_figure(const DrawingContext& context, double room_x, double room_y);

}  // namespace kinegraph::render
