#include "render/sheet/sheet_limits.hpp"
#include "lang/keys/pages.hpp"

#include <string>

namespace kinegraph::render {

std::optional<Words> beyond_sheet(const Solution& solution) {
    const std::size_t sentences = solution.protocol.statements.size(), polygons = solution.protocol.polygons.size();
    if (sentences > most_sentences)
        return Words(lang::pages::a_sheet_of_this_solution, std::to_string(sentences), std::to_string(most_sentences));
    if (polygons > most_polygons)
        return Words(lang::pages::a_sheet_of_this_solution_would_have, std::to_string(polygons),
                     std::to_string(most_polygons));
    return std::nullopt;
}

}  // namespace kinegraph::render
