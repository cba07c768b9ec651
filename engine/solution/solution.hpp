// Solution: all results as values in SI units, with the protocol that produced them and the numbers of the check. Input
// of the results file, the tables and the drawing. Computes nothing.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/board/board.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/branches.hpp"
#include "engine/motion/mobility.hpp"
#include "engine/number/recorded.hpp"
#include "engine/sentences/quantity.hpp"
#include "engine/sentences/statement.hpp"
#include "engine/solution/truss.hpp"

namespace kinegraph {

/// A point as carried by one body, or by several that a pin holds together there.
struct PointMotion {
    PointIndex point = none;
    std::vector<BodyIndex> bodies;
    std::string label;  ///< "A"; "A*" where other bodies carry the same place without a pin
    Recorded<Vector> velocity, acceleration;
};
struct BodyMotion {
    Recorded<Exact> omega, alpha;
};
/// The motion of i relative to j at a sliding joint or a contact.
struct Sliding {
    JointIndex joint = none;
    Recorded<Vector> velocity, acceleration, coriolis;
};
/// The equivalent linkage of a contact of round or straight profiles, valid up to accelerations: a link between the
/// centres of curvature, or the one centre as a pin in a straight slot parallel to the other's line (a tip is its own
/// centre).
struct EquivalentLinkage {
    enum class Kind { link, slot } kind = Kind::link;
    JointIndex joint = none;
    std::array<BodyIndex, 2> bodies{none, none};   ///< slot: the pin's body, then the slot's
    std::array<PointIndex, 2> places{none, none};  ///< link: its ends on these bodies; slot: the pin, twice
};
/// An instant centre P_ij.
struct InstantCentre {
    BodyIndex first = frame, second = frame;  ///< frame first, then in the file's order
    enum class How { unknown, primary, kennedy, velocities, rest } how = How::unknown;
    Recorded<ProjectivePoint> at;     ///< finite or at infinity
    bool everywhere = false;          ///< the bodies have no relative motion
    bool as_one = false;              ///< … in any position: their joints make them one rigid body
    bool depends_on_drivers = false;  ///< several freedoms: valid for this ratio of the drivers
    std::vector<std::pair<int, int>>
        through;  ///< the lines used: pairs of indices into Solution::centres (P_ik, P_kj); empty for primary ones
    std::vector<PointIndex> normals;  ///< … or normals at these points
    int order = 0;                    ///< position in the order found
    StatementIndex statement = none;
};
/// The motion of a point seen by an observer.
struct RelativeMotion {
    RelativeMotionQuery query;
    Recorded<Vector> velocity, transport_velocity, relative_velocity;
    Recorded<Vector> acceleration, transport_acceleration, relative_acceleration, coriolis;
    /// The transport terms split at the origin O′ of the moving axes, a place of the observer's body: a_tr = a_O′ + α ∧
    /// O′P − ω² O′P.
    struct Apart {
        PointIndex origin = none, towards = none;  ///< the axis x′ points from the origin to the other point; without
                                                   ///< one: along x
        Recorded<Exact> omega, alpha;
        Recorded<Vector> origin_velocity, turning_velocity;  ///< v_tr = v_O′ + ω ∧ O′P
        Recorded<Vector> origin_acceleration, tangential, normal;
        /// The relative velocity and acceleration, split along x′ and y′.
        Recorded<Vector> velocity_along, velocity_across, acceleration_along, acceleration_across;
        /// Why there is no Coriolis term.
        enum class NoCoriolis {
            there_is,
            observer_does_not_turn,
            rests_for_observer
        } no_coriolis = NoCoriolis::there_is;
    };
    std::optional<Apart> apart;  ///< for observers on bodies, where accelerations are known
};
/// An angular velocity found a second time, from instant centres.
struct SecondWay {
    BodyIndex body = none;
    Recorded<Exact> omega;
    bool agrees = false;  ///< with the polygon, by an exact predicate
};
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
    enum class Kind {
        load,
        weight,
        inertia,
        spring,
        reaction,
        effort,
        resultant  ///< of all given actions; not an action itself: what is missing for equilibrium
    } kind = Kind::load;
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
    /// Index in Mechanism::loads (load, spring), masses (weight, inertia) or efforts (effort); −1: a reaction.
    int given = -1;
    /// The statement after which its line is known, or, for a given line, that first needs it; none: there is none.
    StatementIndex line_statement = none;
    StatementIndex force_statement = none;  ///< the statement that finds it; none: it is given
    /// By the check: the modulus in N; the couple in N m, with the sign of `couple`. None where equilibrium leaves them
    /// undetermined.
    std::optional<double> numeric_force, numeric_couple;
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
    bool in_parts = false;  ///< its forces are sums of parts or trials: no single statement closed its polygon
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
/// The parts of a figure of one body's instantaneous motion besides its velocities and centre.
struct InstantaneousMotionFigure {
    BodyIndex body = none;
    enum class Found {
        nothing,         ///< neither centre nor translation is known
        perpendiculars,  ///< the perpendiculars at `points` meet in the centre
        tips,  ///< parallel velocities at `points`: the line of their tips meets the line of the points in the centre
        point_at_rest,  ///< the one of `points` is the centre
        translation,    ///< the perpendiculars at `points` are parallel
        rest,           ///< the body does not move
        contradiction   ///< no rigid motion has the given values at `points`
    } found = Found::nothing;
    std::vector<PointIndex> points;
    /// Two velocities with different projections on the line of their points (first → second): the projections, m/s.
    struct Projections {
        PointIndex first = none, second = none;
        Recorded<Vector> of_first, of_second;
        Recorded<Vector> join;
        StatementIndex statement = none;  ///< the statement of the difference
    };
    std::optional<Projections> differing;
    Recorded<Vector> acceleration_centre;  ///< the place of the body whose acceleration vanishes, m
    std::string acceleration_centre_name;  ///< "K", or the first of K2, K3 … that is not a point of the file
    StatementIndex centre_statement = none, acceleration_centre_statement = none;
};
/// The centre of curvature of the path of a body's point.
struct PathCentre {
    PointIndex point = none;
    std::string label;  ///< of the point
    std::string name;   ///< of the centre: not a name of the file's points
    Recorded<ProjectivePoint>
        centre;  ///< at infinity where the path is straight to the second order; none where the point rests
    Recorded<ProjectivePoint>
        foot;             ///< of the inflection pole on the ray: there the path is straight; none in a translation
    bool is_pin = false;  ///< its path is known from a body that shares it: nothing new is found there
    StatementIndex statement = none;
};
/// A straight line carried by a body (guide, slot, profile): the centre of curvature of its envelope.
struct EnvelopeCentre {
    JointIndex joint = none;
    std::string name;          ///< of the centre
    Recorded<Vector> touches;  ///< the point of the line that touches its envelope: the pole's foot
    Recorded<Vector> centre;
    StatementIndex statement = none;
};
/// The geometry of one body's motion to second order in this position: the motion of its pole, and the curvature of the
/// paths of its points (docs/notation.md).
struct Curvature {
    BodyIndex body = none;
    enum class Kind {
        general,      ///< the pole moves: there are a pole tangent and an inflection circle
        turning,      ///< the pole is at rest, so all points move on circles about it
        translation,  ///< the pole lies at infinity
        rest
    } kind = Kind::general;
    /// A point whose path has a known centre of curvature; its ray passes through the pole.
    struct Ray {
        PointIndex point = none;
        std::string from, to;  ///< names; `to` is empty where the centre lies at infinity
        Recorded<Vector> at;
        Recorded<ProjectivePoint> centre;
    };
    std::vector<Ray> rays;                 ///< two, where Bobillier's construction gave the pole tangent
    Recorded<ProjectivePoint> axis_point;  ///< where the line of the points meets that of the centres
    Recorded<ProjectivePoint> pole;
    Recorded<Vector> tangent;          ///< of the pole: a direction
    Recorded<Vector> inflection_pole;  ///< the other end of the inflection circle's diameter through the pole, m
    Recorded<Vector> inflection_centre;
    Recorded<Vector> tangential_pole;  ///< the same for Bresse's second circle; none where α = 0: it is the pole normal
    Recorded<Vector> acceleration_pole;
    std::string inflection_name, tangential_name,
        acceleration_name;  ///< "J", "H", "K", or with a number: not a name of the file's points
    StatementIndex pole_statement = none, tangent_statement = none, inflection_statement = none,
                   bresse_statement = none;
    std::vector<PathCentre> points;
    std::vector<EnvelopeCentre> envelopes;
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
/// One scalar compared with the check.
struct CheckRow {
    Quantity quantity;  ///< of a vector: one component
    double graphical = 0, numeric = 0, difference = 0;
};
struct Unsolved {
    Message what;  ///< "velocity of body 3", "instant centre 2,5"
    Message why;
};

/// Results of a problem in place of joints, and of the contacts at joints (engine/solution/problem_solution.hpp).
struct ProblemSolution;
struct SolvedContacts;
/// The closure equations (engine/equations/equations.hpp).
struct Equations;
/// Virtual displacements and their work (engine/solution/displacements.hpp).
struct Displacements;

struct Solution {
    Mechanism mechanism;
    Pose pose;
    Mobility mobility;
    std::optional<InstantMotion> instant_motion;  ///< where constraints are redundant or a driver drives nothing
    Protocol protocol;
    /// Numbers of strokes when these results were found. A program cut to them must keep the earlier verdicts.
    struct Settled {
        int velocities = 0, accelerations = 0, forces = 0;
    } settled;
    std::vector<PointMotion> points;  ///< in the file's order of points
    std::vector<BodyMotion> bodies;   ///< by BodyIndex
    std::vector<Sliding> sliding;
    std::vector<EquivalentLinkage> equivalent_linkages;  ///< of the contacts, as used to draw the motion
    std::vector<InstantCentre> centres;                  ///< all n(n−1)/2, in the order of their keys
    std::vector<RelativeMotion> relative_motion;
    std::vector<SecondWay> second_way;
    std::vector<JointForce> forces;
    std::vector<EffortValue> efforts;
    std::vector<FreeBody> free_bodies;
    std::vector<TakenTogether> taken_together;
    std::optional<Superposition> superposition;  ///< if used to find the forces
    std::vector<Resultant> resultants;           ///< if the file requests a check of equilibrium
    std::optional<Truss> truss;                  ///< if the mechanism is a truss
    std::vector<VirtualMotion> virtual_motions;  ///< used to find forces that do not depend on redundant constraints
    std::vector<Curvature> curvature;            ///< if requested: of the moving bodies in the file's order
    std::optional<VirtualWork> virtual_work;     ///< where forces and velocities are known
    std::optional<InstantaneousMotionFigure>
        instantaneous_motion;                            ///< if the file gives the instantaneous motion of one body
    std::shared_ptr<const ProblemSolution> problem;      ///< if the file states one: then it is the whole solution
    std::shared_ptr<const SolvedContacts> contacts;      ///< if joints have materials
    std::shared_ptr<const Equations> equations;          ///< if requested
    std::shared_ptr<const Displacements> displacements;  ///< if requested
    std::vector<CheckRow> checks;
    /// By Protocol::vectors: the modulus of a velocity or an acceleration by the check, SI; none where undetermined by
    /// it.
    std::vector<std::optional<double>> numeric_moduli;
    std::vector<Unsolved> unsolved;  ///< not empty: exit 3
    std::vector<Message> remarks;    ///< redundant constraints, points moved onto curves …

    // Defined in one source file: inlining them in every user would cost seconds of compile time.
    Solution();
    Solution(const Solution&);
    Solution(Solution&&) noexcept;
    Solution& operator=(const Solution&);
    Solution& operator=(Solution&&) noexcept;
    ~Solution();
};

/// Reads the value of every element in the results from the values of a record: of the drawn pose, or of a replay.
void read_values(Solution& solution, const std::vector<Value>& values);
/// The quantities of these values.
Quantity velocity_of(const PointMotion& motion);
Quantity acceleration_of(const PointMotion& motion);
Quantity quantity_of(const InstantCentre& centre);
Quantity quantity_of(const JointForce& action);
Quantity quantity_of(const FreeBody& body, const AppliedForce& applied);

/// Renders a message in English.
using Teller = std::function<std::string(const Message&)>;

/// The results file of docs/results.md (SI, one line a value group); `exact` adds fractions.
std::string results_json(const Solution& solution, bool exact, const Teller& tell);

}  // namespace kinegraph
