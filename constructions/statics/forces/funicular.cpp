#include "constructions/statics/forces/funicular.hpp"

#include <algorithm>

#include "engine/number/assert.hpp"

namespace kinegraph::statics {

std::optional<Funicular> FunicularPolygons::drawn(const Group& group, std::vector<Actor> actors, Force sum,
                                                  const Action& line, PlaceOnDrawing place) {
    const bool several = group.size() > 1;
    const std::size_t most = several ? 12 : 6;
    const bool drawn = (several || !model_.is_pin(group.front()));
    if (!drawn || actors.empty() || actors.size() > most) return std::nullopt;
    if (!std::all_of(actors.begin(), actors.end(), [](const Actor& actor) { return actor.force.has_value(); }))
        return std::nullopt;
    sort_along(actors, place, line.place);
    Funicular found;
    found.group = group;
    found.corners = {board_.pole<Plane::force>()};
    for (const Actor& actor : actors) {
        found.known.push_back(actor.symbol);
        found.corners.push_back(board_.carry(found.corners.back(), *actor.force));
    }
    // The first whose strings stay beside the structure, or near it.
    for (const Exact& deepest : {Exact(1), Exact(3) / 2})
        for (const auto pole : poles(found.corners, sum, several)) {
            const Board::Mark before = board_.mark();
            found.pole = pole;
            if (draw(found, actors, line, place) && !(several && is_deep(found.vertices, actors, line, deepest)))
                return found;
            board_.rewind(before);
        }
    return std::nullopt;
}

std::pair<Force, Force> FunicularPolygons::by_funicular(Funicular found, int line, int pin, Force sum,
                                                        const Group& group, Run& run) {
    found.statement = said_.last();
    found.first = said_.symbol_on(line, group);
    found.second = said_.symbol_on(pin, group);
    if (found.resultant)
        run.sums.push_back({group, said_.resultant_symbol(group), sum, *found.resultant, {}, said_.last()});
    const Force first = board_.vector(found.corners.back(), found.dividing);
    const Force second = board_.vector(found.dividing, found.corners.front());
    run.funiculars.push_back(std::move(found));
    return {first, second};
}

bool FunicularPolygons::is_far(const Group& group, PlaceOnDrawing met, PlaceOnDrawing place, PlaceOnDrawing one,
                               PlaceOnDrawing two) {
    // Lines that meet farther away would not fit on a sheet with bodies of readable size.
    const int times = known_.is_whole(group) ? 1 : 4;
    std::vector<PlaceOnDrawing> near{one, two};
    if (known_.is_whole(group))
        for (const int b : model_.outer_bonds(group)) near.push_back(model_.bonds()[at(b)].place);
    const auto away = board_.vector(place, met);
    return std::all_of(near.begin(), near.end(), [&](PlaceOnDrawing each) {
        return board_.choose_longer(away, board_.scale<drawing>(board_.number(times), board_.vector(place, each)));
    });
}

void FunicularPolygons::sort_along(std::vector<Actor>& actors, PlaceOnDrawing from, PlaceOnDrawing to) {
    const auto axis = board_.vector(from, to);
    std::stable_sort(actors.begin(), actors.end(), [&](const Actor& a, const Actor& b) {
        return board_.choose_along(axis, board_.vector(a.place, b.place)) > 0;
    });
}

bool FunicularPolygons::draw(Funicular& found, const std::vector<Actor>& actors, const Action& line,
                             PlaceOnDrawing place) {
    found.vertices = {place};
    found.resultant.reset();
    std::optional<LineOn<drawing>> outer;
    for (std::size_t i = 0; i <= actors.size(); ++i) {
        const auto ray = board_.direction(board_.vector(found.pole, found.corners[i]));
        const LineOn<drawing> string = board_.through(found.vertices.back(), ray);
        const LineOn<drawing> next =
            i < actors.size() ? board_.through(actors[i].place, board_.direction(*actors[i].force)) : line.line;
        if (board_.parallel(string, next)) return false;
        if (!outer) outer = string;
        if (i == actors.size() && i > 1 && !board_.parallel(*outer, string))
            found.resultant = board_.meet(*outer, string);
        found.vertices.push_back(*board_.meet(string, next));
    }
    if (board_.coincide(found.vertices.back(), found.vertices.front())) return false;
    const auto closing = board_.direction(board_.vector(found.vertices.back(), found.vertices.front()));
    const auto dividing =
        board_.meet(board_.through(found.corners.back(), line.direction), board_.through(found.pole, closing));
    KG_ASSERT(dividing && !board_.is_at_infinity(*dividing), "the closing line joins a place to a line that misses it");
    found.dividing = *dividing;
    return true;
}

std::vector<PointOn<Plane::force>> FunicularPolygons::poles(const std::vector<PointOn<Plane::force>>& corners,
                                                            Force sum, bool several) {
    const auto distance = pole_distance(corners, sum, several ? 4 : 64);
    if (!distance) return {};
    const Force away = *distance == Exact(1) ? board_.turn(sum)
                                             : board_.scale<Plane::force>(board_.number(*distance), board_.turn(sum));
    std::vector<PointOn<Plane::force>> found;
    for (const Exact& share : {Exact(1) / 2, Exact(3) / 2, Exact(-1) / 2}) {
        const Force along = board_.scale<Plane::force>(board_.number(share), sum);
        found.push_back(board_.carry(board_.carry(corners.front(), along), away));
        if (!several) break;
    }
    return found;
}

/// Rays are well inclined where the pole is about as far away as the force line is long, which may be longer than the
/// sum.
std::optional<Exact> FunicularPolygons::pole_distance(const std::vector<PointOn<Plane::force>>& corners, Force sum,
                                                      int most) {
    for (int times = 1; times <= most; times *= 2) {
        const Force reach = board_.scale<Plane::force>(board_.number(Exact(5) / 4 * Exact(times)), sum);
        const bool near = std::all_of(corners.begin() + 1, corners.end(), [&](PointOn<Plane::force> corner) {
            return !board_.choose_longer(board_.vector(corners.front(), corner), reach);
        });
        if (near) return Exact(times);
    }
    return std::nullopt;
}

bool FunicularPolygons::is_deep(const std::vector<PlaceOnDrawing>& vertices, const std::vector<Actor>& actors,
                                const Action& line, const Exact& times) {
    auto reach = board_.vector(vertices.front(), line.place);
    for (const Actor& actor : actors)
        if (const auto away = board_.vector(vertices.front(), actor.place); board_.choose_longer(away, reach))
            reach = away;
    reach = board_.scale<drawing>(board_.number(times), reach);
    for (std::size_t i = 0; i < vertices.size() - 1; ++i) {
        const PlaceOnDrawing acts_at = i < actors.size() ? actors[i].place : line.place;
        if (board_.choose_longer(board_.vector(acts_at, vertices[i + 1]), reach)) return true;
    }
    return false;
}

}  // namespace kinegraph::statics
