#include "constructions/problems.hpp"

#include "constructions/hertz.hpp"

namespace kinegraph {

Result<ProblemSolution> solve_problem(const Problem& problem, const Mechanism&, const Pose&) {
    return solve_hertz(std::get<HertzProblem>(problem.of));
}

}  // namespace kinegraph
