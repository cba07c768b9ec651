#include "constructions/problems.hpp"

#include "constructions/hertz.hpp"
#include "constructions/impact.hpp"
#include "constructions/reye.hpp"

namespace kinegraph {

Result<ProblemSolution> solve_problem(const Problem& problem, const Mechanism& mechanism, const Pose& pose) {
    if (const auto* hertz = std::get_if<HertzProblem>(&problem.of)) return solve_hertz(*hertz);
    if (const auto* reye = std::get_if<ReyeProblem>(&problem.of)) return solve_reye(*reye);
    return solve_impact(std::get<ImpactProblem>(problem.of), mechanism, pose);
}

}  // namespace kinegraph
