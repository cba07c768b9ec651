#include "render/problems/problem_sections.hpp"

#include "engine/solution/problem_solution.hpp"

namespace kinegraph::render {

std::vector<ProblemSection> sections_of_problem(const DrawingContext& context) {
    if (std::holds_alternative<HertzProblem>(context.solution.mechanism.problem->of)) return hertz_sections(context);
    if (std::holds_alternative<ReyeProblem>(context.solution.mechanism.problem->of)) return reye_sections(context);
    if (std::holds_alternative<PointProblem>(context.solution.mechanism.problem->of)) return point_sections(context);
    if (std::holds_alternative<PositionsProblem>(context.solution.mechanism.problem->of))
        return positions_sections(context);
    return impact_sections(context);
}

}  // namespace kinegraph::render
