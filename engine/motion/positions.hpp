// Positions: the drawn pose moved along its drivers. All joints are closed by Newton's method in doubles, from one
// position to the next on the same branch; storage is allocated once. Its only velocity is dq/ds, for prediction.
#pragma once

#include <optional>
#include <vector>

#include "engine/motion/branch_walk.hpp"
#include "engine/motion/closure.hpp"
#include "engine/motion/place_rules.hpp"
#include "engine/motion/start_of_walk.hpp"

namespace kinegraph {

/// The moving drivers (by index): one, whose coordinate is the course's, and others in proportion to it.
struct Course {
    struct Along {
        int driver = 0;
        Exact per;  ///< its coordinate divided by that of the first, in rad and m
    };
    int driver = 0;
    std::vector<Along> along = {};
    std::optional<std::size_t> branch =
        std::nullopt;  ///< where the drawn position is a change point: which of the branches that leave it
};

/// Where a body is, against where it is drawn, in m: turned by the angle of (cos, sin), then shifted.
struct RigidMotion {
    VectorOf<double> facing{1, 0}, shift{};
    VectorOf<double> operator()(const VectorOf<double>& drawn) const { return faced(facing, drawn) + shift; }
};

class Positions {
public:
    /// The coordinate of a driver, zero as drawn, is its rotation (rad) or slide (m). Drivers outside the course rest
    /// as drawn, and so do bodies that the drivers leave undetermined. From a change point the motion follows the
    /// requested branch, by default the one on which the bodies move least. Errors: those of closure_of and
    /// carriers_of; a drawn pose from which the driver has no unique motion (a dead point, a locked position, a change
    /// point without branches or without the requested one).
    static Result<Positions> of(const Mechanism& mechanism, const Pose& pose, const Course& course);
    static Result<Positions> of(const Mechanism& mechanism, const Pose& pose, int driver) {
        return of(mechanism, pose, Course{driver});
    }

    /// Moves along the branch by continuity. False: out of reach; `limit` gives where the driver stops, and the
    /// position is unchanged.
    bool move_to(double coordinate) { return walk_.move_to(coordinate); }
    /// Whether the way there has so few steps that it can be walked: some most_turns, or most_sizes of the drawing.
    bool is_near(double coordinate) const;
    static constexpr int most_turns = 1000, most_sizes = 4500;
    double coordinate() const { return walk_.here().s; }
    /// Where the driver was last found to stop, within 1e-9 rad (or 1e-9 of the drawing's size).
    std::optional<double> limit() const { return walk_.limit(); }
    /// Whether it stops there because a place goes to infinity, as on guides that become parallel.
    bool is_limit_far() const { return walk_.is_limit_far(); }
    /// Whether the driver does not determine the velocities here: a dead point or a change point, or too near to one
    /// for doubles.
    bool is_singular() const { return walk_.is_singular(); }
    /// Coordinates of the change points passed, in order: the branch is ambiguous there and is continued smoothly.
    const std::vector<double>& change_points() const { return walk_.change_points(); }

    using BranchTaken = closing::BranchTaken;
    const std::optional<BranchTaken>& branch() const { return branch_; }

    VectorOf<double> origin() const { return closing::rough(origin_); }  ///< of Places, m
    double size() const { return unit_; }                                ///< of the drawing, m, within a factor of two
    double turn(BodyIndex body) const {
        return now(body).turn;
    }  ///< rad, since the drawn pose; continues past a full turn
    RigidMotion motion(BodyIndex body) const;
    /// The position in which the driver stops, to be read and not moved: extrapolated from two beside it. `inward`: the
    /// way to the other end of the travel. None if the limit cannot be approached.
    std::optional<Positions> at_limit(double limit, double inward) const;
    void read(Places& places) const { rules_.read(numeric().places(), places); }
    /// A place (m, from the origin of Places) in the body's own frame: where it would be, had the body stayed as drawn.
    VectorOf<double> seen_from(BodyIndex body, const VectorOf<double>& place) const;
    /// Displacement along X of body i of a straight slide relative to j, since the drawn pose, m.
    double slid(JointIndex joint) const { return rules_.slid(numeric().places(), joint); }

    /// The positions of the bodies in exact numbers: closed within 2^-bits, with the driver exactly at `coordinate`,
    /// which is that of this position. `closure` is of the drawn pose, with as many bits. None where sizes are so far
    /// apart that doubles lead no nearer.
    std::optional<std::vector<BodyPlaceOf<Exact>>> refined(const Closure& closure, const Exact& coordinate);
    /// The same on a change point, or too near to one for refined(): interpolated from positions on both sides, since
    /// the branch goes on smoothly. None where the driver stops beside it.
    std::optional<std::vector<BodyPlaceOf<Exact>>> refined_across(const Closure& closure,
                                                                  const Exact& coordinate) const;

    /// Bits of the numbers of all passes of refinement so far: sizes far apart take many passes.
    std::size_t refined_bits() const { return refined_bits_; }

    /// How a place and the directions of a joint follow from the positions of the bodies, for code that solves the
    /// closure elsewhere.
    using PointRule = closing::PointRule;
    using JointRule = closing::JointRule;

    /// The equations and rules in doubles, places in `size()`.
    const std::vector<ClosureRowOf<double>>& rows() const { return numeric().rows(); }
    /// Their references from the origin of the file.
    std::vector<Closure::Body> bodies() const;
    const std::vector<PointRule>& point_rules() const { return rules_.points(); }
    const std::vector<JointRule>& joint_rules() const { return rules_.joints(); }
    /// By driver: its coordinate in the rows divided by the course's.
    const std::vector<double>& shares() const { return numeric().shares(); }
    const std::vector<bool>& frozen() const { return numeric().frozen(); }  ///< by column: undetermined, and at rest
    const std::vector<double>& state() const { return walk_.here().q; }     ///< by column, here

private:
    Positions() = default;
    const closing::NumericClosure& numeric() const { return walk_.closure(); }
    const BodyPlaceOf<double>& now(BodyIndex body) const { return numeric().places()[at_index(body)]; }
    /// The unknowns by column, refined.
    std::optional<std::vector<Exact>> refined_state(const Closure& closure, const Exact& coordinate);

    double unit_ = 1;            ///< of the closure, m
    Vector origin_;              ///< likewise
    std::vector<Exact> shares_;  ///< by driver: its coordinate divided by the course's, in rad and m
    closing::PlaceRules rules_;
    closing::BranchWalk walk_;
    std::optional<BranchTaken> branch_;
    std::size_t refined_bits_ = 0;
};

}  // namespace kinegraph
