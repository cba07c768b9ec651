// Chapters of prose and formulas beside the closure equations: relative motion taken apart, virtual work, motion of a
// point.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/file/words.hpp"
#include "engine/solution/displacements.hpp"
#include "engine/solution/solution.hpp"
#include "render/equations/equation_text.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

// ----- A relative motion taken apart: the transport about the origin of the moving axes, Poisson's formulae, what the
// observer sees in his axes, and Coriolis' term with its sense, or why there is none. Items as those of the equations.

/// Of Solution::relative_motion[index], which has its `apart`.
std::vector<EquationItem> apart_items(const Solution& solution, std::size_t index, Language language);

// ----- Virtual work as it is worked by hand: what is displaced, forces and displacements in a table, the sum, the
// efforts; and the same by the velocity ratios of the closure equations. Items as those of the equations, which the
// sheet sets. Takes every number from the displacements.

/// Nothing where they are not asked for; where there are none, why.
std::vector<EquationItem> virtual_work_items(const Solution& solution, Language language);

/// "δθ_3", "δs_D": the coordinate that is displaced.
RichText displaced_coordinate(const Mechanism& mechanism, const Driver& driver);

// ----- The motion of a point in words and formulas: what is given, the derivatives in symbols with their values, the
// three forms, tangent, normal and curvature, the course. Chooses no figure and no place.

/// A formula or a table, behind the first `after` sentences.
struct PieceAfter {
    std::size_t after = 0;
    EquationItem item;
};
/// Sentences and what they announce.
struct PointSection {
    std::string question;  ///< its data-question
    Words heading;
    std::vector<Words> sentences{};
    std::vector<PieceAfter> pieces{};  ///< in their order
};
/// For a Solution whose problem is the motion of a point: given, derivatives, forms, hodograph, curvature, course.
std::vector<PointSection> point_text(const Solution& solution, Language language);
/// What of it needs no figure, as one list: given, derivatives, forms, tangent and normal.
std::vector<EquationItem> point_items(const Solution& solution, Language language);

}  // namespace kinegraph::render
