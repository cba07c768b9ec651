// The table of the figures of a mechanism, a row for each kind. A new figure is the file that draws it, and here its
// enumerator, its functions and its row.
#pragma once

#include <array>

#include "lang/keys/sheet.hpp"
#include "render/figures/figure_kinds.hpp"

namespace kinegraph::render {

/// In the order of the table, which is that of the list. Where a solution has several, FigureId::of is the index of
/// what is named here.
enum class FigureKind : std::uint8_t {
    mechanism,             ///< without instant centres
    centres,               ///< the mechanism with them
    velocity_polygon,      ///< a polygon of the protocol
    acceleration_polygon,  ///< a polygon of the protocol
    curvature,             ///< a member of Solution::curvature
    truss,                 ///< its space diagram
    force_plan,            ///< Cremona's
    lines_of_action,       ///< on the mechanism
    forces,                ///< the polygons of all bodies, in rows
    forces_of_body,        ///< a free body
    forces_together,       ///< a member of Solution::taken_together
    partial_sums,          ///< of a superposition
    joined_parts,          ///< of a superposition: the polygons of all bodies with their partial forces
    joined_parts_of_body,  ///< such a polygon of the protocol
    closed_polygon,        ///< a polygon of the protocol
    free_body,             ///< a free body of the load case
    lever,                 ///< Joukowsky's
    loops,                 ///< of the closure equations
    moving_axes,           ///< a relative motion
    displacements,         ///< a freedom of the virtual displacements
    velocities,            ///< on the mechanism
    accelerations,         ///< on the mechanism
    circle_diagram,        ///< of the instant centres
    joint_graph,           ///< bodies and joints as nodes and lines
    omega,                 ///< the mechanism with angular velocities
    alpha,                 ///< … with angular accelerations
};

// In the files of the figures.
extern const FigureFunctions mechanism_functions, centres_functions, velocity_polygon_functions,
    acceleration_polygon_functions, curvature_functions, truss_functions, force_plan_functions,
    lines_of_action_functions, forces_functions, forces_of_body_functions, forces_together_functions,
    partial_sums_functions, joined_parts_functions, joined_parts_of_body_functions, closed_polygon_functions,
    free_body_functions, lever_functions, loops_functions, moving_axes_functions, displacements_functions,
    velocities_functions, accelerations_functions, circle_diagram_functions, joint_graph_functions;

/// What rows have in common.
namespace figure_columns {

// FigureRow::rest.
std::string name_of_polygon(const Solution& solution, FigureId id);
std::string name_of_curvature(const Solution& solution, FigureId id);
std::string name_of_member(const Solution& solution, FigureId id);
std::string name_of_group(const Solution& solution, FigureId id);
std::string name_of_free_body(const Solution& solution, FigureId id);
std::string name_of_loads(const Solution& solution, FigureId id);
std::string name_of_lines(const Solution& solution, FigureId id);
std::string number_of_freedom(const Solution& solution, FigureId id);
std::string number_of_axes(const Solution& solution, FigureId id);

using Needed = FigureTraits::Needed;
constexpr FigureTraits lengths{.measured = QuantityKind::length, .needed = Needed::always};
constexpr FigureTraits velocities{.measured = QuantityKind::velocity, .needed = Needed::velocities};
constexpr FigureTraits accelerations{.measured = QuantityKind::acceleration, .needed = Needed::accelerations};
constexpr FigureTraits forces{.measured = QuantityKind::force, .needed = Needed::forces};
constexpr FigureTraits bars{.measured = QuantityKind::force, .needed = Needed::forces, .has_bars = true};
constexpr FigureTraits on_bodies{.lists_scale = false};

constexpr SizeWanted of_motion{.least = 16, .enough = 110, .weight = 1.5};
constexpr SizeWanted of_forces{.least = 0, .enough = 110, .to_force_scale = true};
constexpr SizeWanted single_of_forces{.least = 0, .enough = 110, .to_force_scale = true, .may_be_larger = true};
constexpr SizeWanted row_of_forces{.least = 0, .enough = 110, .to_force_scale = true, .is_row = true};
constexpr SizeWanted of_body{.rim_x = 14, .rim_y = 20, .least = 10, .enough = 80, .weight = 0.6, .arrow = 20};
constexpr SizeWanted of_circle{.rim_x = 13, .rim_y = 13, .weight = 0.03, .spare = true, .fills = true};

using Marks = InPage::Marks;
using Tasks = InPage::Tasks;
constexpr InPage in_velocities{.layer = "velocities"};
constexpr InPage in_accelerations{.layer = "accelerations"};
constexpr InPage in_forces{.layer = "forces", .tasks = Tasks::forces};
constexpr InPage of_one_body{.layer = "forces", .tasks = Tasks::forces, .is_of_one = true};
constexpr InPage sums_of_loads{.tasks = Tasks::forces};

}  // namespace figure_columns

inline constexpr std::array figure_table{
    FigureRow{.kind = FigureKind::mechanism,
              .key = "mechanism",
              .data_figure = "mechanism",
              .caption = lang::sheet::mechanism,
              .traits = figure_columns::lengths,
              .scales = {"mechanism"},
              .in_page = {.layer = "", .is_mechanism = true, .is_stacked = true},
              .by = &mechanism_functions},
    FigureRow{.kind = FigureKind::centres,
              .key = "centres",
              .plain = FigureKind::mechanism,
              .svg_id = "mechanism",
              .data_figure = "mechanism",
              .caption = lang::sheet::mechanism_and_instant_centres,
              .traits = figure_columns::lengths,
              .scales = {"mechanism"},
              .in_page = {.layer = "centres", .is_mechanism = true, .is_stacked = true},
              .by = &centres_functions},
    FigureRow{.kind = FigureKind::velocity_polygon,
              .rest = figure_columns::name_of_polygon,
              .data_figure = "velocity",
              .caption = lang::sheet::velocity_polygon,
              .traits = figure_columns::velocities,
              .scales = {"velocity"},
              .size = figure_columns::of_motion,
              .in_page = figure_columns::in_velocities,
              .by = &velocity_polygon_functions},
    FigureRow{.kind = FigureKind::acceleration_polygon,
              .rest = figure_columns::name_of_polygon,
              .data_figure = "acceleration",
              .caption = lang::sheet::acceleration_polygon,
              .traits = figure_columns::accelerations,
              .scales = {"acceleration"},
              .size = figure_columns::of_motion,
              .in_page = figure_columns::in_accelerations,
              .by = &acceleration_polygon_functions},
    FigureRow{.kind = FigureKind::curvature,
              .key = "curvature",
              .rest = figure_columns::name_of_curvature,
              .data_figure = "curvature",
              .caption = lang::sheet::curvature_of_body,
              .size = {.least = 48, .weight = 1.5},
              .in_page = {.layer = "curvature", .is_stacked = true, .marks = figure_columns::Marks::always_said},
              .by = &curvature_functions},
    FigureRow{
        .kind = FigureKind::truss,
        .key = "truss",
        .data_figure = "truss",
        .caption = lang::sheet::truss,
        .traits = {.needed = FigureTraits::Needed::always},
        .scales = {"mechanism"},
        .in_page = {.layer = "forces", .is_stacked = true, .marks = figure_columns::Marks::if_said, .may_rest = true},
        .by = &truss_functions},
    // It needs space for its letters, independently of the other polygons.
    FigureRow{.kind = FigureKind::force_plan,
              .key = "cremona",
              .data_figure = "closure",
              .caption = lang::sheet::cremona,
              .traits = figure_columns::bars,
              .scales = {"closure", "forces"},
              .size = {.least = 40, .enough = 110, .weight = 1.2},
              .in_page = {.layer = "forces"},
              .by = &force_plan_functions},
    FigureRow{.kind = FigureKind::lines_of_action,
              .key = "lines",
              .rest = figure_columns::name_of_lines,
              .svg_id = "mechanism",
              .data_figure = "mechanism",
              .caption = lang::sheet::mechanism_and_lines_of_action,
              .traits = figure_columns::lengths,
              .scales = {"mechanism"},
              .in_page = {.layer = "forces", .is_stacked = true, .marks = figure_columns::Marks::always_said},
              .by = &lines_of_action_functions},
    FigureRow{.kind = FigureKind::forces,
              .key = "forces",
              .rest = figure_columns::name_of_loads,
              .data_figure = "forces",
              .traits = figure_columns::forces,
              .scales = {"forces", "closure"},
              .size = figure_columns::row_of_forces,
              .in_page = figure_columns::in_forces,
              .by = &forces_functions},
    FigureRow{.kind = FigureKind::forces_of_body,
              .key = "forces",
              .rest = figure_columns::name_of_member,
              .svg_id = "forces",
              .data_figure = "forces",
              .traits = figure_columns::forces,
              .scales = {"forces", "closure"},
              .size = figure_columns::single_of_forces,
              .in_page = figure_columns::of_one_body,
              .by = &forces_of_body_functions},
    FigureRow{.kind = FigureKind::forces_together,
              .rest = figure_columns::name_of_group,
              .svg_id = "forces",
              .data_figure = "forces",
              .traits = figure_columns::forces,
              .scales = {"forces", "closure"},
              .size = figure_columns::single_of_forces,
              .in_page = figure_columns::of_one_body,
              .by = &forces_together_functions},
    FigureRow{.kind = FigureKind::partial_sums,
              .key = "sums",
              .data_figure = "forces",
              .caption = lang::sheet::sums_of_partial_forces,
              .traits = figure_columns::forces,
              .scales = {"forces", "closure"},
              .size = figure_columns::row_of_forces,
              .by = &partial_sums_functions},
    FigureRow{.kind = FigureKind::joined_parts,
              .key = "parts",
              .data_figure = "forces",
              .caption = lang::sheet::force_polygons_by_loads,
              .traits = figure_columns::forces,
              .scales = {"forces", "closure"},
              .size = figure_columns::row_of_forces,
              .in_page = figure_columns::sums_of_loads,
              .by = &joined_parts_functions},
    FigureRow{.kind = FigureKind::joined_parts_of_body,
              .rest = figure_columns::name_of_polygon,
              .svg_id = "parts",
              .data_figure = "forces",
              .caption = lang::sheet::force_polygon_by_loads,
              .traits = figure_columns::forces,
              .scales = {"forces", "closure"},
              .size = figure_columns::single_of_forces,
              .in_page = figure_columns::sums_of_loads,
              .by = &joined_parts_of_body_functions},
    FigureRow{.kind = FigureKind::closed_polygon,
              .rest = figure_columns::name_of_polygon,
              .data_figure = "closure",
              .caption = lang::sheet::closed_force_polygon,
              .traits = figure_columns::forces,
              .scales = {"closure", "forces"},
              .size = figure_columns::of_forces,
              .in_page = {.layer = "forces", .tasks = figure_columns::Tasks::none},
              .by = &closed_polygon_functions},
    FigureRow{.kind = FigureKind::free_body,
              .rest = figure_columns::name_of_free_body,
              .data_figure = "body",
              .traits = figure_columns::on_bodies,
              .scales = {"body"},
              .size = figure_columns::of_body,
              .in_page = {.layer = "bodies", .marks = figure_columns::Marks::always_said},
              .by = &free_body_functions},
    FigureRow{.kind = FigureKind::lever,
              .key = "joukowsky",
              .data_figure = "velocity",
              .caption = lang::sheet::lever,
              .traits = figure_columns::velocities,
              .size = {.least = 20},
              .in_page = {.layer = "lever", .marks = figure_columns::Marks::always_said, .is_lever = true},
              .by = &lever_functions},
    FigureRow{.kind = FigureKind::loops,
              .key = "loops",
              .data_figure = "loops",
              .caption = lang::sheet::loops_on_the_mechanism,
              .traits = {.names_unknowns = true},
              .size = {.least = 64, .weight = 1.5},
              .in_page = {.marks = figure_columns::Marks::if_said},
              .by = &loops_functions},
    FigureRow{.kind = FigureKind::moving_axes,
              .key = "moving-axes",
              .rest = figure_columns::number_of_axes,
              .caption = lang::sheet::moving_axes,
              .in_page = {.marks = figure_columns::Marks::if_said},
              .by = &moving_axes_functions},
    FigureRow{.kind = FigureKind::displacements,
              .key = "displacements",
              .rest = figure_columns::number_of_freedom,
              .data_figure = "displacements",
              .caption = lang::sheet::virtual_displacements,
              .traits = {.needed = FigureTraits::Needed::forces},
              .in_page = {.marks = figure_columns::Marks::if_said},
              .by = &displacements_functions},
    FigureRow{.kind = FigureKind::velocities,
              .key = "velocities",
              .data_figure = "body",
              .caption = lang::sheet::velocities_on_the_mechanism,
              .traits = figure_columns::on_bodies,
              .in_page = {.layer = "velocities", .is_mechanism = true, .is_stacked = true, .vectors_like = "velocity"},
              .by = &velocities_functions},
    FigureRow{.kind = FigureKind::accelerations,
              .key = "accelerations",
              .data_figure = "body",
              .caption = lang::sheet::accelerations_on_the_mechanism,
              .traits = figure_columns::on_bodies,
              .size = {.spare = true},
              .in_page = figure_columns::in_accelerations,
              .by = &accelerations_functions},
    FigureRow{.kind = FigureKind::circle_diagram,
              .key = "circle-diagram",
              .data_figure = "centres",
              .caption = lang::sheet::circle_diagram,
              .size = figure_columns::of_circle,
              .by = &circle_diagram_functions},
    FigureRow{.kind = FigureKind::joint_graph,
              .key = "joint-graph",
              .data_figure = "joint-graph",
              .caption = lang::sheet::joint_graph,
              .size = {.spare = true},
              .by = &joint_graph_functions},
    FigureRow{.kind = FigureKind::omega, .key = "omega", .svg_id = "mechanism", .data_figure = "mechanism"},
    FigureRow{.kind = FigureKind::alpha, .key = "alpha", .svg_id = "mechanism", .data_figure = "mechanism"},
};

}  // namespace kinegraph::render
