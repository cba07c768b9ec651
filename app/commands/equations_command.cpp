// equations FILE: the closure equations as solved by hand, or the derivatives of the position of a point, as text,
// LaTeX or JSON.
#include "app/commands/commands.hpp"
#include "app/files/files.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/equations/equations.hpp"
#include "engine/solution/problem_solution.hpp"
#include "render/equations/chapters.hpp"
#include "render/equations/equation_text.hpp"

namespace kinegraph::app {

namespace {

bool is_point_motion(const Mechanism& mechanism) {
    return mechanism.problem && std::holds_alternative<PointProblem>(mechanism.problem->of);
}
Status print_items(const std::vector<render::EquationItem>& items, const EquationsRequest& request) {
    return print(request.format == "latex" ? render::as_latex(items) : render::as_text(items), request.language);
}
Status print_motion(const Solution& solution, const EquationsRequest& request) {
    if (request.format == "json") return print("{\n  \"motion\": " + motion_json(solution) + "\n}\n", request.language);
    return print_items(render::point_items(solution, request.language), request);
}

}  // namespace

Status equations_command(const EquationsRequest& request) {
    auto mechanism = mechanism_of(request.file, request.language, request.set);
    if (!mechanism) return mechanism.error();
    const bool of_point = is_point_motion(*mechanism);
    if (stands_for_joints(*mechanism) && !of_point) {
        say(spoken(request.file), no_mechanism("equations"), request.language);
        return Status::bad_input;
    }
    mechanism->find.equations = !of_point;
    const auto solution = solve(*std::move(mechanism));
    if (!solution) return say(spoken(request.file), solution.error(), request.language);
    if (of_point) return print_motion(*solution, request);
    const Equations& equations = *solution->equations;
    if (!equations.why_not.empty()) {
        say(spoken(request.file), Words("no equations: {0}", "nessuna equazione: {0}", equations.why_not),
            request.language);
        return Status::bad_input;
    }
    if (request.format == "json")
        return print("{\n  \"equations\": " + equations_json(equations) + "\n}\n", request.language);
    return print_items(render::equation_items(*solution, request.language), request);
}

}  // namespace kinegraph::app
