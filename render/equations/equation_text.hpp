// The closure equations as they are worked by hand: loops, position, velocities, ratios, accelerations, in a list of
// headings, sentences, formulas and tables, which the sheet sets, and the terminal and LaTeX print. Takes every number
// from the equations, and from the solution what the polygons say beside them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/equations/equations.hpp"
#include "engine/solution/solution.hpp"
#include "render/text/math.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

struct EquationItem {
    enum class Kind { heading, words, formula, table } kind = Kind::words;
    std::string words{};  ///< of headings and sentences
    Formula formula{};
    std::vector<std::vector<Formula>> rows{};  ///< of a table, the head first
    bool is_apart = false;                     ///< a heading that may begin a page of its own
};

/// Nothing where there are no equations.
std::vector<EquationItem> equation_items(const Solution& solution, Language language);

/// What a key says of the equations: velocity ratios with their derivatives, dead points; nothing where there are none.
std::vector<EquationItem> equation_answers(const Solution& solution, Language language);

/// For a terminal, a line a formula.
std::string as_text(std::span<const EquationItem> items);
/// A document of LaTeX (amsmath), a display a formula.
std::string as_latex(std::span<const EquationItem> items);

}  // namespace kinegraph::render
