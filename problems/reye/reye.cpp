// Wear as a kind of problem, and its results as JSON.
#include "problems/reye/reye.hpp"

#include "engine/results/results.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

void reye_results(const Solution& solution, bool /*exact*/, JsonWriter& json) {
    const auto& found = solution.problem->as<ReyeSolution>();
    json.open('{', JsonWriter::Entries::on_lines);
    json.member("pressures", VectorOf<double>{found.first, found.second});
    write_values(*solution.problem, json);
    if (found.worn) json.member("worn", *found.worn);
    json.close();
}
Result<ProblemSolution> solve_this(const Problem& problem, const Mechanism&, const Pose&) {
    return solve_reye(problem.as<ReyeProblem>());
}

}  // namespace

const ProblemKind reye_problem{
    .key = "reye", .section = &reye_section, .read = read_reye, .solve = solve_this, .results = reye_results};

}  // namespace kinegraph
