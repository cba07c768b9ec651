// The figures of a truss: the space diagram with Bow's notation, and the force plan (Cremona). Bars have the same style
// in both: tension and compression differ in colour, width and line kind.
#pragma once

#include <array>

#include "render/figures/figure.hpp"

namespace kinegraph::render {

/// Kind and id "truss": bars by sense (groups of class "bar"), loads and reactions (of class "force"), letters of the
/// spaces, the line of the resultant of given forces, cuts with their lever arms.
Figure truss_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish = {});
/// Kind "closure", id "cremona": external forces with heads, each bar once and without a head, corners with the letters
/// of the spaces.
Figure cremona_figure(const DrawingContext& context, double room_x, double room_y, const ScaleWish& wish = {});
/// Of bars in compression, without force, in tension, in the space diagram.
std::array<Pen, 3> pens_of_bars(const Theme& theme);
}  // namespace kinegraph::render
