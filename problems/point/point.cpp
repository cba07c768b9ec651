// The motion of a point as a kind of problem, and its results as JSON.
#include "problems/point/point.hpp"

#include "engine/results/json_parts.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

/// A law and its derivatives in symbols.
std::string derived_json(const Derived& derived, const NamedConstants& constants, std::string_view variable) {
    std::string orders = "[";
    for (const Expression& each : derived.by_order)
        orders += (orders.size() > 1 ? ", " : "") + json::quoted(written(each, constants, variable));
    return orders + "]";
}
std::string derivatives_json(const PointProblem& problem, const PointMotionSolution& found) {
    json::Members members;
    const auto add = [&](const StatedLaw& law, const Derived& derived, std::string_view variable) {
        members.emplace_back(law.symbol == "θ" ? "theta" : law.symbol,
                             derived_json(derived, problem.constants, variable));
    };
    for (std::size_t i = 0; i < found.laws.size(); ++i) add(problem.laws[i], found.laws[i], "t");
    if (found.of_path) add(std::get<GraphPath>(*problem.path).f, *found.of_path, "x");
    return json::object(members);
}
std::string polar_json(const PointMotionSolution& found) {
    const auto two = [](const std::array<double, 2>& of) {
        return json::pair(json::number(of[0]), json::number(of[1]));
    };
    return json::object({{"position", two({found.r, found.theta})},
                         {"velocity", two(found.polar_velocity)},
                         {"acceleration", two(found.polar_acceleration)}});
}
std::string point_results(const Solution& solution, bool) {
    const auto& problem = solution.mechanism.problem->as<PointProblem>();
    const auto& found = solution.problem->as<PointMotionSolution>();
    const auto if_defined = [](bool defined, double value) {
        return defined ? json::number(value) : std::string("null");
    };
    return json::object_of_lines({{"point", json::quoted(problem.point)},
                                  {"at", json::number(problem.at)},
                                  {"position", json::pair(found.place)},
                                  {"velocity", json::pair(found.velocity)},
                                  {"acceleration", json::pair(found.acceleration)},
                                  {"way", json::number(found.way)},
                                  {"speed", json::number(found.speed)},
                                  {"tangential acceleration", if_defined(!found.rests, found.along)},
                                  {"normal acceleration", if_defined(!found.rests, found.across)},
                                  {"radius of curvature", if_defined(found.centre.has_value(), found.radius)},
                                  {"centre of curvature", found.centre ? json::pair(*found.centre) : "null"},
                                  {"polar", found.at_pole ? "null" : polar_json(found)},
                                  {"derivatives", derivatives_json(problem, found)}});
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
