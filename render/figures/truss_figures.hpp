// The figures of a truss: the space diagram with Bow's letters, and the plan of its forces (Cremona). Bars look alike
// on both: tension and compression differ in colour, in weight and in line kind.
#pragma once

#include <optional>

#include "render/figures/figure.hpp"

namespace kinegraph::render {

/// What the space diagram spans, m; the plan, in the file's unit of force.
Box extent_of_truss(const Solution& solution);
Box extent_of_plan(const Solution& solution);
/// Kind and id "truss": bars by sense (groups of class "bar"), loads and reactions (of class "force"), letters of the
/// spaces, the line of what is given as one force, cuts with their arms.
Figure truss_figure(const DrawingContext& context, double room_x, double room_y);
/// Kind "closure", id "cremona": forces from outside with heads, every bar once without, corners with the letters of
/// the spaces.
Figure cremona_figure(const DrawingContext& context, double room_x, double room_y, std::optional<double> least,
                      bool fixed);
}  // namespace kinegraph::render
