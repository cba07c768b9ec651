// The closure equations as calculated by hand: loops, positions, velocities, ratios, accelerations, as a list of
// headings, sentences, formulas and tables. The sheet, the terminal and LaTeX all print this list. All numbers come
// from the equations; the results of the polygons beside them come from the solution.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/equations/equations.hpp"
#include "render/text/math.hpp"
#include "render/text/words.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

struct EquationItem {
    enum class Kind { heading, words, formula, table } kind = Kind::words;
    std::string words{};  ///< for headings and sentences
    Formula formula{};
    std::vector<std::vector<Formula>> rows{};  ///< for a table, head first
    bool is_apart = false;                     ///< a heading that may begin a new page
    bool announces = false;                    ///< a sentence that stays with what is after it
};

/// Empty if there are no equations.
std::vector<EquationItem> equation_items(const Solution& solution, Language language);

/// The answers for a key: velocity ratios with their derivatives, and dead points. Empty if there are no equations.
std::vector<EquationItem> equation_answers(const Solution& solution, Language language);

/// Plain text for a terminal, one formula per line.
std::string as_text(std::span<const EquationItem> items);
/// A LaTeX document (amsmath), one display per formula.
std::string as_latex(std::span<const EquationItem> items);
/// Its text alone, with formulas for headings, as MathJax shows it.
std::string as_formulas(std::span<const EquationItem> items);

}  // namespace kinegraph::render
