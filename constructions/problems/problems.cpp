#include "constructions/problems/problems.hpp"

#include <cmath>

#include "constructions/problems/methods.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/problems.hpp"

namespace kinegraph {

Result<ProblemSolution> solve_problem(const Problem& problem, const Mechanism& mechanism, const Pose& pose) {
    if (const auto* hertz = std::get_if<HertzProblem>(&problem.of)) return solve_hertz(*hertz);
    if (const auto* reye = std::get_if<ReyeProblem>(&problem.of)) return solve_reye(*reye);
    if (const auto* point = std::get_if<PointProblem>(&problem.of)) return solve_point_motion(*point, mechanism, pose);
    if (const auto* positions = std::get_if<PositionsProblem>(&problem.of))
        return solve_positions(*positions, mechanism, pose);
    KG_ASSERT(std::holds_alternative<ImpactProblem>(problem.of), "contacts at joints are no problem of their own");
    return solve_impact(std::get<ImpactProblem>(problem.of), mechanism, pose);
}

std::optional<Errors> why_no_numbers(const std::vector<ProblemValue>& values, const std::string& where) {
    for (const ProblemValue& each : values)
        if (!std::isfinite(each.value) || !std::isfinite(*each.numeric))
            return Errors{{ErrorCode::bad_input, where, {lang::problems::these_numbers_are_too_far_apart, each.name}}};
    return std::nullopt;
}

}  // namespace kinegraph
