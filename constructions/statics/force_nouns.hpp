// The nouns of the forces: bodies and pins as members, what bodies may exert on each other (bonds), what is known of
// that in one run, loads, wrenches, and what was done on the way. Values alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/board/board.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph::statics {

constexpr Plane drawing = Plane::drawing;
inline std::size_t at(auto index) { return at_index(index); }

/// A body of the mechanism, or one of those that come after them: the pins of multiple hinges.
using MemberIndex = ListIndex<struct Member>;
using Group = std::vector<MemberIndex>;
constexpr MemberIndex member_of(BodyIndex body) { return MemberIndex(body.number()); }

using PlaceOnDrawing = PointOn<Plane::drawing>;
using Force = VectorOn<Plane::force>;

/// A line of action as the board has it: a place on it and its direction.
struct Action {
    PlaceOnDrawing place;
    DirectionHandle direction;
    LineOn<drawing> line;
};

/// What two bodies may exert on each other.
struct Bond {
    enum class Kind { pin, guide, line, couple, clamp } kind = Kind::pin;
    MemberIndex first, second;  ///< the force counts on `first`
    JointIndex joint = none;
    int effort = -1;
    PlaceOnDrawing place;
    DirectionHandle direction;  ///< line: along it; guide: normal to it
    int part_of = -1;           ///< ≥ 0: a component, along x or y, of the force of this bond (a hinge)
    Symbol symbol;              ///< of the force on `first`
    Symbol reverse;             ///< of the force on `second`
};

inline bool is_on_frame(const Bond& bond) { return bond.first == member_of(frame) || bond.second == member_of(frame); }

/// What is known of a bond in one run.
struct Reaction {
    bool known = false;
    std::optional<Force> force;             ///< on the bond's first member; nothing: vanishes
    std::optional<ScalarHandle> couple;     ///< about the bond's place; nothing: vanishes
    std::optional<Action> action;           ///< its line, before or after the magnitude is known
    bool only_couple = false;               ///< a guide whose force was shown to vanish
    bool deduced = false;                   ///< the line was found, not given
    StatementIndex line_statement = none;   ///< the first that says or needs its line
    StatementIndex force_statement = none;  ///< by which it is known
    /// Of what is not known, what every equilibrium has alike: all of the force, its component along one direction, the
    /// couple.
    enum class Alike { nothing, component, force } alike = Alike::nothing;
    bool couple_alike = false;
    std::optional<DirectionHandle> along;  ///< of the component; `force` holds it
    std::string axis, across;              ///< superscripts of the component, and of the one that stays open
};

/// All that acts on a body, reduced: nothing, a couple, or a force along a line.
struct Wrench {
    std::optional<Force> force;
    PlaceOnDrawing place;
    std::optional<ScalarHandle> couple;  ///< only where there is no force

    bool vanishes() const { return !force && !couple; }
};

/// A load on one member.
struct Load {
    MemberIndex member;
    Symbol symbol;
    AppliedForce::Kind kind = AppliedForce::Kind::load;
    std::optional<Force> force;
    PlaceOnDrawing place;
    std::optional<ScalarHandle> couple;
    int given = -1;  ///< as AppliedForce::given
};

/// What was done at one member, for its free-body diagram.
struct Resolved {
    MemberIndex member;
};

/// The motion by which a force was found that every equilibrium has alike.
struct Released {
    struct Turning {
        MemberIndex member;
        std::optional<ScalarHandle> omega;     ///< nothing: it translates
        std::optional<PlaceOnDrawing> centre;  ///< nothing: it translates
        std::string name;                      ///< of the centre
    };
    std::vector<Turning> members;  ///< that move
    int bond = -1;
    Symbol sought;
    std::optional<DirectionHandle> along;  ///< of a force that is sought; nothing: of a couple
    std::optional<Force> force;            ///< found; nothing: it vanishes
    std::optional<ScalarHandle> couple;
    StatementIndex statement = none;
};

/// What was added up on the way: it acts on nothing, but its line and its size lead on.
struct Added {
    Group group;  ///< on which what is added acts
    Symbol symbol;
    Force force;
    PlaceOnDrawing place;
    std::vector<int> bonds;  ///< whose forces are among what is added, with all loads
    StatementIndex statement = none;
};
/// The arm of a couple of two forces, about a place on the line of the one.
struct Lever {
    MemberIndex member;
    PlaceOnDrawing about;
    Force force;  ///< the other
    PlaceOnDrawing place;
    StatementIndex statement = none;
    bool is_shift = false;  ///< by which a force with a couple is moved aside
};
/// Members that were balanced as one.
struct Balanced {
    Group group;
    std::vector<int> sought;  ///< bonds
    StatementIndex statement = none;
};
/// Pole, rays and strings of a funicular polygon.
struct Strings {
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
    std::vector<Released> released;
    std::vector<Added> added;
    std::vector<Lever> levers;
    std::vector<Balanced> balanced;
    std::vector<Strings> strings;
    std::vector<PartRun> parts;    ///< whose sum it is; empty: it is none
    StatementIndex summed = none;  ///< by which they are added
    Group redundant;  ///< members of which equilibrium leaves something open, though there is an equilibrium
    bool complete = false;
    std::size_t beyond_members =
        0;                  ///< > 0: so many members at most are taken together, and redundant constraints hold more
    bool in_parts = false;  ///< a sum of parts found apart, or of trials
};

/// The loads of one member alone.
struct PartRun {
    MemberIndex loaded;
    std::vector<Load> loads;
    Run run;
    StatementIndex first = none, end = none;  ///< its sentences
};
/// Of what the loads of one member cause: F_12^(3).
Symbol marked(Symbol symbol, const std::string& mark);

/// True where a member belongs to a group of them.
bool in(const Group& group, MemberIndex member);

}  // namespace kinegraph::statics
