#include "engine/solution/forces.hpp"

#include "engine/drawing/pose.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace {

/// The couple of a load or a reaction, with its sign on one of these bodies.
std::optional<Exact> couple_on(const std::vector<FreeBody>& free, const std::vector<BodyIndex>& bodies,
                               const Symbol& symbol) {
    for (const FreeBody& body : free)
        for (const BodyIndex each : bodies)
            if (body.body == each)
                for (const AppliedForce& applied : body.forces) {
                    Symbol of = applied.symbol;
                    of.letter = Symbol::Letter::M;
                    if (of == symbol && !applied.couple.is_zero()) return applied.couple;
                }
    return std::nullopt;
}

}  // namespace

Quantity quantity_of(const JointForce& action) {
    return {.kind = Quantity::Kind::force, .body = action.on, .other = action.from, .joint = action.joint};
}
Vector unit_of_component(const JointForce& action) {
    constexpr int bits = 100;
    return unit_along(without_sense(*action.along, false), bits);
}
double component_of(const JointForce& action) { return dot(*action.component, unit_of_component(action)).to_double(); }
Quantity quantity_of(const FreeBody& body, const AppliedForce& applied) {
    if (applied.is_resultant()) return {.kind = applied.kind, .body = body.body};
    if (!applied.is_reaction()) return {.kind = applied.kind, .given = applied.given};
    return {.kind = applied.kind, .body = body.body, .other = applied.from, .joint = applied.joint};
}

std::optional<Vector> shift_of(const Protocol& protocol, const std::vector<FreeBody>& bodies, StatementIndex statement,
                               const AppliedForce& sum) {
    const Statement& said = protocol.statements[at_index(statement)];
    if (said.message.sentence != lang::sentences::inertia_moved || sum.force.is_zero()) return std::nullopt;
    if (std::get<Symbol>(said.message.arguments[1]) != sum.symbol) return std::nullopt;
    const auto couple = couple_on(bodies, said.bodies, std::get<Symbol>(said.message.arguments[2]));
    if (!couple) return std::nullopt;
    // The moment of F at r is M: r = −(z ∧ F) M/F².
    const Exact share = *couple / dot(sum.force, sum.force);
    return Vector{share * sum.force.y, -(share * sum.force.x)};
}

}  // namespace kinegraph
