// The figures: each of a Solution, drawn into a room.
#pragma once

#include <optional>
#include <vector>

#include "render/page/figure.hpp"
#include "render/page/labels.hpp"
#include "render/page/scale.hpp"
#include "render/scene/drawing_context.hpp"
#include "render/scene/polygon_scene.hpp"

namespace kinegraph::render {

/// The mechanism with pair symbols, ground, body numbers, centres and their lines where `with_centres`, fitted into a
/// room (mm).
Figure mechanism_figure(const DrawingContext& context, double room_x, double room_y, bool with_centres,
                        double coarsest = any_scale);
/// What it spans, with the centres that are near enough to be shown, m.
Box extent_of_mechanism(const Solution& solution, bool with_centres);
/// The mechanism with what turns: ω of the bodies (or α), each marked with the statement that finds it.
Figure mechanism_with_turnings(const DrawingContext& context, Symbol::Letter letter, double room_x, double room_y);
/// The mechanism as an exercise hands it out, at a scale (m for each mm): what its file gives as dimensions where they
/// are free within the room, drivers, loads and masses with their values; nothing that is found.
Figure exercise_figure(const DrawingContext& context, double scale, double room_x, double room_y);
/// mechanism_figure at the scale of `plain`, which it was drawn at without, with ω and α of the bodies, or with ω
/// alone, and with what the file gives of the drivers' accelerations. Empty and at any_scale where they find no room,
/// or would cost a name or a dimension its place.
Figure mechanism_with_found_turnings(const DrawingContext& context, const Figure& plain, Spot room, bool with_centres);
/// Velocities drawn on the mechanism, ⟂ to the rays from the absolute centres, and ω of its bodies. Kind "body", id
/// "velocities".
Figure velocities_on_mechanism(const DrawingContext& context, double room_x, double room_y);
/// Accelerations drawn on the mechanism, and α of its bodies. Kind "body", id "accelerations".
Figure accelerations_on_mechanism(const DrawingContext& context, double room_x, double room_y);
/// One body's act of motion: its points, velocities given (dark) and found (in the body's colour), the lines that meet
/// in the centre; where no rigid body moves so, the two projections. Kind and id "mechanism"; velocities are groups of
/// class "velocity" with a scale of their own, which the caption states. Only where the solution has one.
Figure act_of_motion_figure(const DrawingContext& context, double room_x, double room_y);
/// The curvature of one body's motion (index into Solution::curvature): pole, pole tangent, inflection circle, Bresse's
/// circles, osculating circles to scale. Kind "curvature", id "curvature-<body>".
Figure curvature_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y);
/// Whether there is more to see of it than a body that turns about a point at rest.
bool has_curvature_figure(const Curvature& found);
/// What the figure spans, m.
Box extent_of_curvature(const Solution& solution, std::size_t index);
/// The vector loops of the closure equations, drawn on the mechanism in grey (kind and id "loops"; each side is a group
/// of class "side"). Only where the solution has equations with sides.
Figure loops_figure(const DrawingContext& context, double room_x, double room_y);
bool has_loops_figure(const Solution& solution);
/// What it spans, m.
Box extent_of_loops(const Solution& solution);
/// Virtual displacements along the freedom `index` of Solution::displacements, with what acts (kind "displacements", id
/// "displacements" or "displacements-2" …; arrows are groups of classes "displacement" and "force").
Figure displacement_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y);
std::size_t displacement_figures(const Solution& solution);
std::string displacement_figure_name(std::size_t index);
/// Relative motion `index` of Solution::relative_motion taken apart: the moving axes on the mechanism, what their
/// observer sees of the point, and how Coriolis' term comes from it (kind and id "moving-axes", "moving-axes-2" …).
/// Only where has_moving_axes().
Figure moving_axes_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y);
bool has_moving_axes(const RelativeMotion& motion);
std::string moving_axes_name(const Solution& solution, std::size_t index);
/// The bookkeeping circle of the instant centres: bodies on a circle, centres as chords numbered in the order found.
Figure circle_diagram(const DrawingContext& context, double room_x, double room_y);
/// One polygon of motion, by its scene or its index in the protocol: pole, vectors, images, construction lines.
Figure polygon_figure(const DrawingContext& context, const PolygonScene& scene, double room_x, double room_y,
                      double coarsest = any_scale);
/// What the strokes of one take at a scale, mm: what any room for it must hold, letters apart.
Spot strokes_of_polygon(const DrawingContext& context, const PolygonScene& scene, double scale);
Figure polygon_figure(const DrawingContext& context, int polygon, double room_x, double room_y,
                      double coarsest = any_scale);

// Forces. Triangles and closed polygon share one scale: `least` is the smallest that the other could be drawn at (units
// per mm), and with `fixed` the one the file asks for, kept as long as it fits.

/// Whether there is a force polygon to draw, and how many.
bool has_force_polygons(const Solution& solution);
int force_polygon_count(const Solution& solution);
/// What the force polygons of the bodies span one beside the other, in the file's unit.
Box extent_of_forces(const Solution& solution);
/// What a free body spans with its places of attack and near points of concurrency, m.
Box extent_of_free_body(const Solution& solution, std::size_t index);
/// The mechanism with its lines of action, points of concurrency and the sense of loads, efforts and ground reactions.
/// `load`: the body whose loads alone the context's solution has (under_loads_alone); empty: all act.
Figure mechanism_with_forces(const DrawingContext& context, double room_x, double room_y, const std::string& load = "");
/// Whether it shows a point of concurrency; `of_several`: one that no body cut free shows, since its lines are of
/// several bodies.
bool has_meets(const Solution& solution, bool of_several);
/// The force polygons of the bodies at one scale; each is a group of kind "forces", id "forces-<body>". `tables`: with
/// what is known of each force below, where there is room; those of bodies taken together, too. `only`: that polygon
/// alone.
Figure force_polygons_figure(const DrawingContext& context, double room_x, double room_y,
                             std::optional<double> least = std::nullopt, bool fixed = false, bool tables = true,
                             int only = -1);
/// Of a superposition: the partial forces of each action, tip to tail, and their sum (kind "forces", id "sums").
Figure partial_sums_figure(const DrawingContext& context, double room_x, double room_y, std::optional<double> least,
                           bool fixed);
Box extent_of_partial_sums(const Solution& solution);
/// Of a free body, whether the figure has its polygon: two equal and opposite forces make none, the steps say so.
bool has_force_polygon(const Solution& solution, const FreeBody& body);
/// What the strokes of one of them take at a scale with its name and its bar, mm; `joined`: as closed polygon.
Spot strokes_of_force_polygon(const DrawingContext& context, int polygon, bool joined, double scale);
/// The polygons joined: external forces full, internal sides dashed.
Figure closed_polygon_figure(const DrawingContext& context, int polygon, double room_x, double room_y,
                             std::optional<double> least = std::nullopt, bool fixed = false);
/// A body cut free (index into Solution::free_bodies): kind "body", id "body-<name>"; its scale is that of its forces.
/// `at_pairs`: beside the one force of a sleeve or a clamp its force and couple at the pair, too. `load`: as of
/// mechanism_with_forces; the id ends in "-load-<load>" then. `shrinks`: to next to nothing, where it has no more room.
Figure free_body_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y,
                        bool at_pairs = true, const std::string& load = "", bool shrinks = true);

// Joukowsky's lever: forces at the tips of the velocities turned a quarter turn; their moments about the pole are the
// powers with the sign changed.

/// Why there is none.
enum class NoLever {
    drawn,          ///< there is one
    no_forces,      ///< no body was cut free
    no_velocities,  ///< nothing is driven, or not all velocities are known
    nothing_moves,  ///< no force acts at a point that moves
};
NoLever no_lever(const Solution& solution);
/// What the turned velocities span with the pole, in the file's unit of velocity.
Box extent_of_lever(const Solution& solution);
/// Kind "velocity", id "joukowsky"; forces are groups of class "force", with a scale of their own that the caption
/// states. Only where there is one.
Figure joukowsky_figure(const DrawingContext& context, double room_x, double room_y);

}  // namespace kinegraph::render
