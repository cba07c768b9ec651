#include "engine/solution/solution.hpp"

#include "engine/number/assert.hpp"
#include "engine/solution/found_elements.hpp"

namespace kinegraph {

Solution::Solution() = default;
Solution::Solution(const Solution&) = default;
Solution::Solution(Solution&&) noexcept = default;
Solution& Solution::operator=(const Solution&) = default;
Solution& Solution::operator=(Solution&&) noexcept = default;
Solution::~Solution() = default;
namespace {

void read(const Value& from, Exact& value) { value = std::get<Exact>(from); }
void read(const Value& from, ProjectivePoint& value) { value = std::get<ProjectivePoint>(from); }
/// A vector from the pole may be stored in the record as its tip.
void read(const Value& from, Vector& value) {
    const auto* point = std::get_if<ProjectivePoint>(&from);
    value = point == nullptr ? std::get<Vector>(from) : point->place();
}

}  // namespace

void read_values(Solution& solution, const std::vector<Value>& values) {
    for_each_found(solution, [&](ElementIndex& element, auto& value) { read(values[at_index(element)], value); });
}

namespace {
using Kind = Quantity::Kind;
}  // namespace

Quantity velocity_of(const PointMotion& motion) {
    return {.kind = Kind::velocity, .body = motion.bodies.front(), .point = motion.point};
}
Quantity acceleration_of(const PointMotion& motion) {
    return {.kind = Kind::acceleration, .body = motion.bodies.front(), .point = motion.point};
}
Quantity quantity_of(const InstantCentre& centre) {
    return {.kind = Kind::centre, .body = centre.first, .other = centre.second};
}
Quantity quantity_of(const JointForce& action) {
    return {.kind = Kind::force, .body = action.on, .other = action.from, .joint = action.joint};
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
    switch (applied.kind) {
        case AppliedForce::Kind::reaction:
            return {.kind = Kind::force, .body = body.body, .other = applied.from, .joint = applied.joint};
        case AppliedForce::Kind::load:
        case AppliedForce::Kind::spring: return {.kind = Kind::load, .given = applied.given};
        case AppliedForce::Kind::weight: return {.kind = Kind::weight, .given = applied.given};
        case AppliedForce::Kind::inertia: return {.kind = Kind::inertia, .given = applied.given};
        case AppliedForce::Kind::effort: return {.kind = Kind::effort, .given = applied.given};
        case AppliedForce::Kind::resultant: return {.kind = Kind::resultant, .body = body.body};
    }
    KG_ASSERT(false, "what acts is of one kind");
}

}  // namespace kinegraph
