// The model of the forces: what bodies may exert on each other (bonds), what loads them, and the reduction of forces to a
// resultant. It says what is unknown, not how it is found.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "constructions/motion.hpp"
#include "constructions/structure.hpp"
#include "engine/board.hpp"
#include "engine/solution.hpp"

namespace kinegraph::statics {

constexpr BodyIndex frame = 0;
constexpr Plane drawing = Plane::drawing;
inline std::size_t at(int index) { return static_cast<std::size_t>(index); }

using PlaceOnDrawing = PointOn<Plane::drawing>;
using Force = VectorOn<Plane::force>;

/// A line of action as the board has it: a place on it and its direction.
struct Action {
    PlaceOnDrawing place;
    DirectionHandle direction;
    LineOn<drawing> line;
};

/// What two bodies may exert on each other. Members: bodies of the mechanism, then the pins of multiple hinges.
struct Bond {
    enum class Kind { pin, guide, line, couple, clamp } kind = Kind::pin;
    int first = -1, second = -1;  ///< members; the force counts on `first`
    JointIndex joint = -1;
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
    std::optional<Force> force;          ///< on the bond's first member; nothing: vanishes
    std::optional<ScalarHandle> couple;  ///< about the bond's place; nothing: vanishes
    std::optional<Action> action;        ///< its line, before or after the magnitude is known
    bool only_couple = false;            ///< a guide whose force was shown to vanish
    bool deduced = false;                ///< the line was found, not given
    int line_statement = -1;             ///< the first that says or needs its line
    int force_statement = -1;            ///< by which it is known
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
    int member = -1;
    Symbol symbol;
    AppliedForce::Kind kind = AppliedForce::Kind::load;
    std::optional<Force> force;
    PlaceOnDrawing place;
    std::optional<ScalarHandle> couple;
    int given = -1;  ///< as AppliedForce::given
};

/// What was done at one member, for its free-body diagram.
struct Resolved {
    int member = -1;
};

struct Run {
    std::vector<Reaction> reactions;  ///< by bond
    std::vector<Resolved> order;
    bool complete = false;
    bool in_parts = false;  ///< a sum of parts found apart, or of trials
};

/// True where a member belongs to a group of them.
bool in(const std::vector<int>& group, int member);

class ForceModel {
public:
    ForceModel(Structure& structure, Board& board, const Motion& motion);

    /// Why the loads could not be read (an inertia force without an acceleration, a spring without length).
    const std::vector<Unsolved>& missing() const { return missing_; }
    /// Bodies of the mechanism, then the pins of multiple hinges.
    int members() const { return members_; }
    const std::vector<Bond>& bonds() const { return bonds_; }
    /// Indices of a member's bonds.
    const std::vector<int>& bonds_of(int member) const { return bonds_of_[at(member)]; }
    /// How many bonds joints and efforts make; the components of hinges come after them.
    std::size_t joint_bonds() const { return joint_bonds_; }
    const std::vector<Load>& loads() const { return loads_; }
    /// The point of a pin member.
    PointIndex pin_point(int member) const { return pins_[at(member - static_cast<int>(mechanism_.bodies.size()))]; }

    /// Adds the components, along x and y, of a hinge's force, for a trial.
    void add_components(int hinge);
    void drop_components();

    std::string member_name(int member) const;
    bool is_pin(int member) const;
    /// F_32: of 3 on 2.
    Symbol force_symbol(int of, int on) const;
    /// One-sided pairs are assumed to push: teeth into the gear's own material, a contact in the sense that the file gives.
    /// Whether the reaction found at a bond says that it would have to pull.
    bool pulls(std::size_t bond, const Run& run);
    /// Teeth that would pull push on their other flank: along the line of action mirrored at the common tangent. True where a
    /// line was changed, and all is to be found anew. (Contacts have no other flank: they lift off.)
    bool turn_teeth(const Run& run);
    Action action(PlaceOnDrawing place, DirectionHandle direction);
    LineOn<drawing> line_of(const Wrench& wrench);
    /// Moment of a wrench about a place.
    ScalarHandle moment(const Wrench& wrench, PlaceOnDrawing about);
    Wrench with_couple(Wrench wrench, ScalarHandle couple);
    /// The sum of two: through the meet of their lines; of parallel ones by moments; a couple where equal and opposite.
    Wrench sum(const Wrench& a, const Wrench& b);
    Wrench wrench_of(const Load& load);
    Wrench wrench_of(const Bond& bond, const Reaction& reaction, int member);
    /// Loads and known reactions of a member (or of several taken together), reduced.
    Wrench known_on(const std::vector<int>& group, const std::vector<Load>& loads, const Run& run);
    /// Bonds between a group and the rest.
    std::vector<int> outer_bonds(const std::vector<int>& group) const;

private:
    static std::string relative_name_of_bodies(const std::string& of, const std::string& on);
    void add_joint(JointIndex index);
    void add_effort(int index);
    /// On which side of the common tangent's normal the material of bodies[0] lies: the sign of 1/x_0 − 1/x_1, x the centres'
    /// places along it (0 for a rack); 0 where the file gives only a tangent.
    int material_side(JointIndex index);
    void add_load(Load load);
    void read_loads();
    void add_spring(int index, const SpringLoad& spring);
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
    std::vector<Bond> bonds_;
    std::size_t joint_bonds_ = 0;
    std::vector<std::vector<int>> bonds_of_;
    std::vector<Load> loads_;
    std::set<JointIndex> mirrored_gears_;
    std::vector<Unsolved> missing_;
};

}  // namespace kinegraph::statics
