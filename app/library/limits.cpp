#include "app/library/limits.hpp"

#include <string>

#include "constructions/solving/solve.hpp"
#include "engine/mechanism/problem.hpp"
#include "lang/keys/library.hpp"

namespace kinegraph::app {

std::optional<Error> beyond_solving(const Mechanism& mechanism) {
    const std::size_t bodies = mechanism.bodies.size();
    if (bodies > most_bodies)
        return Error{
            .where = "/bodies",
            .message = Words(lang::library::too_many_bodies, std::to_string(bodies), std::to_string(most_bodies))};
    if (bodies <= most_bodies_with_centres || stands_for_joints(mechanism) || !finds_centres(mechanism))
        return std::nullopt;
    return Error{.where = "/find",
                 .message = Words(lang::library::too_many_centres, std::to_string(bodies),
                                  std::to_string(bodies * (bodies - 1) / 2), std::to_string(most_bodies_with_centres))};
}

std::optional<Words> beyond_sweep(const Mechanism& mechanism) {
    if (mechanism.bodies.size() <= most_swept_bodies) return std::nullopt;
    return Words(lang::library::too_many_to_sweep, std::to_string(mechanism.bodies.size()),
                 std::to_string(most_swept_bodies));
}

}  // namespace kinegraph::app
