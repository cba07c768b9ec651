// The worked solution of a problem as a list of questions, each with its figures and sentences; the sentences contain
// the formulas. The sections of each kind of problem are in its folder of problems/.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lang/keys/common.hpp"
#include "render/equations/equation_text.hpp"
#include "render/page/block.hpp"
#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

struct ProblemFigure {
    std::string id;
    std::function<Figure(double room_x, double room_y)> draw;
    double height = 1;                                       ///< relative to that of the other figures
    std::function<Figure(double, double)> as_question = {};  ///< the version for a question, if it hides something
};
/// A formula or a table, placed after the first `after` sentences.
struct PieceAfter {
    std::size_t after = 0;
    EquationItem item;
};
struct ProblemSection {
    std::string question;  ///< for `data-question`
    Words heading;
    std::vector<ProblemFigure> figures;
    std::vector<Words> sentences;  ///< in the notation of formula(); a line break begins an equation on its own line
    std::size_t found = 0;         ///< in a section of given data: number of its last sentences that a question hides
    std::vector<PieceAfter> pieces = {};  ///< formulas and tables between the sentences
    bool is_after_results = false;        ///< the results stand before it
};
/// The last section.
inline ProblemSection hypotheses_section(std::vector<Words> sentences) {
    return {"hypotheses", {lang::common::heading_hypotheses}, {}, std::move(sentences), 0, {}, true};
}
/// In reading order, for the kind of the problem; app/library/problem_kinds.cpp defines this function. Results and
/// remarks are not included, since they are the same for all problems.
std::vector<ProblemSection> sections_of_problem(const DrawingContext& context);

}  // namespace kinegraph::render
