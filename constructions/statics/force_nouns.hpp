// Types of the force computation: bodies and pins as members, interactions of bodies (bonds), what is known of them in
// one run, loads, wrenches, and intermediate constructions. Data only. What engine/solution/forces.hpp tells of a
// construction has its name here too: there its values, here its elements.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/board/board.hpp"
#include "engine/solution/forces.hpp"

namespace kinegraph::statics {

constexpr Plane drawing = Plane::drawing;
inline std::size_t at(auto index) { return at_index(index); }

/// A body of the mechanism, or a pin of a multiple hinge. Pins come after the bodies.
using MemberIndex = ListIndex<struct Member>;
using Group = std::vector<MemberIndex>;
constexpr MemberIndex member_of(BodyIndex body) { return MemberIndex(body.number()); }

using PlaceOnDrawing = PointOn<Plane::drawing>;
using Force = VectorOn<Plane::force>;

/// A line of action on the board: a place on it and its direction.
struct Action {
    PlaceOnDrawing place;
    DirectionHandle direction;
    LineOn<drawing> line;
};

/// The interaction of two bodies.
struct Bond {
    enum class Kind { pin, guide, line, couple, clamp } kind = Kind::pin;
    MemberIndex first, second;  ///< positive force acts on `first`
    JointIndex joint = none;
    int effort = -1;
    PlaceOnDrawing place;
    DirectionHandle direction;  ///< line: along it; guide: normal to it
    Symbol symbol;              ///< of the force on `first`
    Symbol reverse;             ///< of the force on `second`
};

inline bool is_on_frame(const Bond& bond) { return bond.first == member_of(frame) || bond.second == member_of(frame); }

/// What is known of a bond in one run.
struct Reaction {
    bool known = false;
    std::optional<Force> force;             ///< on the bond's first member; none: zero
    std::optional<ScalarHandle> couple;     ///< about the bond's place; none: zero
    std::optional<Action> action;           ///< its line, which may be known before the magnitude
    bool only_couple = false;               ///< a guide whose force is known to vanish
    bool deduced = false;                   ///< the line was found, not given
    StatementIndex line_statement = none;   ///< the first that finds or uses its line
    StatementIndex force_statement = none;  ///< the one that finds it
    /// For an unknown reaction, the part that every equilibrium shares: the whole force, its component along one
    /// direction, the couple.
    enum class Alike { nothing, component, force } alike = Alike::nothing;
    bool couple_alike = false;
    std::optional<DirectionHandle> along;  ///< of the component, which is in `force`
    std::string axis, across;              ///< superscripts of the component, and of the one that stays open
};

/// All forces on a body, reduced: zero, a couple, or a force along a line.
struct Wrench {
    std::optional<Force> force;
    PlaceOnDrawing place;
    std::optional<ScalarHandle> couple;  ///< only if there is no force

    bool vanishes() const { return !force && !couple; }
};

/// A load on one member.
struct Load {
    MemberIndex member;
    Symbol symbol;
    Quantity::Kind kind = Quantity::Kind::load;  ///< as AppliedForce::kind
    std::optional<Force> force;
    PlaceOnDrawing place;
    std::optional<ScalarHandle> couple;
    int given = -1;  ///< as AppliedForce::given
};

/// A member that was solved, for its free-body diagram.
struct Resolved {
    MemberIndex member;
};

/// The virtual motion that gave a force where no order of bodies led on.
struct VirtualMotion {
    struct Known {
        MemberIndex member;
        Force force;
        PlaceOnDrawing place;
    };
    struct Turning {
        MemberIndex member;
        std::optional<ScalarHandle> omega;     ///< none if it translates
        std::optional<PlaceOnDrawing> centre;  ///< none if it translates
        std::string name;                      ///< of the centre
    };
    std::vector<Turning> members;  ///< those that move
    std::vector<Known> known;      ///< reactions that were known by then
    int bond = -1;
    Symbol sought;
    std::optional<DirectionHandle> along;  ///< of the force sought; none for a couple
    std::optional<Force> force;            ///< the result; none if it vanishes
    std::optional<ScalarHandle> couple;
    StatementIndex statement = none;
};

/// An intermediate sum: not a load, but its line and magnitude are used in the construction.
struct Sum {
    Group group;  ///< on which the terms act
    Symbol symbol;
    Force force;
    PlaceOnDrawing place;
    std::vector<int> bonds;  ///< whose forces are terms; all loads are terms too
    StatementIndex statement = none;
};
/// The arm of a couple of two forces, about a place on the line of one of them.
struct Arm {
    MemberIndex member;
    PlaceOnDrawing about;
    Force force;  ///< the other force
    PlaceOnDrawing place;
    StatementIndex statement = none;
    bool is_shift = false;  ///< the offset of a force that includes a couple
};
/// Members that were balanced as one.
struct TakenTogether {
    Group group;
    std::vector<int> sought;  ///< unknown bonds
    StatementIndex statement = none;
};
/// Pole, rays and strings of a funicular polygon.
struct Funicular {
    Group group;
    Symbol first, second;
    std::vector<Symbol> known;
    std::vector<PointOn<Plane::force>> corners;
    PointOn<Plane::force> pole, dividing;
    std::vector<PlaceOnDrawing> vertices;
    std::optional<PlaceOnDrawing> resultant;
    StatementIndex statement = none;
};

struct PartRun;
struct Run {
    std::vector<Reaction> reactions;  ///< by bond
    std::vector<Resolved> order;
    std::vector<VirtualMotion> virtual_motions;
    std::vector<Sum> sums;
    std::vector<Arm> arms;
    std::vector<TakenTogether> taken_together;
    std::vector<Funicular> funiculars;
    std::vector<PartRun> parts;    ///< the terms, if this run is a sum; else empty
    StatementIndex summed = none;  ///< the sentence that adds them
    Group redundant;  ///< members with reactions that equilibrium leaves open, though there is an equilibrium
    bool complete = false;
    bool in_parts = false;  ///< a sum of separately found parts
};

/// The loads of one member alone.
struct PartRun {
    MemberIndex loaded;
    std::vector<Load> loads;
    Run run;
    StatementIndex first = none, end = none;  ///< range of its sentences
};
/// Symbol of an effect of one member's loads: F_12^(3).
Symbol marked(Symbol symbol, const std::string& mark);

/// Whether a member is in a group.
bool in(const Group& group, MemberIndex member);

}  // namespace kinegraph::statics
