// Wear as a kind of problem, and its results as JSON.
#include "problems/reye/reye.hpp"

#include <utility>

#include "engine/results/json_parts.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

std::string reye_results(const Solution& solution, bool) {
    const auto& found = solution.problem->as<ReyeSolution>();
    json::Members members{{"pressures", json::pair(json::number(found.first), json::number(found.second))}};
    for (auto& each : json::values_of(*solution.problem)) members.push_back(std::move(each));
    if (found.worn)
        members.emplace_back("worn", json::pair(json::number((*found.worn)[0]), json::number((*found.worn)[1])));
    return json::object_of_lines(members);
}
Result<ProblemSolution> solve_this(const Problem& problem, const Mechanism&, const Pose&) {
    return solve_reye(problem.as<ReyeProblem>());
}

}  // namespace

const ProblemKind reye_problem{
    .key = "reye", .section = &reye_section, .read = read_reye, .solve = solve_this, .results = reye_results};

}  // namespace kinegraph
