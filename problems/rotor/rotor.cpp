// Balancing as a kind of problem, and its results as JSON.
#include "problems/rotor/rotor.hpp"

#include "engine/file/json_writer.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

void write_corrections(const RotorProblem& problem, const RotorSolution& found, JsonWriter& json) {
    json.key("corrections").open('[');
    for (std::size_t i = 0; i < found.corrections.size(); ++i) {
        const RotorCorrection& given = problem.corrections[i];
        const RotorSolution::Correction& each = found.corrections[i];
        json.open('{');
        if (given.plane) json.member("plane", problem.planes[*given.plane].name);
        json.member("unbalance", each.unbalance).member("vector", found.balance.closing[i]);
        json.member("angle", each.vanishes ? std::nullopt : std::optional(each.angle));
        const auto given_or = [](const std::optional<Exact>& stated, const std::optional<double>& sought) {
            return stated ? std::optional(stated->to_double()) : sought;
        };
        if (given.radius || each.radius) json.member("radius", given_or(given.radius, each.radius));
        if (given.mass || each.mass) json.member("mass", given_or(given.mass, each.mass));
        json.close();
    }
    json.close();
}
void write_exact(const RotorSolution& found, JsonWriter& json) {
    json.key("exact");
    if (!found.exact) {
        json.value(std::nullopt);
        return;
    }
    json.open('[');
    for (const Vector& each : found.balance.closing) json.fraction(each);
    json.close();
}
void rotor_results(const Solution& solution, bool exact, JsonWriter& json) {
    const auto& problem = solution.mechanism.problem->as<RotorProblem>();
    const auto& found = solution.problem->as<RotorSolution>();
    json.open('{', JsonWriter::Entries::on_lines).member("kind", problem.is_dynamic() ? "dynamic" : "static");
    json.member("balanced already", found.is_balanced_already());
    write_corrections(problem, found, json);
    if (found.couple_left) json.member("couple left", *found.couple_left);
    if (problem.bearings) {
        json.key("reactions").open('{');
        const Exact square = problem.omega * problem.omega;
        for (std::size_t i = 0; i < 2; ++i)
            json.member(problem.planes[problem.bearings->at(i)].name, square * found.held->closing[i]);
        json.close();
    }
    if (found.reaction_left) json.member("reaction left", *found.reaction_left);
    if (exact) write_exact(found, json);
    json.close();
}
Result<ProblemSolution> solve_this(const Problem& problem, const Mechanism& mechanism, const Pose& pose) {
    return solve_rotor(problem.as<RotorProblem>(), mechanism, pose);
}

}  // namespace

Unit unit_of_unbalance(const Units& units) {
    return {units.mass.symbol + " " + units.length.symbol, units.mass.si * units.length.si};
}
Unit unit_of_couple(const Units& units) {
    return {units.mass.symbol + " " + units.length.symbol + "²", units.mass.si * units.length.si * units.length.si};
}

const ProblemKind rotor_problem{.key = "rotor",
                                .section = &rotor_section,
                                .read = read_rotor,
                                .solve = solve_this,
                                .results = rotor_results,
                                .title_block = {.count = 1}};

}  // namespace kinegraph
