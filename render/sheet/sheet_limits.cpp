#include "render/sheet/sheet_limits.hpp"
#include <string>

#include "engine/solution/displacements.hpp"
#include "engine/solution/solution.hpp"
#include "lang/keys/pages.hpp"

namespace kinegraph::render {

bool is_planned_twice(const Solution& solution) {
    return solution.protocol.statements.size() + solution.mechanism.loads.size() <= most_compared &&
           solution.protocol.polygons.size() <= most_compared_polygons;
}

std::optional<Words> beyond_sheet(const Solution& solution) {
    const std::size_t sentences = solution.protocol.statements.size(), polygons = solution.protocol.polygons.size();
    if (sentences > most_sentences)
        return Words(lang::pages::a_sheet_of_this_solution, std::to_string(sentences), std::to_string(most_sentences));
    if (polygons > most_polygons)
        return Words(lang::pages::a_sheet_of_this_solution_would_have, std::to_string(polygons),
                     std::to_string(most_polygons));
    if (const std::size_t freedoms = solution.displacements ? solution.displacements->freedoms.size() : 0;
        freedoms > most_displacements)
        return Words(lang::pages::a_sheet_of_this_solution_would_show, std::to_string(freedoms),
                     std::to_string(most_displacements));
    if (const std::size_t bodies = solution.mechanism.bodies.size(); bodies > most_drawn_bodies)
        return Words(lang::pages::a_drawing_of_many_bodies, std::to_string(bodies), std::to_string(most_drawn_bodies));
    return std::nullopt;
}

std::optional<Words> beyond_steps(const Solution& solution) {
    if (auto beyond = beyond_sheet(solution)) return beyond;
    if (const std::size_t pages = solution.protocol.statements.size(); pages > most_steps)
        return Words(lang::pages::steps_of_many_pages, std::to_string(pages), std::to_string(most_steps));
    return std::nullopt;
}

}  // namespace kinegraph::render
