// The worked solution of the motion of a point: assigns its sentences to figures.
#include <utility>

#include "engine/solution/problem_solution.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/point_motion.hpp"
#include "render/figures/problem_figures.hpp"
#include "render/problems/problem_sections.hpp"

namespace kinegraph::render {

std::vector<ProblemSection> point_sections(const DrawingContext& context) {
    const auto& found = std::get<PointMotionSolution>(context.solution.problem->of);
    const auto figure = [&context](const char* id, auto draw, double height) {
        return ProblemFigure{id, [&context, draw](double x, double y) { return draw(context, x, y); }, height};
    };
    std::vector<ProblemSection> sections;
    for (PointSection& each : point_text(context.solution, context.language)) {
        ProblemSection section{each.question,         std::move(each.heading), {}, std::move(each.sentences), 0,
                               std::move(each.pieces)};
        if (section.question == "given") {
            section.figures.push_back(figure("trajectory", trajectory_figure, 1.1));
            section.figures.back().as_question = [&context](double x, double y) {
                return trajectory_question_figure(context, x, y);
            };
        }
        if (section.question == "hodograph") section.figures.push_back(figure("hodograph", hodograph_figure, 0.7));
        if (section.question == "curvature" && found.centre)
            section.figures.push_back(figure("curvature-centre", curvature_centre_figure, 0.9));
        if (section.question == "course") {
            section.figures.push_back(figure("way", way_figure, 0.6));
            section.figures.push_back(figure("speed", speed_figure, 0.6));
            section.figures.push_back(figure("components", components_figure, 0.7));
        }
        sections.push_back(std::move(section));
    }
    sections.push_back(
        {"hypotheses", {lang::common::heading_hypotheses}, {}, {{lang::point_motion::the_axes_are_fixed_derivatives}}});
    return sections;
}

}  // namespace kinegraph::render
