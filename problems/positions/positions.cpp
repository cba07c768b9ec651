// Positions of a body as a kind of problem, and its results as JSON.
#include "problems/positions/positions.hpp"

#include "engine/results/json_parts.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

std::string displacement_json(const Displacement& of, bool exact) {
    static constexpr std::array kinds{"rest", "translation", "rotation", "general"};
    json::Members members{{"kind", json::quoted(kinds.at(static_cast<std::size_t>(of.kind)))}};
    if (of.kind == Displacement::Kind::translation) members.emplace_back("translation", json::pair(of.way));
    members.emplace_back("pole", of.pole ? json::pair(*of.pole) : "null");
    members.emplace_back("angle", json::number(of.angle));
    if (exact && of.pole) members.emplace_back("exact", json::object({{"pole", json::fractions(*of.pole)}}));
    return json::object(members);
}
std::string pivot_json(const FixedPivot& pivot, bool exact) {
    static constexpr std::array kinds{"pivot", "straight line", "free", "fixed"};
    json::Members members{{"kind", json::quoted(kinds.at(static_cast<std::size_t>(pivot.kind)))},
                          {"pivot", pivot.centre ? json::pair(*pivot.centre) : "null"}};
    if (pivot.centre) members.emplace_back("crank", json::number(pivot.radius));
    if (exact && pivot.centre) members.emplace_back("exact", json::object({{"pivot", json::fractions(*pivot.centre)}}));
    return json::object(members);
}
std::string positions_results(const Solution& solution, bool exact) {
    const auto& problem = solution.mechanism.problem->as<PositionsProblem>();
    const auto& found = solution.problem->as<PositionsSolution>();
    json::Members displacements, pivots;
    for (const Displacement& each : found.displacements)
        displacements.emplace_back(std::to_string(each.from + 1) + "," + std::to_string(each.to + 1),
                                   displacement_json(each, exact));
    for (std::size_t i = 0; i < found.pivots.size(); ++i)
        pivots.emplace_back(problem.points.at(i), pivot_json(found.pivots[i], exact));
    json::Members members{{"displacements", json::object(displacements)}};
    if (!pivots.empty()) members.emplace_back("fixed pivots", json::object(pivots));
    return json::object_of_lines(members);
}
Result<ProblemSolution> solve_this(const Problem& problem, const Mechanism& mechanism, const Pose& pose) {
    return solve_positions(problem.as<PositionsProblem>(), mechanism, pose);
}

}  // namespace

const ProblemKind positions_problem{
    .key = "positions",
    .section = &positions_section,
    .read = read_positions,
    .solve = solve_this,
    .results = positions_results,
    .title_block = {.count = 1, .of_points = false, .has_forces = false, .has_time = false}};

}  // namespace kinegraph
