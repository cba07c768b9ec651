#include "engine/solution/forces.hpp"

#include "engine/drawing/pose.hpp"

namespace kinegraph {

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

}  // namespace kinegraph
