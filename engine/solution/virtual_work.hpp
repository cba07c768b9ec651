// Virtual work: the powers of the external actions in the motion found, and of unit efforts.
#pragma once

#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/number/geometry.hpp"
#include "engine/number/recorded.hpp"
#include "engine/sentences/quantity.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// The powers of all external actions (loads, weights, inertia, efforts) in the motion found; their sum is zero. Also
/// Joukowsky's lever: forces at the tips of the velocities turned by a quarter turn, moments about the pole.
struct VirtualWork {
    struct Entry {
        Symbol symbol;
        Quantity quantity;  ///< the force or couple
        BodyIndex body = none;
        Vector at;        ///< place of application, m
        Vector velocity;  ///< of that place, m/s
        Vector force;     ///< N; zero for a couple
        Exact couple;     ///< N m
        Exact omega;      ///< of the body, rad/s
        Exact power;      ///< W
        struct Elements {
            ElementIndex at, velocity, force, couple, omega, power;
        } elements;  ///< of the record, none where it vanishes
    };
    /// The work of one N or N m of an unknown effort.
    struct Share {
        int effort = -1;            ///< index in Mechanism::efforts
        Recorded<Vector> velocity;  ///< of the point of application of a force; for an actuator, relative to its other
                                    ///< body
        Recorded<Exact> omega;      ///< of a couple's body, relative to the other
        Recorded<Exact> power;
        bool rests = false;  ///< the power is zero, by exact predicate
    };
    std::vector<Entry> entries;
    /// Of each load, weight, inertia force and effort: the sum of its powers on all bodies that it acts on.
    struct Power {
        Quantity quantity;  ///< the force or couple
        Recorded<Exact> power;
    };
    std::vector<Power> powers;  ///< in the order in which they first act; not for virtual displacements
    std::vector<Share> shares;  ///< for virtual displacements only (engine/solution/displacements.hpp); otherwise
                                ///< efforts are among the entries
    Exact total;                ///< of the entries; exactly zero on an exact pose where efforts are among them
    ElementIndex total_element = none;
};

}  // namespace kinegraph
