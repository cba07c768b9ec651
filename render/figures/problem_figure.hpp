// Common parts of the figures of all problems: begin and end of a figure.
#pragma once

#include <string>
#include <vector>

#include "engine/solution/problem_solution.hpp"
#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// The problem and its solution. Require that the context has this kind.
template <class Data>
const Data& problem_of(const DrawingContext& context) {
    return context.solution.mechanism.problem->as<Data>();
}
template <class Found>
const Found& solution_of(const DrawingContext& context) {
    return context.solution.problem->as<Found>();
}
/// A position or an arrow on paper, mm, y downwards; `scale` per mm.
inline Spot spot_of(const VectorOf<double>& v, double scale) { return {v.x / scale, -v.y / scale}; }
inline Spot spot_of(const Vector& v, double scale) { return spot_of(to_double(v), scale); }
/// A figure with an open group; `scale` of `unit` per mm.
Figure begun(const char* kind, const char* id, const Words& caption, double scale, const std::string& unit,
             Language language);
/// Closes the group, places the labels within the room and moves the box to the origin.
Figure finished(Figure figure, const DrawingContext& context, Spot room);
/// A pin on a hatched triangle, as ISO 3952 has it; `down`: the unit vector from the pin to the wall.
void draw_pivot_on_frame(std::vector<Mark>& marks, Spot pin, Spot down, Colour colour, const Theme& theme);

}  // namespace kinegraph::render
