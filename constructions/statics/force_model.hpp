// The model of the forces: the interactions of bodies (bonds), their loads
// (constructions/statics/forces/loads_of_members), and the reduction of forces to a resultant. Defines the unknowns,
// not the method of solution.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "constructions/kinematics/motion.hpp"
#include "constructions/kinematics/structure.hpp"
#include "constructions/statics/force_nouns.hpp"
#include "constructions/statics/forces/loads_of_members.hpp"
#include "engine/board/board.hpp"
#include "engine/solution/findings.hpp"

namespace kinegraph::statics {

class ForceModel {
public:
    ForceModel(Structure& structure, Board& board, const Motion& motion);

    /// Why the loads could not be read (an inertia force without an acceleration, a spring without length).
    const std::vector<Unsolved>& missing() const { return loads_.missing; }
    /// All except the frame.
    Indices<MemberIndex> moving_members() const { return indices(at(members_), member_of(frame).next()); }
    const std::vector<Bond>& bonds() const { return bonds_; }
    /// Indices of a member's bonds.
    const std::vector<int>& bonds_of(MemberIndex member) const { return bonds_of_[at(member)]; }
    const std::vector<Load>& loads() const { return loads_.loads; }
    /// Inertia forces offset so that they include their couples, and their arms.
    const std::vector<Sum>& moved() const { return loads_.moved; }
    const std::vector<Arm>& shifts() const { return loads_.shifts; }
    /// The point of a pin member.
    PointIndex pin_point(MemberIndex member) const { return pins_[at(member) - mechanism_.bodies.size()]; }

    std::string member_name(MemberIndex member) const;
    bool is_pin(MemberIndex member) const { return at(member) >= mechanism_.bodies.size(); }
    /// None if it is a pin.
    BodyIndex body_of(MemberIndex member) const { return is_pin(member) ? none : BodyIndex(member.number()); }
    /// What a bond transmits, as it acts on its first or second member.
    Quantity quantity_at(std::size_t bond, bool on_first) const;
    /// F_32: of 3 on 2.
    Symbol force_symbol(MemberIndex of, MemberIndex on) const;
    bool is_of_teeth(std::size_t bond) const;
    /// Whether the reaction found at a one-sided bond would have to pull. Such pairs are assumed to push: teeth and
    /// round profiles into the bodies' own material, a contact in the sense that the file gives.
    bool pulls(std::size_t bond, const Run& run);
    /// Teeth that would pull. (Contacts may pull too, but have no other flank: they lift off.)
    std::vector<JointIndex> pulling_teeth(const Run& run);
    /// Makes these teeth push on their other flank: along the line of action mirrored at the common tangent. All forces
    /// must then be computed again.
    void turn_flanks(const std::vector<JointIndex>& teeth);
    Action action(PlaceOnDrawing place, DirectionHandle direction);
    LineOn<drawing> line_of(const Wrench& wrench);
    /// Moment of a wrench about a place.
    ScalarHandle moment(const Wrench& wrench, PlaceOnDrawing about);
    Wrench with_couple(Wrench wrench, ScalarHandle couple);
    /// The sum of two: through the intersection of their lines; of parallel ones by moments; a couple if equal and
    /// opposite.
    Wrench sum(const Wrench& a, const Wrench& b);
    Wrench wrench_of(const Load& load);
    Wrench wrench_of(const Bond& bond, const Reaction& reaction, MemberIndex member);
    /// Loads and known reactions of a member (or of several taken together), reduced.
    Wrench known_on(const Group& group, const std::vector<Load>& loads, const Run& run);
    /// Whether one of these loads is a spring between two members of the group, which has no effect on the group. Where
    /// the loads of one member act alone, the spring's other end does not act.
    static bool is_inner(const Load& load, const Group& group, const std::vector<Load>& loads);
    /// Sum of the loads and known reactions on a member: components along x and y, and the moment about a place.
    std::array<ScalarHandle, 3> gap(MemberIndex member, const std::vector<Load>& loads, const Run& run,
                                    PlaceOnDrawing about);
    /// Bonds between a group and the rest.
    std::vector<int> outer_bonds(const Group& group) const;

private:
    static std::string relative_name_of_bodies(const std::string& of, const std::string& on);
    void add_joint(JointIndex index);
    void add_effort(int index);
    /// Side of the common tangent on which the material of bodies[0] lies: the sign of 1/x_0 − 1/x_1, with x the
    /// centres' coordinates along the normal (0 for a rack); 0 if the file gives only a tangent.
    int material_side(JointIndex index);
    /// Both profiles are known and one is a circle: each presses on the other's material.
    static bool is_between_round_profiles(const Joint& joint);

    Board& board_;
    const Mechanism& mechanism_;
    int members_ = 0;
    std::vector<PointIndex> pins_;
    PinMembers pin_of_;
    std::vector<Bond> bonds_;
    std::vector<std::vector<int>> bonds_of_;
    LoadsOfMembers loads_;
    std::set<JointIndex> mirrored_gears_;
};

}  // namespace kinegraph::statics
