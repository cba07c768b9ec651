// A problem's worked solution as questions: each with its figures and its sentences, which carry their formulas. One
// file for each kind of problem.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/equations/chapters.hpp"
#include "render/page/block.hpp"
#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

struct ProblemFigure {
    std::string id;
    std::function<Figure(double room_x, double room_y)> draw;
    double height = 1;                                       ///< beside that of others
    std::function<Figure(double, double)> as_question = {};  ///< where a question keeps something of it back
};
struct ProblemSection {
    std::string question;  ///< its data-question
    Words heading;
    std::vector<ProblemFigure> figures;
    std::vector<Words> sentences;  ///< as formula() reads them; a line break begins an equation on a line of its own
    std::size_t found = 0;         ///< of what is given: how many of the last sentences a question keeps back
    std::vector<PieceAfter> pieces = {};  ///< formulas and tables among the sentences
};
/// In the order in which they are read, without the results and remarks, which all problems share.
std::vector<ProblemSection> sections_of_problem(const DrawingContext& context);

std::vector<ProblemSection> hertz_sections(const DrawingContext& context);
std::vector<ProblemSection> impact_sections(const DrawingContext& context);
std::vector<ProblemSection> reye_sections(const DrawingContext& context);
std::vector<ProblemSection> point_sections(const DrawingContext& context);
std::vector<ProblemSection> positions_sections(const DrawingContext& context);

}  // namespace kinegraph::render
