// Quantities: identifies a value of a solution: its kind, body, point, joint and observer. The same quantity always
// compares equal. Contains no value and no typography.
#pragma once

#include <compare>
#include <string>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

struct Quantity {
    enum class Kind {
        unnamed,
        velocity,      ///< of `point` as carried by `body`; `part` selects a component or the observer `other`
        acceleration,  ///< the same
        omega,         ///< of `body`
        alpha,
        centre,            ///< of `body` and `other`
        sliding_velocity,  ///< at `joint`, of its first body on its second
        sliding_acceleration,
        sliding_coriolis,
        force,            ///< at `joint`, exerted by `other` on `body` (none: the pin of a multiple hinge)
        couple,           ///< the same, about the joint's point
        force_component,  ///< of such a force, along the only direction in which every equilibrium has the same
                          ///< component
        load,             ///< `given`: index in Mechanism::loads
        weight,           ///< `given`: index in Mechanism::masses
        inertia,
        effort,               ///< `given`: index in Mechanism::efforts
        radius,               ///< of curvature, of the path of `point` as carried by `body`
        inflection_diameter,  ///< of the inflection circle of `body`
        acceleration_pole,    ///< of `body`
        virtual_power,        ///< of all external actions
        virtual_effort,       ///< the effort `given`, by virtual displacements
        resultant,            ///< of everything given on `body` and the bodies connected to it
        resultant_couple,     ///< the same, about the origin
        bar,                  ///< the force in the bar `body` of a truss, tension positive
        power_of_load,        ///< `given`: index in Mechanism::loads
        power_of_weight,      ///< `given`: index in Mechanism::masses
        power_of_inertia,
        power_of_effort,     ///< `given`: index in Mechanism::efforts
        transmission_angle,  ///< at `joint`, between the coupler `other` and the link `body` that it drives
        cut_moment,          ///< of the known actions, in the cut `given` of a truss, that finds the bar `body`
        cut_arm,             ///< … and of that bar, about the meet of the others
        cut_across,          ///< where these are parallel: of the known actions the component across them
        cut_sine             ///< … and of the angle of that bar with them
    } kind = Kind::unnamed;
    BodyIndex body = none, other = none;
    PointIndex point = none;
    JointIndex joint = none;
    int given = -1;
    /// The part of a velocity or an acceleration.
    enum class Part { whole, relative, normal, tangential, sliding, coriolis, transport } part = Part::whole;
    PointIndex seen_from = none;  ///< the point of `other` relative to which a part is measured
    enum class Component { whole, x, y } component = Component::whole;

    // clang-tidy 14 mistakes the compiler-generated comparison with 0 for a null pointer.
    friend auto operator<=>(const Quantity&, const Quantity&) = default;  // NOLINT(modernize-use-nullptr)

    Quantity along(Component axis) const {
        Quantity result = *this;
        result.component = axis;
        return result;
    }
};

}  // namespace kinegraph
