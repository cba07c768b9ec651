// Chapters of prose and formulas beside the closure equations: relative motion taken apart, virtual work, motion of a
// point.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/solution/displacements.hpp"
#include "engine/solution/solution.hpp"
#include "lang/words.hpp"
#include "render/equations/equation_text.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

// ----- Decomposition of a relative motion: transport motion about the origin of the moving axes, Poisson's formulae,
// the motion seen in the moving axes, and the Coriolis term with its sense, or why it vanishes.

/// For Solution::relative_motion[index], whose `apart` must be present.
std::vector<EquationItem> apart_items(const Solution& solution, std::size_t index, Language language);

// ----- Virtual work as calculated by hand: the displaced coordinate, forces and displacements in a table, the sum, and
// the input forces or couples; then the same by the velocity ratios of the closure equations. All numbers come from the
// displacements.

/// Empty if virtual work is not requested. If it does not apply, the reason.
std::vector<EquationItem> virtual_work_items(const Solution& solution, Language language);

/// "δθ_3", "δs_D": the displaced coordinate.
RichText displaced_coordinate(const Mechanism& mechanism, const Driver& driver);

// ----- Motion of a point in words and formulas: given data, derivatives in symbols with their values, the three forms,
// tangent, normal and curvature, the course. Independent of figures and positions.

/// A formula or a table, placed after the first `after` sentences.
struct PieceAfter {
    std::size_t after = 0;
    EquationItem item;
};
/// Sentences, with the formulas and tables that belong to them.
struct PointSection {
    std::string question;  ///< its data-question attribute
    Words heading;
    std::vector<Words> sentences{};
    std::vector<PieceAfter> pieces{};  ///< in order of `after`
};
/// For a Solution whose problem is the motion of a point: given, derivatives, forms, hodograph, curvature, course.
std::vector<PointSection> point_text(const Solution& solution, Language language);
/// The part that needs no figure, as one list: given data, derivatives, forms, tangent and normal.
std::vector<EquationItem> point_items(const Solution& solution, Language language);

}  // namespace kinegraph::render
