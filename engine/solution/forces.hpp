// What was found of the forces: at joints, of efforts, on bodies cut free, in trusses. Values in SI units, each with
// the element of the record that holds it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/board/protocol.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/number/geometry.hpp"
#include "engine/number/recorded.hpp"
#include "engine/sentences/quantity.hpp"
#include "engine/sentences/statement.hpp"
#include "engine/solution/truss.hpp"
#include "engine/solution/virtual_work.hpp"

namespace kinegraph {

/// The action of one body on another at a joint, reduced to the joint's point. At a hinge of three bodies or more the
/// pin acts on each: `from` is none then.
struct JointForce {
    JointIndex joint = none;
    BodyIndex on = none, from = none;
    Recorded<Vector> force;  ///< N
    Recorded<Exact> couple;  ///< N m about the joint's point, counter-clockwise positive
    /// Where equilibrium does not determine the force: the one component that is the same in every equilibrium (N, as a
    /// vector) and the direction along which it is taken.
    Recorded<Vector> component, along;
};
/// The unit vector along which a component is measured: dx > 0, or (0, 1). Rounded where it is irrational.
Vector unit_of_component(const JointForce& action);
/// The component along that direction, N.
double component_of(const JointForce& action);
/// The balancing unknown: a couple (N m) or a force (N) along its line.
struct EffortValue {
    std::string name;
    Recorded<Exact> value;
};
/// One force or couple on a free body.
struct AppliedForce {
    Symbol symbol;
    /// A load (springs are loads), a weight, an inertia force, a force at a joint, an effort; or the resultant of all
    /// given actions, which is no action itself: what is missing for equilibrium.
    Quantity::Kind kind = Quantity::Kind::load;
    JointIndex joint = none;  ///< reactions
    BodyIndex from = none;    ///< the body that acts; none: no body, or a pin
    Vector force;             ///< N; zero for a pure couple
    Exact couple;             ///< N m about `at`
    Vector at;                ///< a place on the line of action (m); for a couple the place it is drawn at
    struct Elements {
        ElementIndex force, couple, at;
    } elements;                         ///< of the record, none where it vanishes
    bool line_by_construction = false;  ///< its line of action was constructed, not given
    bool is_component = false;  ///< for a reaction that equilibrium does not determine: the component that is the same
                                ///< in every equilibrium
    int given = -1;             ///< as Quantity::given; −1: a reaction
    /// The statement after which its line is known, or, for a given line, that first needs it; none: there is none.
    StatementIndex line_statement = none;
    StatementIndex force_statement = none;  ///< the statement that finds it; none: it is given
    /// By the check: the modulus in N; the couple in N m, with the sign of `couple`. None where equilibrium leaves them
    /// undetermined.
    std::optional<double> numeric_force, numeric_couple;

    bool is_reaction() const { return kind == Quantity::Kind::force; }
    bool is_resultant() const { return kind == Quantity::Kind::resultant; }
};
/// A body cut free, with all that acts on it; the forces close its polygon.
struct FreeBody {
    BodyIndex body = none;  ///< none: the pin of a multiple hinge at `pin`
    PointIndex pin = none;
    std::vector<AppliedForce> forces;  ///< in the order of the polygon: known forces first
    /// A point of concurrency that was used.
    struct Meet {
        std::string name;
        Vector place;
        StatementIndex statement = none;  ///< the statement that finds it
        ElementIndex element = none;      ///< of the record
    };
    std::vector<Meet> meets;
    /// A moment arm: from the centre of moments to the foot of the perpendicular on a line of action.
    struct Arm {
        std::string name;  ///< of the centre of moments; a point of the file, or a new letter
        Vector about, foot;
        StatementIndex statement = none;  ///< the statement that takes the moment
        bool is_sought = false;           ///< arm of the force that the statement finds
        bool is_shift = false;            ///< displacement of a force that replaces force and couple: d, not b
        struct Elements {
            ElementIndex about, foot;
        } elements;  ///< of the record
    };
    std::vector<Arm> arms;
    /// Intermediate sums, of the kind resultant: known forces added to one, a force and a couple combined to a
    /// displaced force, the force on Culmann's line. Only lines and sides of the construction, no actions.
    std::vector<AppliedForce> sums;
    /// The funicular polygon with which two reactions balance the known forces: one reaction along a line, one at a
    /// place or also along a line.
    struct Funicular {
        StatementIndex statement = none;
        Symbol first, second;                   ///< the reactions: the one along the line, the one at the place
        std::vector<Symbol> known;              ///< in the order of the corners
        std::vector<Recorded<Vector>> corners;  ///< of the known forces, tip to tail, N
        Recorded<Vector> pole, dividing;        ///< pole of the rays, N; the point between the reactions
        std::vector<Recorded<Vector>>
            vertices;                ///< of the strings, m: at the place, on each known line, on the first one's line
        Recorded<Vector> resultant;  ///< where the outer strings intersect, m: on the line of the resultant; none: they
                                     ///< are parallel
    };
    std::optional<Funicular> funicular;
    std::vector<Symbol> open;         ///< forces and couples on it that equilibrium does not determine
    int polygon = -1;                 ///< index in Protocol::polygons; −1 where all forces vanish
    StatementIndex statement = none;  ///< after which all its forces are known
    bool in_parts = false;            ///< its forces are sums of parts: no single statement closed its polygon
};
/// Bodies that were balanced as one, with the polygon of the external actions on them.
struct TakenTogether {
    std::vector<BodyIndex> bodies;   ///< pins left out
    std::vector<AppliedForce> sums;  ///< as FreeBody::sums
    /// The funicular polygon that found their reactions; its strings run across all bodies.
    std::optional<FreeBody::Funicular> funicular;
    int polygon = -1;                 ///< index in Protocol::polygons; −1: no more than two forces
    StatementIndex statement = none;  ///< the statement that closes it
};
/// Superposition: for loads that no order of bodies resolves at once. The loads of one body act at a time, and the
/// results are added.
struct Superposition {
    struct Part {
        BodyIndex body = none;  ///< whose loads act alone; none: those of the pin
        PointIndex pin = none;
        StatementIndex first = none,
                       end = none;     ///< its sentences: from the one that opens it to the one past its last
        std::vector<FreeBody> bodies;  ///< cut free under these loads, without those that carry nothing
        std::vector<TakenTogether> together;
    };
    std::vector<Part> parts;
    /// The partial forces of one action at a joint (or of an effort), tip to tail, and their sum.
    struct Sum {
        Symbol symbol;
        BodyIndex body = none;  ///< on which it acts
        int polygon = -1;       ///< index in Protocol::polygons
    };
    std::vector<Sum> sums;
    /// The polygon of one body under all loads: its own loads, then the partial forces of each reaction and their sum.
    struct Joined {
        BodyIndex body = none;  ///< none: the pin
        PointIndex pin = none;
        int polygon = -1;  ///< index in Protocol::polygons
    };
    std::vector<Joined> joined;
    struct CoupleSum {
        Symbol symbol;
        std::vector<Recorded<Exact>> parts;  ///< N m, those that do not vanish
        Recorded<Exact> total;
    };
    std::vector<CoupleSum> couples;
    StatementIndex statement = none;  ///< the statement that adds them
};
/// The given actions on connected bodies that no effort balances, reduced to one force along a line, one couple, or
/// nothing.
struct Resultant {
    std::vector<BodyIndex> bodies;  ///< in the file's order
    Recorded<Vector> force;         ///< N
    Recorded<Exact> couple;         ///< N m about the frame's origin
    Recorded<Vector>
        through;  ///< the foot of the perpendicular from the origin on its line, m; none: there is no force
    /// For a body with one freedom: the point about which it rotates, and the moment of the given actions about it; or
    /// the component of the force along which it moves.
    Recorded<Vector> about, residual_force;
    Recorded<Exact> residual_couple;
    bool vanishes = false;  ///< the bodies are in equilibrium under the given actions
    int polygon = -1;       ///< index in Protocol::polygons: the given forces, with the gap; −1: all vanish
    StatementIndex statement = none;
};
/// A motion that every constraint allows except the one whose force is wanted. That force is the only unknown that does
/// work, so virtual work gives it, in spite of redundant constraints.
struct VirtualMotion {
    StatementIndex statement = none;
    Symbol sought;
    Recorded<Vector> force;  ///< the force it gives, N; none: a couple is wanted
    Recorded<Exact> couple;  ///< N m
    struct Turning {
        BodyIndex body = none;
        Recorded<Exact> omega;  ///< in an arbitrary unit; none: it translates
    };
    std::vector<Turning> bodies;  ///< the bodies that move, in the file's order
};

/// At all joints and on all bodies.
struct SolvedForces {
    std::vector<JointForce> forces;
    std::vector<EffortValue> efforts;
    std::vector<FreeBody> free_bodies;
    std::vector<TakenTogether> taken_together;
    std::optional<Superposition> superposition;  ///< if used to find the forces
    std::vector<Resultant> resultants;           ///< if the file requests a check of equilibrium
    std::optional<Truss> truss;                  ///< if the mechanism is a truss
    std::vector<VirtualMotion> virtual_motions;  ///< used to find forces that do not depend on redundant constraints
    std::optional<VirtualWork> virtual_work;     ///< where forces and velocities are known
};

/// The quantities of these values.
Quantity quantity_of(const JointForce& action);
Quantity quantity_of(const FreeBody& body, const AppliedForce& applied);

/// The displacement d = M/F of a sum's line of action by the statement, perpendicular to it, m. None: the statement
/// displaces another force, or none. `bodies`: cut free under all loads, or under those of one body alone.
std::optional<Vector> shift_of(const Protocol& protocol, const std::vector<FreeBody>& bodies, StatementIndex statement,
                               const AppliedForce& sum);

}  // namespace kinegraph
