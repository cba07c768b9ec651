#include "render/sheet/sheet_limits.hpp"

#include <string>

namespace kinegraph::render {

std::optional<Words> beyond_sheet(const Solution& solution) {
    const std::size_t sentences = solution.protocol.statements.size(), polygons = solution.protocol.polygons.size();
    if (sentences > most_sentences)
        return Words(
            "a sheet of this solution would have {0} sentences, and at most {1} are laid out; ask for less "
            "with \"find\" (the instant centres grow with the square of the bodies), or write JSON or CSV",
            "un foglio di questa soluzione avrebbe {0} frasi, e se ne impaginano al più {1}; chiedere di meno "
            "con \"find\" (i centri di istantanea rotazione crescono col quadrato dei corpi), oppure scrivere "
            "JSON o CSV",
            std::to_string(sentences), std::to_string(most_sentences));
    if (polygons > most_polygons)
        return Words(
            "a sheet of this solution would have {0} polygons, and at most {1} are laid out; ask for less "
            "with \"find\", or write JSON or CSV",
            "un foglio di questa soluzione avrebbe {0} poligoni, e se ne impaginano al più {1}; chiedere di "
            "meno con \"find\", oppure scrivere JSON o CSV",
            std::to_string(polygons), std::to_string(most_polygons));
    return std::nullopt;
}

}  // namespace kinegraph::render
