#include "engine/results/quantity_name.hpp"

#include <algorithm>

#include "engine/number/assert.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

using Kind = Quantity::Kind;

class Namer {
public:
    explicit Namer(const Solution& solution) : solution_(solution), mechanism_(solution.mechanism) {}

    std::string name(const Quantity& q) const {
        std::string whole = part_of_name(q) + stem(q);
        switch (q.component) {
            case Quantity::Component::whole: return whole;
            case Quantity::Component::x: return whole + " x";
            case Quantity::Component::y: return whole + " y";
        }
        KG_ASSERT(false, "a component is x or y");
    }

private:
    std::string stem(const Quantity& q) const {
        switch (q.kind) {
            case Kind::unnamed: return "";
            case Kind::velocity: return "velocity " + carried(q);
            case Kind::acceleration: return "acceleration " + carried(q);
            case Kind::omega: return "omega " + body(q.body);
            case Kind::alpha: return "alpha " + body(q.body);
            case Kind::centre: return "centre " + body(q.body) + "," + body(q.other);
            case Kind::sliding_velocity: return "sliding " + joint(q.joint) + " velocity";
            case Kind::sliding_acceleration: return "sliding " + joint(q.joint) + " acceleration";
            case Kind::sliding_coriolis: return "sliding " + joint(q.joint) + " coriolis";
            case Kind::force: return action(q);
            case Kind::couple: return action(q) + " couple";
            case Kind::force_component: return action(q) + " component";
            case Kind::load:
                return "load " + std::visit([](const auto& load) { return load.name; }, mechanism_.loads[at(q.given)]);
            case Kind::weight: return "weight " + body(mechanism_.masses[at(q.given)].body);
            case Kind::inertia: return "inertia " + body(mechanism_.masses[at(q.given)].body);
            case Kind::effort: return effort(q);
            case Kind::radius: return "radius " + mechanism_.points[at(q.point)].name + " on " + body(q.body);
            case Kind::inflection_diameter: return "inflection circle " + body(q.body);
            case Kind::acceleration_pole: return "acceleration pole " + body(q.body);
            case Kind::virtual_power: return "virtual power";
            case Kind::virtual_effort: return effort(q) + " by virtual work";
            case Kind::resultant: return "resultant " + body(q.body);
            case Kind::resultant_couple: return "resultant " + body(q.body) + " couple";
            case Kind::bar: return "bar " + bar(q.body);
        }
        KG_ASSERT(false, "a quantity has a kind");
    }
    static std::string part_of_name(const Quantity& q) {
        switch (q.part) {
            case Quantity::Part::whole: return "";
            case Quantity::Part::relative: return "relative ";
            case Quantity::Part::normal: return "normal ";
            case Quantity::Part::tangential: return "tangential ";
            case Quantity::Part::sliding: return "sliding ";
            case Quantity::Part::coriolis: return "coriolis ";
            case Quantity::Part::transport: return "transport ";
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
        // A place that the recipe needs and the file does not name.
        const std::string letter = q.point == none ? "S" : mechanism_.points[at(q.point)].name;
        return is_of_several_bodies(q.point) ? letter + " on " + body(q.body) : letter;
    }
    std::string effort(const Quantity& q) const {
        return "effort " + std::visit([](const auto& effort) { return effort.name; }, mechanism_.efforts[at(q.given)]);
    }
    std::string action(const Quantity& q) const {
        return "force " + joint(q.joint) + " " + body(q.other) + " on " + body(q.body);
    }
    /// Whether several bodies have this point, such as a pin and the point of the slot under it, with different motions
    /// under one letter.
    bool is_of_several_bodies(PointIndex point) const {
        return std::count_if(solution_.points.begin(), solution_.points.end(),
                             [&](const PointMotion& each) { return each.point == point; }) > 1;
    }

    const Solution& solution_;
    const Mechanism& mechanism_;
};

}  // namespace

std::string name_of(const Quantity& quantity, const Solution& solution) { return Namer(solution).name(quantity); }

}  // namespace kinegraph
