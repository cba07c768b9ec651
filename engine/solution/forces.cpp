#include "engine/solution/forces.hpp"

#include "engine/drawing/pose.hpp"
#include "engine/number/assert.hpp"

namespace kinegraph {

Quantity quantity_of(const JointForce& action) {
    return {.kind = Quantity::Kind::force, .body = action.on, .other = action.from, .joint = action.joint};
}
Vector unit_of_component(const JointForce& action) {
    Vector along = *action.along;
    const Exact x = abs(along.x), y = abs(along.y);
    const Exact& largest = x > y ? x : y;
    KG_ASSERT(!largest.is_zero(), "a component has a direction");
    along = {along.x / largest, along.y / largest};
    // On a pose with a leftover a vertical direction is accurate to about 2^-100; its sense must not depend on that.
    const Exact noise = Exact::power_of_two(-80);
    if (x / largest < noise) along.x = 0;
    if (y / largest < noise) along.y = 0;
    if (along.x.sign() < 0 || (along.x.is_zero() && along.y.sign() < 0)) along = -along;
    constexpr int bits = 100;
    return unit_along(along, bits);
}
double component_of(const JointForce& action) { return dot(*action.component, unit_of_component(action)).to_double(); }
Quantity quantity_of(const FreeBody& body, const AppliedForce& applied) {
    if (applied.is_resultant()) return {.kind = applied.kind, .body = body.body};
    if (!applied.is_reaction()) return {.kind = applied.kind, .given = applied.given};
    return {.kind = applied.kind, .body = body.body, .other = applied.from, .joint = applied.joint};
}

}  // namespace kinegraph
