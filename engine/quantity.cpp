// Names of quantities, as the results file prints them.
#include "engine/quantity.hpp"

#include <algorithm>

#include "engine/assert.hpp"
#include "engine/pose.hpp"
#include "engine/solution.hpp"

namespace kinegraph {
namespace {

using Kind = Quantity::Kind;

class Namer {
public:
    explicit Namer(const Solution& solution) : solution_(solution), mechanism_(solution.mechanism) {}

    std::string name(const Quantity& q) const {
        std::string whole = part_of_name(q) + stem(q);
        switch (q.component) {
            case Quantity::Component::whole:
                return whole;
            case Quantity::Component::x:
                return whole + " x";
            case Quantity::Component::y:
                return whole + " y";
        }
        KG_ASSERT(false, "a component is x or y");
    }

private:
    std::string stem(const Quantity& q) const {
        switch (q.kind) {
            case Kind::unnamed:
                return "";
            case Kind::velocity:
                return "velocity " + carried(q);
            case Kind::acceleration:
                return "acceleration " + carried(q);
            case Kind::omega:
                return "omega " + body(q.body);
            case Kind::alpha:
                return "alpha " + body(q.body);
            case Kind::centre:
                return "centre " + body(q.body) + "," + body(q.other);
            case Kind::sliding_velocity:
                return "sliding " + joint(q.joint) + " velocity";
            case Kind::sliding_acceleration:
                return "sliding " + joint(q.joint) + " acceleration";
            case Kind::sliding_coriolis:
                return "sliding " + joint(q.joint) + " coriolis";
            case Kind::force:
                return action(q);
            case Kind::couple:
                return action(q) + " couple";
            case Kind::force_component:
                return action(q) + " component";
            case Kind::load:
                return "load " + std::visit([](const auto& load) { return load.name; }, mechanism_.loads[at(q.given)]);
            case Kind::weight:
                return "weight " + body(mechanism_.masses[at(q.given)].body);
            case Kind::inertia:
                return "inertia " + body(mechanism_.masses[at(q.given)].body);
            case Kind::effort:
                return effort(q);
            case Kind::radius:
                return "radius " + mechanism_.points[at(q.point)].name + " on " + body(q.body);
            case Kind::inflection_diameter:
                return "inflection circle " + body(q.body);
            case Kind::acceleration_pole:
                return "acceleration pole " + body(q.body);
            case Kind::virtual_power:
                return "virtual power";
            case Kind::virtual_effort:
                return effort(q) + " by virtual work";
            case Kind::resultant:
                return "resultant " + body(q.body);
            case Kind::resultant_couple:
                return "resultant " + body(q.body) + " couple";
            case Kind::bar:
                return "bar " + bar(q.body);
        }
        KG_ASSERT(false, "a quantity has a kind");
    }
    static std::string part_of_name(const Quantity& q) {
        switch (q.part) {
            case Quantity::Part::whole:
                return "";
            case Quantity::Part::relative:
                return "relative ";
            case Quantity::Part::normal:
                return "normal ";
            case Quantity::Part::tangential:
                return "tangential ";
            case Quantity::Part::sliding:
                return "sliding ";
            case Quantity::Part::coriolis:
                return "coriolis ";
            case Quantity::Part::transport:
                return "transport ";
        }
        KG_ASSERT(false, "a part is one of these");
    }

    static std::size_t at(auto index) { return at_index(index); }
    std::string body(BodyIndex index) const { return index == none ? "pin" : mechanism_.bodies[at(index)].name; }
    std::string bar(BodyIndex index) const {
        if (solution_.truss)
            for (const TrussStructure::Bar& each : solution_.truss->structure.bars)
                if (each.body == index) return each.name;
        return body(index);
    }
    std::string joint(JointIndex index) const { return mechanism_.joints[at(index)].name; }
    std::string carried(const Quantity& q) const {
        // A place that the recipe needed and the file does not name.
        const std::string letter = q.point == none ? "S" : mechanism_.points[at(q.point)].name;
        return is_of_several_bodies(q.point) ? letter + " on " + body(q.body) : letter;
    }
    std::string effort(const Quantity& q) const {
        return "effort " + std::visit([](const auto& effort) { return effort.name; }, mechanism_.efforts[at(q.given)]);
    }
    std::string action(const Quantity& q) const {
        return "force " + joint(q.joint) + " " + body(q.other) + " on " + body(q.body);
    }
    /// A pin and the point of the slot under it move differently under one letter.
    bool is_of_several_bodies(PointIndex point) const {
        return std::count_if(solution_.points.begin(), solution_.points.end(),
                             [&](const PointMotion& each) { return each.point == point; }) > 1;
    }

    const Solution& solution_;
    const Mechanism& mechanism_;
};

}  // namespace

std::string name_of(const Quantity& quantity, const Solution& solution) { return Namer(solution).name(quantity); }

std::string_view name_of(Topic topic) {
    switch (topic) {
        case Topic::unnamed:
            return "";
        case Topic::velocity:
            return "velocity";
        case Topic::acceleration:
            return "acceleration";
        case Topic::relative_motion:
            return "relative motion";
        case Topic::centres:
            return "centres";
        case Topic::curvature:
            return "curvature";
        case Topic::forces:
            return "forces";
    }
    KG_ASSERT(false, "a sentence has a topic");
}

Quantity velocity_of(const PointMotion& motion) {
    return {.kind = Kind::velocity, .body = motion.bodies.front(), .point = motion.point};
}
Quantity acceleration_of(const PointMotion& motion) {
    return {.kind = Kind::acceleration, .body = motion.bodies.front(), .point = motion.point};
}
Quantity quantity_of(const InstantCentre& centre) { return {.kind = Kind::centre, .body = centre.first, .other = centre.second}; }
Quantity quantity_of(const JointForce& action) {
    return {.kind = Kind::force, .body = action.on, .other = action.from, .joint = action.joint};
}
Vector unit_of_component(const JointForce& action) {
    Vector along = *action.along;
    const Exact x = abs(along.x), y = abs(along.y);
    const Exact& largest = x > y ? x : y;
    KG_ASSERT(!largest.is_zero(), "a component has a direction");
    along = {along.x / largest, along.y / largest};
    // On a pose with a leftover an upright direction is upright within 2^-100 or so; its sense must not hang on that.
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
        case AppliedForce::Kind::spring:
            return {.kind = Kind::load, .given = applied.given};
        case AppliedForce::Kind::weight:
            return {.kind = Kind::weight, .given = applied.given};
        case AppliedForce::Kind::inertia:
            return {.kind = Kind::inertia, .given = applied.given};
        case AppliedForce::Kind::effort:
            return {.kind = Kind::effort, .given = applied.given};
        case AppliedForce::Kind::resultant:
            return {.kind = Kind::resultant, .body = body.body};
    }
    KG_ASSERT(false, "what acts is of one kind");
}

}  // namespace kinegraph
