#include "render/content/wanted_figures.hpp"

#include <algorithm>

namespace kinegraph::render {

WantedFigures::WantedFigures(const DrawingContext& context, bool joukowsky, SolutionDetail detail,
                             SuperposedLoads superposed)
    : shown_(context, detail == SolutionDetail::brief, joukowsky), superposed_(superposed) {
    for (const FigureId id : all_figures(shown_)) list.push_back({size_of(shown_, id), id});
    if (!context.solution.free_bodies.empty()) keep_forces_readable();
}

bool WantedFigures::joins_parts() const {
    const auto& superposition = shown_.solution().superposition;
    return superposed_ == SuperposedLoads::joined && superposition && !superposition->joined.empty();
}

std::optional<FigureId> WantedFigures::joined_parts_of(const FreeBody& body) const {
    if (!joins_parts()) return std::nullopt;
    for (const Superposition::Joined& joined : shown_.solution().superposition->joined)
        if (joined.body == body.body && joined.pin == body.pin)
            return FigureId{FigureKind::joined_parts_of_body, joined.polygon};
    return std::nullopt;
}

bool WantedFigures::is_replaced(FigureId id) const {
    if (id.kind == FigureKind::joined_parts || id.kind == FigureKind::joined_parts_of_body) return !joins_parts();
    const bool of_each =
        id.kind == FigureKind::partial_sums || (id.part != all_loads && id.kind != FigureKind::lines_of_action);
    return of_each && joins_parts();
}

std::optional<std::size_t> WantedFigures::named(FigureId id) const {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Wanted& each) { return each.id == id; });
    if (found == list.end()) return std::nullopt;
    return static_cast<std::size_t>(found - list.begin());
}

Figure WantedFigures::enriched(std::size_t figure, const Figure& plain, Spot room) const {
    const FigureId id = list[figure].id;
    const FigureFunctions& by = *row_of(id.kind).by;
    return by.enrich == nullptr ? Figure::empty_at(any_scale) : by.enrich(shown_, id, plain, room);
}

/// All force polygons have one scale, so that the sides of the closed polygon can be copied with compasses. The largest
/// polygon must be readable at it.
void WantedFigures::keep_forces_readable() {
    constexpr double least = 25;
    Wanted* largest = nullptr;
    for (Wanted& each : list) {
        const bool is_all = each.id == FigureId{FigureKind::forces};
        if (each.to_force_scale && !is_all && (largest == nullptr || each.extent() > largest->extent()))
            largest = &each;
    }
    if (largest != nullptr) largest->least = std::max(largest->least, least);
}

}  // namespace kinegraph::render
