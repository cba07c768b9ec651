// The model of the forces: what bodies may exert on each other (bonds), what loads them, and the reduction of forces to a
// resultant. It says what is unknown, not how it is found.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "constructions/motion.hpp"
#include "constructions/structure.hpp"
#include "engine/board.hpp"
#include "engine/solution.hpp"

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
    /// Of what is not known, what every equilibrium has alike: all of the force, its component along one direction, the couple.
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
    Group redundant;               ///< members of which equilibrium leaves something open, though there is an equilibrium
    bool complete = false;
    std::size_t beyond_members = 0;  ///< > 0: so many members at most are taken together, and redundant constraints hold more
    bool in_parts = false;           ///< a sum of parts found apart, or of trials
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

class ForceModel {
public:
    ForceModel(Structure& structure, Board& board, const Motion& motion);

    /// Why the loads could not be read (an inertia force without an acceleration, a spring without length).
    const std::vector<Unsolved>& missing() const { return missing_; }
    /// All but the frame.
    Indices<MemberIndex> moving_members() const { return indices(at(members_), member_of(frame).next()); }
    const std::vector<Bond>& bonds() const { return bonds_; }
    /// Indices of a member's bonds.
    const std::vector<int>& bonds_of(MemberIndex member) const { return bonds_of_[at(member)]; }
    /// How many bonds joints and efforts make; the components of hinges come after them.
    std::size_t joint_bonds() const { return joint_bonds_; }
    const std::vector<Load>& loads() const { return loads_; }
    /// Inertia forces moved aside so that they carry their couples, and by what.
    const std::vector<Added>& moved() const { return moved_; }
    const std::vector<Lever>& shifts() const { return shifts_; }
    /// The point of a pin member.
    PointIndex pin_point(MemberIndex member) const { return pins_[at(member) - mechanism_.bodies.size()]; }

    /// Adds the components, along x and y, of a hinge's force, for a trial.
    void add_components(int hinge);
    void drop_components();

    std::string member_name(MemberIndex member) const;
    bool is_pin(MemberIndex member) const { return at(member) >= mechanism_.bodies.size(); }
    /// None: it is a pin.
    BodyIndex body_of(MemberIndex member) const { return is_pin(member) ? none : BodyIndex(member.number()); }
    /// What a bond transmits, as it acts on its first member or on the other.
    Quantity quantity_at(std::size_t bond, bool on_first) const;
    /// F_32: of 3 on 2.
    Symbol force_symbol(MemberIndex of, MemberIndex on) const;
    /// One-sided pairs are assumed to push: teeth into the gear's own material, a contact in the sense that the file gives.
    /// Whether the reaction found at a bond says that it would have to pull.
    bool pulls(std::size_t bond, const Run& run);
    /// Teeth that would pull. (Contacts may pull, too, but have no other flank: they lift off.)
    std::vector<JointIndex> pulling_teeth(const Run& run);
    /// They push on their other flank from then on: along the line of action mirrored at the common tangent. All is to be found
    /// anew.
    void turn_flanks(const std::vector<JointIndex>& teeth);
    Action action(PlaceOnDrawing place, DirectionHandle direction);
    LineOn<drawing> line_of(const Wrench& wrench);
    /// Moment of a wrench about a place.
    ScalarHandle moment(const Wrench& wrench, PlaceOnDrawing about);
    Wrench with_couple(Wrench wrench, ScalarHandle couple);
    /// The sum of two: through the meet of their lines; of parallel ones by moments; a couple where equal and opposite.
    Wrench sum(const Wrench& a, const Wrench& b);
    Wrench wrench_of(const Load& load);
    Wrench wrench_of(const Bond& bond, const Reaction& reaction, MemberIndex member);
    /// Loads and known reactions of a member (or of several taken together), reduced.
    Wrench known_on(const Group& group, const std::vector<Load>& loads, const Run& run);
    /// A spring between two members of a group, which the group does not feel.
    bool is_inner(const Load& load, const Group& group) const;
    /// What the loads and the known reactions leave on a member: components along x and y, and the moment about a place.
    std::array<ScalarHandle, 3> gap(MemberIndex member, const std::vector<Load>& loads, const Run& run, PlaceOnDrawing about);
    /// Members that hang together, and neither on the frame nor on an effort.
    std::vector<Group> floating() const;
    /// Structures of more than one body that hang on the frame and on no effort; not a single body held by bars: cut free with
    /// them or without, the same lines act on it.
    std::vector<Group> hung_on_frame() const;
    /// Bodies that no other body and no effort holds, but the frame: each with the pins on it.
    std::vector<Group> single_on_frame() const;
    /// Bonds between a group and the rest.
    std::vector<int> outer_bonds(const Group& group) const;

private:
    /// Members that hang together, not on an effort, and on the frame or not.
    std::vector<Group> hanging_together(bool on_frame) const;
    static std::string relative_name_of_bodies(const std::string& of, const std::string& on);
    bool is_of_teeth(std::size_t bond) const;
    void add_joint(JointIndex index);
    void add_effort(int index);
    /// On which side of the common tangent's normal the material of bodies[0] lies: the sign of 1/x_0 − 1/x_1, x the centres'
    /// places along it (0 for a rack); 0 where the file gives only a tangent.
    int material_side(JointIndex index);
    /// With the sentence that finds it, where it does not vanish.
    void add_said(const Load& load, Message message);
    StatementIndex say_of_load(const Load& load, Message message, const char* source = "");
    void move_inertia(const Load& force, const Load& couple);
    void add_load(Load load);
    static bool is_on_frame(const Bond& bond) { return bond.first == member_of(frame) || bond.second == member_of(frame); }
    /// One body, and bars that hold it on the frame.
    bool is_body_on_bars(const Group& group) const;
    void read_loads();
    void add_spring(int index, const SpringLoad& spring);
    /// At the centroid of its diagram; a couple where its halves cancel.
    void add_distributed(int index, const DistributedLoad& load);
    void add_torsion(int index, const TorsionLoad& torsion);
    std::string mass_name(const Mass& mass, const char* letter) const;
    void add_weight(int index);
    /// d'Alembert: −m a_G at the mass centre and −J_G α.
    void add_inertia(int index);

    Structure& structure_;
    Board& board_;
    const Mechanism& mechanism_;
    const Motion& motion_;
    int members_ = 0;
    std::vector<PointIndex> pins_;
    std::map<JointIndex, int> pin_of_;  ///< the member that is the pin of a hinge with one of its own
    std::vector<Bond> bonds_;
    std::size_t joint_bonds_ = 0;
    std::vector<std::vector<int>> bonds_of_;
    std::vector<Load> loads_;
    std::vector<Added> moved_;
    std::vector<Lever> shifts_;
    std::set<JointIndex> mirrored_gears_;
    std::vector<Unsolved> missing_;
};

}  // namespace kinegraph::statics
