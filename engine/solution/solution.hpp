// Solution: everything that was found, as values in SI units, with the protocol that found it and the numbers of the
// check beside it. What the results file, the tables and the drawing are made of. Computes nothing.
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
    std::string label;  ///< "A", "A*" where other bodies carry the same place without a pin
    Recorded<Vector> velocity, acceleration;
};
struct BodyMotion {
    Recorded<Exact> omega, alpha;
};
/// i seen from j at a sliding joint or a contact.
struct Sliding {
    JointIndex joint = none;
    Recorded<Vector> velocity, acceleration, coriolis;
};
/// What stands for a contact of round or straight profiles up to accelerations: a link between the centres of
/// curvature, or the one centre as a pin in a straight slot parallel to the other's line (a tip is its own centre).
struct EquivalentLinkage {
    enum class Kind { link, slot } kind = Kind::link;
    JointIndex joint = none;
    std::array<BodyIndex, 2> bodies{none, none};   ///< slot: the pin's body, then the slot's
    std::array<PointIndex, 2> places{none, none};  ///< link: its ends on these bodies; slot: the pin twice
};
/// An instant centre P_ij.
struct InstantCentre {
    BodyIndex first = frame, second = frame;  ///< frame first, then in the file's order
    enum class How { unknown, primary, kennedy, velocities } how = How::unknown;
    Recorded<ProjectivePoint> at;     ///< finite or at infinity
    bool everywhere = false;          ///< the bodies do not move against each other
    bool depends_on_drivers = false;  ///< more than one freedom: holds for this ratio of the drivers
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
    /// The transport parted about the origin O′ of the moving axes, a place of the observer's body: a_tr = a_O′ + α ∧
    /// O′P − ω² O′P.
    struct Apart {
        PointIndex origin = none, towards = none;  ///< the axis x′ points from the one to the other; no other: along x
        Recorded<Exact> omega, alpha;
        Recorded<Vector> origin_velocity, turning_velocity;  ///< v_tr = v_O′ + ω ∧ O′P
        Recorded<Vector> origin_acceleration, tangential, normal;
        /// The relative velocity and acceleration, parted along x′ and y′.
        Recorded<Vector> velocity_along, velocity_across, acceleration_along, acceleration_across;
        /// Why there is no Coriolis term.
        enum class NoCoriolis {
            there_is,
            observer_does_not_turn,
            rests_for_observer
        } no_coriolis = NoCoriolis::there_is;
    };
    std::optional<Apart> apart;  ///< of observers on bodies, where accelerations are known
};
/// An angular velocity found a second time, by instant centres.
struct SecondWay {
    BodyIndex body = none;
    Recorded<Exact> omega;
    bool agrees = false;  ///< with the polygon, by exact predicate
};
/// The action of one body on another at a joint, reduced to the joint's point. At a hinge of three bodies or more the
/// pin acts on each: `from` is none then.
struct JointForce {
    JointIndex joint = none;
    BodyIndex on = none, from = none;
    Recorded<Vector> force;  ///< N
    Recorded<Exact> couple;  ///< N m about the joint's point, counter-clockwise positive
    /// Where equilibrium does not determine the force: the one component that every equilibrium has alike (N, as a
    /// vector) and the direction along which it is taken.
    Recorded<Vector> component, along;
};
/// The unit vector along which a component is counted: dx > 0, or (0, 1). Rounded where it is no fraction.
Vector unit_of_component(const JointForce& action);
/// The component along that, N.
double component_of(const JointForce& action);
/// The unknown that balances: a couple (N m) or a force (N) along its line.
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
        resultant  ///< of all that is given: it acts on nothing, it is what is missing to equilibrium
    } kind = Kind::load;
    JointIndex joint = none;  ///< reactions
    BodyIndex from = none;    ///< which body acts, none: no body or a pin
    Vector force;             ///< N; zero for a pure couple
    Exact couple;             ///< N m about `at`
    Vector at;                ///< a place on the line of action (m); for a couple the place it is drawn at
    struct Elements {
        ElementIndex force, couple, at;
    } elements;                         ///< of the record, none where it vanishes
    bool line_by_construction = false;  ///< its line of action was deduced, not given
    bool is_component = false;  ///< of a reaction that equilibrium does not determine: what every equilibrium has alike
    /// Index in Mechanism::loads (load, spring), masses (weight, inertia) or efforts (effort); −1: a reaction.
    int given = -1;
    /// The statement after which its line is known, or that first needs the line of what is given; none: no one does.
    StatementIndex line_statement = none;
    StatementIndex force_statement = none;  ///< that finds it; none: it is given
    /// By the check: the modulus in N; the couple in N m, as `couple` counts. None where equilibrium leaves them open.
    std::optional<double> numeric_force, numeric_couple;
};
/// A body cut free, with all that acts on it; the forces close its polygon.
struct FreeBody {
    BodyIndex body = none;  ///< none: the pin of a multiple hinge at `pin`
    PointIndex pin = none;
    std::vector<AppliedForce> forces;  ///< in the order of the polygon: what was known first
    /// A point of concurrency that was used.
    struct Meet {
        std::string name;
        Vector place;
        StatementIndex statement = none;  ///< that finds it
        ElementIndex element = none;      ///< of the record
    };
    std::vector<Meet> meets;
    /// An arm by which a moment was taken: from the place about which to the foot of the perpendicular on a line of
    /// action.
    struct Arm {
        std::string name;  ///< of the place about which; a point of the file, or a letter of its own
        Vector about, foot;
        StatementIndex statement = none;  ///< that takes the moment
        bool is_sought = false;           ///< of the force that the statement finds
        bool is_shift = false;            ///< by which a force with a couple is moved aside: d, not b
        struct Elements {
            ElementIndex about, foot;
        } elements;  ///< of the record
    };
    std::vector<Arm> arms;
    /// What was added up on the way, of the kind resultant: known forces to one, a force and a couple to the force
    /// moved aside, what is on Culmann's line. Lines and sides of the construction; they act on nothing.
    std::vector<AppliedForce> sums;
    /// The funicular polygon by which two reactions balance what is known: one along a line, one at a place or on a
    /// line too.
    struct Funicular {
        StatementIndex statement = none;
        Symbol first, second;                   ///< the reactions: of the line, of the place
        std::vector<Symbol> known;              ///< in the order of the corners
        std::vector<Recorded<Vector>> corners;  ///< of the known forces, tip to tail, N
        Recorded<Vector> pole, dividing;        ///< of the rays, N; where the reactions meet
        std::vector<Recorded<Vector>>
            vertices;                ///< of the strings, m: at the place, on each known line, on the first one's line
        Recorded<Vector> resultant;  ///< where the outer strings meet, m: the resultant passes there; none: nowhere
    };
    std::optional<Funicular> funicular;
    std::vector<Symbol> open;         ///< forces and couples on it that equilibrium does not determine
    int polygon = -1;                 ///< index in Protocol::polygons; −1 where all forces vanish
    StatementIndex statement = none;  ///< after which all its forces are known
    bool in_parts = false;  ///< its forces are sums of parts or trials: its polygon was closed by no one statement
};
/// Bodies that were balanced as one: their polygon of what acts on them from outside.
struct TakenTogether {
    std::vector<BodyIndex> bodies;   ///< pins left out
    std::vector<AppliedForce> sums;  ///< as FreeBody::sums
    /// By which their reactions were found; its strings run from force to force over them all.
    std::optional<FreeBody::Funicular> funicular;
    int polygon = -1;                 ///< index in Protocol::polygons; −1: no more than two forces
    StatementIndex statement = none;  ///< that closes it
};
/// Loads that no order of bodies resolves at once, those of one body after those of another; what they cause is added.
struct Superposition {
    struct Part {
        BodyIndex body = none;  ///< whose loads act alone; none: of the pin
        PointIndex pin = none;
        StatementIndex first = none,
                       end = none;     ///< its sentences: from the one that opens it to the one past its last
        std::vector<FreeBody> bodies;  ///< cut free under these loads; those that carry nothing are left out
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
    struct CoupleSum {
        Symbol symbol;
        std::vector<Recorded<Exact>> parts;  ///< N m, those that do not vanish
        Recorded<Exact> total;
    };
    std::vector<CoupleSum> couples;
    StatementIndex statement = none;  ///< that adds them
};
/// The powers of all that acts from outside (loads, weights, inertia, efforts) in the motion found: they add up to
/// nothing. It is Joukowsky's lever too: forces at the tips of the velocities turned a quarter, moments about the pole.
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
    /// What one N or N m of an effort of unknown size does.
    struct Share {
        int effort = -1;            ///< index in Mechanism::efforts
        Recorded<Vector> velocity;  ///< of the place where a force acts; of an actuator's, seen from its other body
        Recorded<Exact> omega;      ///< of a couple's body, seen from the other
        Recorded<Exact> power;
        bool rests = false;  ///< the power is zero, by exact predicate
    };
    std::vector<Entry> entries;
    std::vector<Share> shares;  ///< of virtual displacements alone (engine/solution/displacements.hpp); else efforts
                                ///< are among the entries
    Exact total;                ///< of the entries; exactly zero on an exact pose where efforts are among them
    ElementIndex total_element = none;
};
/// What a figure of one body's act of motion shows besides its velocities and centre.
struct ActFigure {
    BodyIndex body = none;
    enum class Found {
        nothing,         ///< neither centre nor translation is known
        perpendiculars,  ///< the perpendiculars at `points` meet in the centre
        tips,  ///< parallel velocities at `points`: the join of their tips meets that of the points in the centre
        point_at_rest,  ///< the one of `points` is the centre
        translation,    ///< the perpendiculars at `points` are parallel
        rest,           ///< the body does not move
        contradiction   ///< no rigid motion has what is given at `points`
    } found = Found::nothing;
    std::vector<PointIndex> points;
    /// Where two velocities project differently on the join of their points (first → second): the projections, m/s.
    struct Projections {
        PointIndex first = none, second = none;
        Recorded<Vector> of_first, of_second;
        Recorded<Vector> join;
        StatementIndex statement = none;  ///< that says by how much
    };
    std::optional<Projections> differing;
    Recorded<Vector> acceleration_centre;  ///< the place of the body whose acceleration vanishes, m
    std::string acceleration_centre_name;  ///< "K", or the first of K2, K3 … that no point of the file has
    StatementIndex centre_statement = none, acceleration_centre_statement = none;
};
/// Of a body's point: where the path that it describes has its centre of curvature.
struct PathCentre {
    PointIndex point = none;
    std::string label;  ///< of the point
    std::string name;   ///< of the centre: no point of the file has it
    Recorded<ProjectivePoint>
        centre;  ///< at infinity where the path is straight to the second order; none where the point rests
    Recorded<ProjectivePoint>
        foot;             ///< of the inflection pole on the ray: there the path is straight; none in a translation
    bool is_pin = false;  ///< its path is known from a body that shares it: nothing new is found there
    StatementIndex statement = none;
};
/// Of a straight line that a body carries (guide, slot, profile): where its envelope has its centre of curvature.
struct EnvelopeCentre {
    JointIndex joint = none;
    std::string name;          ///< of the centre
    Recorded<Vector> touches;  ///< the point of the line that touches its envelope: the pole's foot
    Recorded<Vector> centre;
    StatementIndex statement = none;
};
/// The geometry of one body's motion to the second order at this position: how its pole moves, and how the paths of its
/// points are curved (docs/notation.md).
struct Curvature {
    BodyIndex body = none;
    enum class Kind {
        general,      ///< the pole moves: there are a pole tangent and an inflection circle
        turning,      ///< the pole rests, so all points move on circles about it
        translation,  ///< the pole lies at infinity
        rest
    } kind = Kind::general;
    /// A point whose path has a known centre of curvature; its ray passes the pole.
    struct Ray {
        PointIndex point = none;
        std::string from, to;  ///< names; `to` is empty where the centre lies at infinity
        Recorded<Vector> at;
        Recorded<ProjectivePoint> centre;
    };
    std::vector<Ray> rays;                 ///< two, where Bobillier's construction gave the pole tangent
    Recorded<ProjectivePoint> axis_point;  ///< where the join of the points meets that of the centres
    Recorded<ProjectivePoint> pole;
    Recorded<Vector> tangent;          ///< of the pole: a direction
    Recorded<Vector> inflection_pole;  ///< the other end of the inflection circle's diameter through the pole, m
    Recorded<Vector> inflection_centre;
    Recorded<Vector> tangential_pole;  ///< the same of Bresse's second circle; none where α = 0: it is the pole normal
    Recorded<Vector> acceleration_pole;
    std::string inflection_name, tangential_name,
        acceleration_name;  ///< "J", "H", "K", or with a number: no point's of the file
    StatementIndex pole_statement = none, tangent_statement = none, inflection_statement = none,
                   bresse_statement = none;
    std::vector<PathCentre> points;
    std::vector<EnvelopeCentre> envelopes;
};
/// All that is given on bodies that hang together and that no effort balances, as one force along a line, one couple,
/// or nothing.
struct Resultant {
    std::vector<BodyIndex> bodies;  ///< in the file's order
    Recorded<Vector> force;         ///< N
    Recorded<Exact> couple;         ///< N m about the frame's origin
    Recorded<Vector>
        through;  ///< the foot of the perpendicular from the origin on its line, m; none: there is no force
    /// Of a body whose joints leave it one freedom: the place about which it turns, and the moment of what is given
    /// about that; or the part of the force along which it goes.
    Recorded<Vector> about, residual_force;
    Recorded<Exact> residual_couple;
    bool vanishes = false;  ///< the bodies are in equilibrium under what is given
    int polygon = -1;       ///< index in Protocol::polygons: the given forces, with the gap; −1: all vanish
    StatementIndex statement = none;
};
/// A motion that every constraint allows but the one whose force is sought: of what is unknown only that does work in
/// it, so virtual work gives it, whatever redundant constraints bear.
struct VirtualMotion {
    StatementIndex statement = none;
    Symbol sought;
    Recorded<Vector> force;  ///< that it gives, N; none: a couple is sought
    Recorded<Exact> couple;  ///< N m
    struct Turning {
        BodyIndex body = none;
        Recorded<Exact> omega;  ///< in some unit; none: it translates
    };
    std::vector<Turning> bodies;  ///< that move, in the file's order
};
/// One scalar held against the check.
struct CheckRow {
    Quantity quantity;  ///< of a vector: one component
    double graphical = 0, numeric = 0, difference = 0;
};
struct Unsolved {
    Message what;  ///< "velocity of body 3", "instant centre 2,5"
    Message why;
};

/// What was found of contact, wear or impact, or of contacts at joints (engine/mechanism/problem.hpp).
struct ProblemSolution;
/// The closure equations (engine/equations/equations.hpp).
struct Equations;
/// Virtual displacements and their work (engine/solution/displacements.hpp).
struct Displacements;

struct Solution {
    Mechanism mechanism;
    Pose pose;
    Mobility mobility;
    std::optional<InstantMotion> instant_motion;  ///< where constraints repeat each other or a driver drives nothing
    Protocol protocol;
    /// How many strokes there were when these were found: what a program cut to them must keep the verdicts of.
    struct Settled {
        int velocities = 0, accelerations = 0, forces = 0;
    } settled;
    std::vector<PointMotion> points;  ///< in the file's order of points
    std::vector<BodyMotion> bodies;   ///< by BodyIndex
    std::vector<Sliding> sliding;
    std::vector<EquivalentLinkage> equivalent_linkages;  ///< of the contacts that the motion was drawn by
    std::vector<InstantCentre> centres;                  ///< all n(n−1)/2, in the order of their keys
    std::vector<RelativeMotion> relative_motion;
    std::vector<SecondWay> second_way;
    std::vector<JointForce> forces;
    std::vector<EffortValue> efforts;
    std::vector<FreeBody> free_bodies;
    std::vector<TakenTogether> taken_together;
    std::optional<Superposition> superposition;  ///< by which the forces were found, where they were
    std::vector<Resultant> resultants;           ///< where the file asks whether bodies are in equilibrium
    std::optional<Truss> truss;                  ///< where the mechanism is one
    std::vector<VirtualMotion> virtual_motions;  ///< by which forces were found that redundant constraints leave alone
    std::vector<Curvature> curvature;            ///< where it is asked for: of the moving bodies in the file's order
    std::optional<VirtualWork> virtual_work;     ///< where forces and velocities are known
    std::optional<ActFigure> act_of_motion;      ///< where the file gives one body's act of motion
    std::shared_ptr<const ProblemSolution>
        problem;                                 ///< where the file states one; in place of joints it is all there is
    std::shared_ptr<const Equations> equations;  ///< where they are asked for
    std::shared_ptr<const Displacements> displacements;  ///< the same
    std::vector<CheckRow> checks;
    /// By Protocol::vectors: the modulus of a velocity or an acceleration by the check, SI; none where it does not
    /// determine it.
    std::vector<std::optional<double>> numeric_moduli;
    std::vector<Unsolved> unsolved;  ///< not empty: exit 3
    std::vector<Message> remarks;    ///< redundant constraints, points moved onto curves …

    // Made, copied and ended in one place: in every file that holds one it would cost seconds of compiling.
    Solution();
    Solution(const Solution&);
    Solution(Solution&&) noexcept;
    Solution& operator=(const Solution&);
    Solution& operator=(Solution&&) noexcept;
    ~Solution();
};

/// Reads the value of every element that the results name from the elements of a record: the drawn pose's, or a
/// replay's.
void read_values(Solution& solution, const std::vector<Value>& values);
/// What these are values of.
Quantity velocity_of(const PointMotion& motion);
Quantity acceleration_of(const PointMotion& motion);
Quantity quantity_of(const InstantCentre& centre);
Quantity quantity_of(const JointForce& action);
Quantity quantity_of(const FreeBody& body, const AppliedForce& applied);

/// Says a message in English.
using Teller = std::function<std::string(const Message&)>;

/// The results file of docs/results.md (SI, one line a value group); `exact` adds fractions.
std::string results_json(const Solution& solution, bool exact, const Teller& tell);

}  // namespace kinegraph
