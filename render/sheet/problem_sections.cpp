#include "render/sheet/problem_sections.hpp"

#include "engine/problem.hpp"

namespace kinegraph::render {

std::vector<ProblemSection> sections_of_problem(const DrawingContext& context) { return hertz_sections(context); }

}  // namespace kinegraph::render
