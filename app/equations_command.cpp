// equations FILE: the closure equations as they are worked by hand, as text, LaTeX or JSON.
#include "app/commands.hpp"
#include "app/files.hpp"
#include "constructions/solve.hpp"
#include "engine/equations.hpp"
#include "render/tables/equation_text.hpp"

namespace kinegraph::app {

Status equations_command(const EquationsRequest& request) {
    auto mechanism = mechanism_of(request.file, request.language, request.set);
    if (!mechanism) return mechanism.error();
    if (mechanism->problem) {
        say(spoken(request.file), no_mechanism("equations"), request.language);
        return Status::bad_input;
    }
    mechanism->find.equations = true;
    const auto solution = solve(*std::move(mechanism));
    if (!solution) return say(spoken(request.file), solution.error(), request.language);
    const Equations& equations = *solution->equations;
    if (!equations.why_not.empty()) {
        say(spoken(request.file), Words("no equations: {0}", "nessuna equazione: {0}", equations.why_not), request.language);
        return Status::bad_input;
    }
    if (request.format == "json") return print("{\n  \"equations\": " + equations_json(equations) + "\n}\n", request.language);
    return print(request.format == "latex" ? render::equations_as_latex(*solution, request.language)
                                           : render::equations_as_text(*solution, request.language),
                 request.language);
}

}  // namespace kinegraph::app
