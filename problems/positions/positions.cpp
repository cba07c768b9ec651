// Positions of a body as a kind of problem, and its results as JSON.
#include "problems/positions/positions.hpp"

#include "engine/file/json_writer.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

void write(const Displacement& of, bool exact, JsonWriter& json) {
    static constexpr std::array kinds{"rest", "translation", "rotation", "general"};
    json.open('{').member("kind", kinds.at(static_cast<std::size_t>(of.kind)));
    if (of.kind == Displacement::Kind::translation) json.member("translation", of.way);
    json.member("pole", of.pole).member("angle", of.angle);
    if (exact && of.pole) json.key("exact").open('{').key("pole").fraction(*of.pole).close();
    json.close();
}
void write(const FixedPivot& pivot, bool exact, JsonWriter& json) {
    static constexpr std::array kinds{"pivot", "straight line", "free", "fixed"};
    json.open('{').member("kind", kinds.at(static_cast<std::size_t>(pivot.kind))).member("pivot", pivot.centre);
    if (pivot.centre) json.member("crank", pivot.radius);
    if (exact && pivot.centre) json.key("exact").open('{').key("pivot").fraction(*pivot.centre).close();
    json.close();
}
void positions_results(const Solution& solution, bool exact, JsonWriter& json) {
    const auto& problem = solution.mechanism.problem->as<PositionsProblem>();
    const auto& found = solution.problem->as<PositionsSolution>();
    json.open('{', JsonWriter::Entries::on_lines).key("displacements").open('{');
    for (const Displacement& each : found.displacements) {
        json.key(std::to_string(each.from + 1) + "," + std::to_string(each.to + 1));
        write(each, exact, json);
    }
    json.close();
    if (!found.pivots.empty()) {
        json.key("fixed pivots").open('{');
        for (std::size_t i = 0; i < found.pivots.size(); ++i) {
            json.key(problem.points.at(i));
            write(found.pivots[i], exact, json);
        }
        json.close();
    }
    json.close();
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
