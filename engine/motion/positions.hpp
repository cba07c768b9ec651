// Positions: the drawn pose moved along its drivers. All joints are closed by Newton's method in doubles
// (engine/closing/), from one position to the next on the same branch, with the storage made once. Knows no velocity
// but dq/ds, by which it looks ahead.
#pragma once

#include <optional>
#include <vector>

#include "engine/motion/branch_walk.hpp"
#include "engine/motion/closure.hpp"
#include "engine/motion/place_rules.hpp"
#include "engine/motion/start_of_walk.hpp"

namespace kinegraph {

/// Which drivers (by index) move: one, whose coordinate says where the mechanism is, and others in proportion to it.
struct Course {
    struct Along {
        int driver = 0;
        Exact per;  ///< its coordinate over that of the first, in rad and m
    };
    int driver = 0;
    std::vector<Along> along = {};
    std::optional<std::size_t> branch =
        std::nullopt;  ///< where a change point is drawn: which of the branches that leave it
};

class Positions {
public:
    /// The coordinate of a driver, zero as drawn, is its turn (rad) or slide (m). Drivers that are not of the course
    /// rest as drawn, and so do bodies that the drivers leave undetermined. From a change point that is drawn it goes
    /// along the branch asked for, else along the one on which the bodies move least. Errors: those of closure_of and
    /// carriers_of; a drawn pose from which the driver does not lead in one way only (a dead point, a lock, a change
    /// point without branches or without the one asked for).
    static Result<Positions> of(const Mechanism& mechanism, const Pose& pose, const Course& course);
    static Result<Positions> of(const Mechanism& mechanism, const Pose& pose, int driver) {
        return of(mechanism, pose, Course{driver});
    }

    /// Moves on the branch that continuity gives. False: out of reach; `limit` says where the driver stops, and nothing
    /// moved.
    bool move_to(double coordinate) { return walk_.move_to(coordinate); }
    double coordinate() const { return walk_.here().s; }
    /// Where the driver was last found to stop, within 1e-9 rad (or of the drawing's size).
    std::optional<double> limit() const { return walk_.limit(); }
    /// The driver does not determine the velocities here: a dead point or a change point, or too near to one for
    /// doubles.
    bool is_singular() const { return walk_.is_singular(); }
    /// Coordinates of the change points passed, in the order met: the branch is a choice there, and goes on smoothly.
    const std::vector<double>& change_points() const { return walk_.change_points(); }

    using BranchTaken = closing::BranchTaken;
    const std::optional<BranchTaken>& branch() const { return branch_; }

    double size() const { return unit_; }  ///< of the drawing, m, within a factor of two
    double turn(BodyIndex body) const {
        return now(body).turn;
    }  ///< rad, since the drawn pose; goes on past a full turn
    void read(Places& places) const { rules_.read(numeric().places(), places); }
    /// A place (m) as a body sees it: where it would be, had the body stayed as drawn.
    VectorOf<double> seen_from(BodyIndex body, const VectorOf<double>& place) const;
    /// How far i of a straight slide has gone along X, seen from j, since the drawn pose, m.
    double slid(JointIndex joint) const { return rules_.slid(numeric().places(), joint); }

    /// The places of the bodies in exact numbers: closed within 2^-bits, the driver at `coordinate` exactly, which is
    /// that of this position. `closure` is of the drawn pose, with as many bits.
    std::vector<BodyPlaceOf<Exact>> refined(const Closure& closure, const Exact& coordinate);

    /// How a place and the directions of a joint follow from the places of the bodies: for those who close the joints
    /// elsewhere.
    using PointRule = closing::PointRule;
    using JointRule = closing::JointRule;

    /// The equations and rules in doubles, places in `size()`.
    const std::vector<ClosureRowOf<double>>& rows() const { return numeric().rows(); }
    const std::vector<Closure::Body>& bodies() const { return numeric().bodies(); }
    const std::vector<PointRule>& point_rules() const { return rules_.points(); }
    const std::vector<JointRule>& joint_rules() const { return rules_.joints(); }
    /// By driver: its coordinate in the rows over the course's.
    const std::vector<double>& shares() const { return numeric().shares(); }
    const std::vector<bool>& frozen() const { return numeric().frozen(); }  ///< by column: undetermined, and at rest
    const std::vector<double>& state() const { return walk_.here().q; }     ///< by column, here

private:
    Positions() = default;
    const closing::NumericClosure& numeric() const { return walk_.closure(); }
    const BodyPlaceOf<double>& now(BodyIndex body) const { return numeric().places()[at_index(body)]; }

    double unit_ = 1;            ///< of the closure, m
    std::vector<Exact> shares_;  ///< by driver: its coordinate over the course's, in rad and m
    closing::PlaceRules rules_;
    closing::BranchWalk walk_;
    std::optional<BranchTaken> branch_;
};

}  // namespace kinegraph
