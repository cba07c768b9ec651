// The motion of a point as a kind of problem, and its results as JSON.
#include "problems/point/point.hpp"

#include "engine/file/json_writer.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

/// The laws and their derivatives in symbols.
void write_derivatives(const PointProblem& problem, const PointMotionSolution& found, JsonWriter& json) {
    json.key("derivatives").open('{');
    const auto add = [&](const StatedLaw& law, const Derived& derived, std::string_view variable) {
        json.key(law.symbol == "θ" ? "theta" : law.symbol).open('[');
        for (const Expression& each : derived.by_order) json.value(written(each, problem.constants, variable));
        json.close();
    };
    for (std::size_t i = 0; i < found.laws.size(); ++i) add(problem.laws[i], found.laws[i], "t");
    if (found.of_path) add(std::get<GraphPath>(*problem.path).f, *found.of_path, "x");
    json.close();
}
void write_polar(const PointMotionSolution& found, JsonWriter& json) {
    json.key("polar");
    if (found.at_pole) {
        json.value(std::nullopt);
        return;
    }
    json.open('{').member("position", VectorOf<double>{found.r, found.theta});
    json.member("velocity", found.polar_velocity).member("acceleration", found.polar_acceleration).close();
}
void point_results(const Solution& solution, bool /*exact*/, JsonWriter& json) {
    const auto& problem = solution.mechanism.problem->as<PointProblem>();
    const auto& found = solution.problem->as<PointMotionSolution>();
    const auto if_defined = [](bool defined, double value) { return defined ? std::optional(value) : std::nullopt; };
    json.open('{', JsonWriter::Entries::on_lines).member("point", problem.point).member("at", problem.at);
    json.member("position", found.place).member("velocity", found.velocity);
    json.member("acceleration", found.acceleration).member("way", found.way).member("speed", found.speed);
    json.member("tangential acceleration", if_defined(!found.rests, found.along));
    json.member("normal acceleration", if_defined(!found.rests, found.across));
    json.member("radius of curvature", if_defined(found.centre.has_value(), found.radius));
    json.member("centre of curvature", found.centre);
    write_polar(found, json);
    write_derivatives(problem, found, json);
    json.close();
}
Result<ProblemSolution> solve_this(const Problem& problem, const Mechanism& mechanism, const Pose& pose) {
    return solve_point_motion(problem.as<PointProblem>(), mechanism, pose);
}

}  // namespace

const ProblemKind point_problem{.key = "motion",
                                .section = &point_motion_section,
                                .is_stated_by = is_point_motion,
                                .read = read_point_motion,
                                .solve = solve_this,
                                .results = point_results,
                                .title_block = {.count = 1, .of_points = true, .has_forces = false, .has_time = true}};

}  // namespace kinegraph
