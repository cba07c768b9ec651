// What the figures of all problems of contact, wear and impact begin and end with.
#pragma once

#include <string>
#include <variant>

#include "engine/solution/problem_solution.hpp"
#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// The problem and its solution, known to be of this kind.
template <class Problem>
const Problem& problem_of(const DrawingContext& context) {
    return std::get<Problem>(context.solution.mechanism.problem->of);
}
template <class Found>
const Found& solution_of(const DrawingContext& context) {
    return std::get<Found>(context.solution.problem->of);
}
/// A place or an arrow on paper, y downwards; `scale` for each mm.
inline Spot spot_of(const VectorOf<double>& v, double scale) { return {v.x / scale, -v.y / scale}; }
inline Spot spot_of(const Vector& v, double scale) { return spot_of(to_double(v), scale); }
/// A figure with its group opened; `scale` of `unit` for each mm.
Figure begun(const char* kind, const char* id, const Words& caption, double scale, const std::string& unit,
             Language language);
/// Its group closed, its labels placed within the room, its box at the origin.
Figure finished(Figure figure, const DrawingContext& context, Spot room);

}  // namespace kinegraph::render
