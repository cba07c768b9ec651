#include "constructions/statics/forces/balancing.hpp"

#include "engine/number/assert.hpp"

namespace kinegraph::statics {

Force Balancing::opposite_along(const Wrench& known, DirectionHandle direction) {
    const Force unit = board_.scale<Plane::force>(board_.number(1), direction);
    return board_.scale<Plane::force>(board_.ratio(opposite(known), unit), direction);
}

std::optional<Force> Balancing::by_moments(const Action& line, PlaceOnDrawing about, const Wrench& known) {
    const ScalarHandle lever = board_.moment(board_.vector(about, line.place), line.direction);
    if (board_.is_zero(lever)) return std::nullopt;
    const ScalarHandle size = board_.quotient(board_.opposite(model_.moment(known, about)), lever);
    return board_.scale<Plane::force>(size, line.direction);
}

std::pair<Force, Force> Balancing::triangle(const Wrench& known, DirectionHandle d, DirectionHandle e) {
    const auto start = board_.pole<Plane::force>();
    const auto end = known.force ? board_.carry(start, *known.force) : start;
    const auto corner = board_.meet(board_.through(end, d), board_.through(start, e));
    KG_ASSERT(corner && !board_.is_at_infinity(*corner), "the sides of a force triangle are not parallel");
    return {board_.vector(end, *corner), board_.vector(*corner, start)};
}

bool Balancing::is_along(const Wrench& known, const Action& line) {
    return known.force && board_.parallel(board_.direction(*known.force), line.direction);
}

Wrench Balancing::wrench_at(Force force, PlaceOnDrawing place) {
    Wrench wrench;
    wrench.force = force;
    wrench.place = place;
    return wrench;
}

}  // namespace kinegraph::statics
