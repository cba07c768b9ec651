#include "render/scene/loads_alone.hpp"

#include "engine/number/assert.hpp"

namespace kinegraph::render {

Solution under_loads_alone(const Solution& solution, std::size_t part) {
    KG_ASSERT(solution.superposition && part < solution.superposition->parts.size(), "a part of the superposition");
    Solution alone = solution;
    alone.free_bodies = solution.superposition->parts[part].bodies;
    alone.taken_together = solution.superposition->parts[part].together;
    alone.superposition.reset();
    alone.forces.clear();  // these belong to all loads
    alone.resultants.clear();
    return alone;
}

std::optional<std::size_t> part_of(const Solution& solution, StatementIndex statement) {
    if (!solution.superposition) return std::nullopt;
    const auto& parts = solution.superposition->parts;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!(statement < parts[i].first) && statement < parts[i].end) return i;
    return std::nullopt;
}

const std::string& name_of(const Mechanism& mechanism, const Superposition::Part& part) {
    return part.body != none ? mechanism.body(part.body).name : mechanism.point(part.pin).name;
}

std::string names_of(const Mechanism& mechanism, const TakenTogether& together) {
    constexpr std::size_t most = 4;
    if (together.bodies.size() > most)
        return mechanism.body(together.bodies.front()).name + " … " + mechanism.body(together.bodies.back()).name;
    std::string names;
    for (const BodyIndex body : together.bodies) names += (names.empty() ? "" : " + ") + mechanism.body(body).name;
    return names;
}

}  // namespace kinegraph::render
