// Figures of a Solution. Each function draws one into a room (width and height in mm), at the finest scale that has
// room for its letters too, within the limits of a ScaleWish.
#pragma once

#include <optional>
#include <vector>

#include "render/figures/fit.hpp"
#include "render/page/figure.hpp"
#include "render/page/labels.hpp"
#include "render/page/scale.hpp"
#include "render/scene/drawing_context.hpp"
#include "render/scene/load_case.hpp"
#include "render/scene/polygon_scene.hpp"

namespace kinegraph::render {

/// The mechanism with pair symbols, ground, body numbers and, if `with_centres`, instant centres and their lines.
Figure mechanism_figure(const DrawingContext& context, double room_x, double room_y, bool with_centres,
                        const ScaleWish& wish = {});
/// Its extent with the centres that are near enough to be shown, m.
Box extent_of_mechanism(const Solution& solution, bool with_centres);
/// The mechanism with ω (or α) of its bodies, each marked with the statement that determines it.
Figure mechanism_with_turnings(const DrawingContext& context, Symbol::Letter letter, double room_x, double room_y);
/// The mechanism of an exercise at a given scale (m per mm): the dimensions in the file if they have space in the room,
/// drivers, loads and masses with their values. It shows no result.
Figure exercise_figure(const DrawingContext& context, double scale, double room_x, double room_y);
/// mechanism_figure() at the scale of `plain`, with ω and α of the bodies (or with ω alone) and the given accelerations
/// of the drivers. `plain`: the same figure without these. Empty and at any_scale if they have no room or would
/// displace a name or a dimension.
Figure mechanism_with_found_turnings(const DrawingContext& context, const Figure& plain, Spot room, bool with_centres);
/// Velocities on the mechanism, ⟂ to the rays from the absolute centres, and ω of its bodies. Kind "body", id
/// "velocities".
Figure velocities_on_mechanism(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish = {});
/// Accelerations on the mechanism, and α of its bodies. Kind "body", id "accelerations".
Figure accelerations_on_mechanism(const DrawingContext& context, double room_x, double room_y,
                                  const ScaleWish& wish = {});
/// The instantaneous motion of one body: its points, velocities given (dark) and found (in the colour of the body), and
/// the lines that meet in the centre; if no rigid body can move so, the two projections. Kind and id "mechanism";
/// velocities are groups of class "velocity" with a scale of their own in the caption. Requires that the solution has
/// such a motion.
Figure instantaneous_motion_figure(const DrawingContext& context, double room_x, double room_y,
                                   const ScaleWish& wish = {});
/// The curvature of the motion of a body (index into Solution::curvature): pole, pole tangent, inflection circle,
/// Bresse's circles, osculating circles to scale. Kind "curvature", id "curvature-<body>".
Figure curvature_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y,
                        const ScaleWish& wish = {});
/// The vector loops of the closure equations on the mechanism in grey (kind and id "loops"; each side is a group of
/// class "side"). Requires equations with sides.
Figure loops_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish = {});
/// Virtual displacements along freedom `index` of Solution::displacements, with the forces (kind "displacements", id
/// "displacements" or "displacements-2" …; arrows are groups of classes "displacement" and "force").
Figure displacement_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y,
                           const ScaleWish& wish = {});
/// Relative motion `index` of Solution::relative_motion: the moving axes on the mechanism, the motion of the point
/// relative to them, and the origin of Coriolis' term (kind and id "moving-axes", "moving-axes-2" …). Requires
/// has_moving_axes().
Figure moving_axes_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y,
                          const ScaleWish& wish = {});
bool has_moving_axes(const RelativeMotion& motion);
/// The circle diagram of the instant centres: bodies on a circle, centres as chords, numbered in the order in which
/// they are found.
Figure circle_diagram(const DrawingContext& context, double room_x, double room_y);
/// One polygon of motion, given by its scene or by its index in the protocol: pole, vectors, images, construction
/// lines.
Figure polygon_figure(const DrawingContext& context, const PolygonScene& scene, double room_x, double room_y,
                      const ScaleWish& wish = {});
Figure polygon_figure(const DrawingContext& context, int polygon, double room_x, double room_y,
                      const ScaleWish& wish = {});

// Forces. Triangles and closed polygon share one scale, by the wish that they are drawn with.

bool has_force_polygons(const LoadCase& loads);
/// The mechanism with lines of action, points of concurrency, and the sense of loads, input efforts and ground
/// reactions. `part`: of the superposition, whose loads act alone.
Figure mechanism_with_forces(const DrawingContext& context, double room_x, double room_y, int part = all_loads,
                             const ScaleWish& wish = {});
/// Whether it shows a point of concurrency. `of_several`: count only those that no free body shows, because their lines
/// belong to several bodies.
bool has_meets(const LoadCase& loads, bool of_several);
/// The force polygons of the bodies and of bodies taken together, at one scale; each is a group of kind "forces", id
/// "forces-<body>". `tables`: with a table of the known and unknown data of each force below, if there is space.
/// `only`: index of the single polygon to draw; −1: all. `part`: as for mechanism_with_forces().
Figure force_polygons_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish = {},
                             bool tables = true, int only = -1, int part = all_loads);
/// For a superposition: the partial forces of each action, tip to tail, and their sum (kind "forces", id "sums").
Figure partial_sums_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish = {});
/// For a superposition: the polygon of each body with its loads, its partial forces and their sums (kind "forces", id
/// "parts"). `only`: index of the single polygon to draw; −1: all.
Figure joined_parts_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish = {},
                           int only = -1);
/// Whether the figure shows the polygon of a free body. Two equal and opposite forces have none; the steps say so.
bool has_force_polygon(const LoadCase& loads, const FreeBody& body);
/// The closed polygon: the polygons joined, external forces solid, internal sides dashed.
Figure closed_polygon_figure(const DrawingContext& context, int polygon, double room_x, double room_y,
                             const ScaleWish& wish = {});
/// A free body (index into those of the load case): kind "body", id "body-<name>"; its scale is that of its forces.
/// `at_pairs`: for a sleeve or a clamp, also force and couple at the pair. `part`: as for mechanism_with_forces(); then
/// the id ends in "-load-<load>".
Figure free_body_figure(const DrawingContext& context, std::size_t index, double room_x, double room_y,
                        bool at_pairs = true, int part = all_loads, const ScaleWish& wish = {});

// Joukowsky's lever: forces at the tips of the velocities turned by a quarter turn. Their moments about the pole are
// the powers with opposite sign.

/// The reason why there is no lever.
enum class NoLever {
    drawn,          ///< there is one
    no_forces,      ///< no body was cut free
    no_velocities,  ///< no driver, or not all velocities are known
    nothing_moves,  ///< no force acts at a point that moves
};
NoLever no_lever(const Solution& solution);
/// Kind "velocity", id "joukowsky"; forces are groups of class "force", with a scale of their own in the caption.
/// Requires that no_lever() is `drawn`.
Figure joukowsky_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish = {});

/// Draws exercise_figure() in a given area. `within`: that area, mm, relative to the origin of its coordinates. Names,
/// arrows of loads and the scale bar stay in it if they find space; dimensions that would leave it are omitted (the
/// text contains all data).
Figure exercise_figure_within(const DrawingContext& context, double scale, const Box& within);

}  // namespace kinegraph::render
