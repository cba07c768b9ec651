#include "render/scene/load_case.hpp"

#include "engine/number/assert.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph::render {

LoadCase::LoadCase(const Solution& solution, int part)
    : solution_(&solution), bodies_(&solution.free_bodies), together_(&solution.taken_together), part_(part) {
    if (part == all_loads) return;
    KG_ASSERT(part >= 0 && part < parts_of(solution), "a part of the superposition");
    const Superposition::Part& alone = solution.superposition->parts[at_index(part)];
    bodies_ = &alone.bodies;
    together_ = &alone.together;
    load_ = name_of(solution.mechanism, alone);
}

const std::string& name_of(const Mechanism& mechanism, const Superposition::Part& part) {
    return part.body != none ? mechanism.body(part.body).name : mechanism.point(part.pin).name;
}

int parts_of(const Solution& solution) {
    return solution.superposition ? static_cast<int>(solution.superposition->parts.size()) : 0;
}

int part_of(const Solution& solution, StatementIndex statement) {
    for (int i = 0; i < parts_of(solution); ++i) {
        const Superposition::Part& part = solution.superposition->parts[at_index(i)];
        if (!(statement < part.first) && statement < part.end) return i;
    }
    return all_loads;
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
