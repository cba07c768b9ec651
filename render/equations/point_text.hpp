// The motion of a point in words and formulas: what is given, the derivatives in symbols with their values, the three
// forms, tangent, normal and curvature, the course. Chooses no figure and no place.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/file/words.hpp"
#include "engine/solution/solution.hpp"
#include "render/equations/equation_text.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

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
