// Impact as a kind of problem, and its results as JSON.
#include "problems/impact/impact.hpp"

#include "engine/file/json_writer.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

void write_body(const ImpactSolution::Body& body, JsonWriter& json) {
    json.open('{').member("velocity", body.after).member("omega", body.omega_after);
    if (body.reaction) json.member("pivot", *body.reaction);
    if (body.percussion) json.member("centre of percussion", *body.percussion);
    json.close();
}
void impact_results(const Solution& solution, bool exact, JsonWriter& json) {
    const auto& problem = solution.mechanism.problem->as<ImpactProblem>();
    const auto& found = solution.problem->as<ImpactSolution>();
    json.open('{', JsonWriter::Entries::on_lines).key("kind").open('[');
    json.value(found.central ? "central" : "eccentric").value(found.direct ? "direct" : "oblique").close();
    json.member("angle", found.obliquity).member("impulse", found.impulse).key("bodies").open('{');
    for (std::size_t i = 0; i < 2; ++i) {
        json.key(solution.mechanism.body(problem.bodies.at(i).body).name);
        write_body(found.bodies.at(i), json);
    }
    json.close().member("energy lost", found.energy_lost);
    json.member("normal restitution", found.kinematic_restitution);
    if (exact) {
        json.key("exact").open('{').key("impulse").fraction(found.impulse);
        json.key("energy lost").fraction(found.energy_lost).close();
    }
    json.close();
}
Result<ProblemSolution> solve_this(const Problem& problem, const Mechanism& mechanism, const Pose& pose) {
    return solve_impact(problem.as<ImpactProblem>(), mechanism, pose);
}

}  // namespace

const ProblemKind impact_problem{
    .key = "impact", .section = &impact_section, .read = read_impact, .solve = solve_this, .results = impact_results};

}  // namespace kinegraph
