// Quantities: what a solution may hold a value of, as data: the kind, of whom, where, seen from where. One quantity
// said twice compares equal. Knows no value and no typography.
#pragma once

#include <compare>
#include <string>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

struct Quantity {
    enum class Kind {
        unnamed,
        velocity,      ///< of `point` as `body` carries it; a part of it or seen by `other`: see `part`
        acceleration,  ///< the same
        omega,         ///< of `body`
        alpha,
        centre,            ///< of `body` and `other`
        sliding_velocity,  ///< at `joint`, of its first body on its second
        sliding_acceleration,
        sliding_coriolis,
        force,            ///< at `joint`, of `other` on `body` (none: the pin of a multiple hinge)
        couple,           ///< the same, about the joint's point
        force_component,  ///< of such a force, along the one direction in which every equilibrium has it alike
        load,             ///< `given` counts Mechanism::loads
        weight,           ///< `given` counts Mechanism::masses
        inertia,
        effort,               ///< `given` counts Mechanism::efforts
        radius,               ///< of curvature, of the path of `point` as `body` carries it
        inflection_diameter,  ///< of the inflection circle of `body`
        acceleration_pole,    ///< of `body`
        virtual_power,        ///< of all that acts from outside
        virtual_effort,       ///< the effort `given`, by virtual displacements
        resultant,            ///< of all that is given on `body` and what hangs on it
        resultant_couple,     ///< the same, about the origin
        bar                   ///< the force in the bar `body` of a truss, tension positive
    } kind = Kind::unnamed;
    BodyIndex body = none, other = none;
    PointIndex point = none;
    JointIndex joint = none;
    int given = -1;
    /// Of a velocity or an acceleration.
    enum class Part { whole, relative, normal, tangential, sliding, coriolis, transport } part = Part::whole;
    PointIndex seen_from = none;  ///< the point of `other` that a part is counted from
    enum class Component { whole, x, y } component = Component::whole;

    // clang-tidy 14 takes the 0 that the compiler compares with for a pointer.
    friend auto operator<=>(const Quantity&, const Quantity&) = default;  // NOLINT(modernize-use-nullptr)

    Quantity along(Component axis) const {
        Quantity result = *this;
        result.component = axis;
        return result;
    }
};

}  // namespace kinegraph
