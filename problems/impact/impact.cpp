// Impact as a kind of problem, and its results as JSON.
#include "problems/impact/impact.hpp"

#include "engine/results/json_parts.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

std::string body_results(const ImpactSolution::Body& body) {
    json::Members members{{"velocity", json::pair(body.after)}, {"omega", json::number(body.omega_after)}};
    if (body.reaction) members.emplace_back("pivot", json::pair(*body.reaction));
    if (body.percussion) members.emplace_back("centre of percussion", json::pair(*body.percussion));
    return json::object(members);
}
std::string impact_results(const Solution& solution, bool exact) {
    const auto& problem = solution.mechanism.problem->as<ImpactProblem>();
    const auto& found = solution.problem->as<ImpactSolution>();
    json::Members members{{"kind", "[" + json::quoted(found.central ? "central" : "eccentric") + ", " +
                                       json::quoted(found.direct ? "direct" : "oblique") + "]"},
                          {"angle", json::number(found.obliquity)},
                          {"impulse", json::pair(found.impulse)}};
    json::Members bodies;
    for (std::size_t i = 0; i < 2; ++i)
        bodies.emplace_back(solution.mechanism.body(problem.bodies.at(i).body).name, body_results(found.bodies.at(i)));
    members.emplace_back("bodies", json::object(bodies));
    members.emplace_back("energy lost", json::number(found.energy_lost));
    members.emplace_back("normal restitution", json::number(found.kinematic_restitution));
    if (exact)
        members.emplace_back("exact", json::object({{"impulse", json::fractions(found.impulse)},
                                                    {"energy lost", json::fraction(found.energy_lost)}}));
    return json::object_of_lines(members);
}
Result<ProblemSolution> solve_this(const Problem& problem, const Mechanism& mechanism, const Pose& pose) {
    return solve_impact(problem.as<ImpactProblem>(), mechanism, pose);
}

}  // namespace

const ProblemKind impact_problem{
    .key = "impact", .section = &impact_section, .read = read_impact, .solve = solve_this, .results = impact_results};

}  // namespace kinegraph
