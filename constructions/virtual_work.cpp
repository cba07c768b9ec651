#include "constructions/virtual_work.hpp"

#include <algorithm>
#include <utility>

namespace kinegraph {
namespace {

/// How a body moves: the velocity of one of its places, and how fast it turns.
struct Turning {
    Vector place, velocity;
    Exact omega;

    Vector velocity_at(const Vector& other) const { return velocity + omega * quarter_turn(other - place); }
};

std::optional<Turning> turning_of(const Structure& structure, const Board& board, const Track<Plane::velocity>& velocities,
                                  BodyIndex body) {
    if (velocities.polygon < 0 || !velocities.turns(body)) return std::nullopt;
    const auto& nodes = structure.nodes_of(body);
    const auto base = std::find_if(nodes.begin(), nodes.end(), [&](NodeIndex node) { return velocities.has(node); });
    if (base == nodes.end()) return std::nullopt;
    return Turning{board.value(structure.node(*base).place).place(), board.value(velocities.tip(*base)).place(),
                   board.value(velocities.spin(body))};
}

}  // namespace

std::optional<VirtualWork> virtual_work(const Structure& structure, const Board& board, const Track<Plane::velocity>& velocities,
                                        const std::vector<FreeBody>& bodies) {
    VirtualWork work;
    for (const FreeBody& free : bodies) {
        if (free.body < 0) continue;
        const std::optional<Turning> turning = turning_of(structure, board, velocities, free.body);
        for (const AppliedForce& applied : free.forces) {
            if (applied.kind == AppliedForce::Kind::reaction) continue;
            if (!turning) return std::nullopt;
            const Vector velocity = turning->velocity_at(applied.at);
            const Exact power = dot(applied.force, velocity) + applied.couple * turning->omega;
            work.entries.push_back(
                {applied.symbol, free.body, applied.at, velocity, applied.force, applied.couple, turning->omega, power});
            work.total += power;
        }
    }
    if (work.entries.empty()) return std::nullopt;
    return work;
}

}  // namespace kinegraph
