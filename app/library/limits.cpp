#include "app/library/limits.hpp"

#include <string>
#include <variant>

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

std::size_t work_of(std::size_t bytes, const Mechanism& mechanism) {
    // The numeric check takes the cube of the bodies.
    const std::size_t bodies = mechanism.bodies.size();
    return 200 + bytes / 30 + bodies * bodies * bodies / 300;
}

std::size_t work_of(const Protocol& record) {
    std::size_t numbers = 0, places = 0;
    for (const Value& value : record.values) {
        const bool is_number = std::holds_alternative<Exact>(value) || std::holds_alternative<Vector>(value);
        ++(is_number ? numbers : places);
    }
    // Points and lines are compared with one another.
    return record.bits / 500 + numbers / 2 + 3 * places + places * places / 10'000;
}

}  // namespace kinegraph::app
