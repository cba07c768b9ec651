// Positions: the drawn pose moved along its drivers. All joints are closed by Newton's method in doubles, from one position to
// the next on the same branch, with the storage made once. Knows no velocity but dq/ds, by which it looks ahead.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/branches.hpp"
#include "engine/closure.hpp"
#include "engine/elimination.hpp"

namespace kinegraph {

/// What a program's givens need of a position, in doubles and m.
struct Places {
    using Spot = VectorOf<double>;
    std::vector<Spot> points;                     ///< by PointIndex
    std::vector<Spot> guides, normals, tangents;  ///< by JointIndex, as in Pose
};

/// Which drivers (by index) move: one, whose coordinate says where the mechanism is, and others in proportion to it.
struct Course {
    struct Along {
        int driver = 0;
        Exact per;  ///< its coordinate over that of the first, in rad and m
    };
    int driver = 0;
    std::vector<Along> along = {};
    std::optional<std::size_t> branch = std::nullopt;  ///< where a change point is drawn: which of the branches that leave it
};

class Positions {
public:
    /// The coordinate of a driver, zero as drawn, is its turn (rad) or slide (m). Drivers that are not of the course rest as
    /// drawn, and so do bodies that the drivers leave undetermined. From a change point that is drawn it goes along the branch
    /// asked for, else along the one on which the bodies move least. Errors: those of closure_of and carriers_of; a drawn pose
    /// from which the driver does not lead in one way only (a dead point, a lock, a change point without branches or without the
    /// one asked for).
    static Result<Positions> of(const Mechanism& mechanism, const Pose& pose, const Course& course);
    static Result<Positions> of(const Mechanism& mechanism, const Pose& pose, int driver) {
        return of(mechanism, pose, Course{driver});
    }

    /// Moves on the branch that continuity gives. False: out of reach; `limit` says where the driver stops, and nothing moved.
    bool move_to(double coordinate);
    double coordinate() const { return here_.s; }
    /// Where the driver was last found to stop, within 1e-9 rad (or of the drawing's size).
    std::optional<double> limit() const { return limit_; }
    /// The driver does not determine the velocities here: a dead point or a change point, or too near to one for doubles.
    bool is_singular() const { return here_.slack < least_slack; }
    /// Coordinates of the change points passed, in the order met: the branch is a choice there, and goes on smoothly.
    const std::vector<double>& change_points() const { return change_points_; }

    /// Where a change point is drawn: the branch that was taken, by its index in the results, and how many there are.
    struct BranchTaken {
        std::size_t index = 0, of = 0;
    };
    const std::optional<BranchTaken>& branch() const { return branch_; }

    double size() const { return unit_; }                         ///< of the drawing, m, within a factor of two
    double turn(BodyIndex body) const { return now(body).turn; }  ///< rad, since the drawn pose; goes on past a full turn
    void read(Places& places) const;
    /// A place (m) as a body sees it: where it would be, had the body stayed as drawn.
    VectorOf<double> seen_from(BodyIndex body, const VectorOf<double>& place) const;
    /// How far i of a straight slide has gone along X, seen from j, since the drawn pose, m.
    double slid(JointIndex joint) const;

    /// The places of the bodies in exact numbers: closed within 2^-bits, the driver at `coordinate` exactly, which is that of
    /// this position. `closure` is of the drawn pose, with as many bits.
    std::vector<BodyPlaceOf<Exact>> refined(const Closure& closure, const Exact& coordinate);

    /// How a place and the directions of a joint follow from the places of the bodies: for those who close the joints elsewhere.
    struct PointRule {
        Carrier carrier;
        VectorOf<double> local;  ///< from the carrier's reference
    };
    struct JointRule {
        BodyIndex turns_with;  ///< the body of the guide or of the straight profile; none: there is none
        std::array<BodyIndex, 2> bodies;
        VectorOf<double> guide, tangent, normal;  ///< as drawn
        std::array<VectorOf<double>, 2> locals;   ///< guide: P on both; arc: P and C; profiles: their centres
        std::array<double, 2> reaches{};          ///< profiles: of the centres along the drawn normal
        std::array<bool, 2> is_straight{};
        int first_circle = -1;  ///< profiles: the side whose centre gives the normal where none is straight
        PointIndex point;
        bool is_arc = false, touches = false, meshes = false;
        VectorOf<double> pressure{1, 0};
    };

    /// The equations and rules in doubles, places in `size()`.
    const std::vector<ClosureRowOf<double>>& rows() const { return rows_; }
    const std::vector<Closure::Body>& bodies() const { return bodies_; }
    const std::vector<PointRule>& point_rules() const { return points_; }
    const std::vector<JointRule>& joint_rules() const { return joints_; }
    const std::vector<double>& shares() const { return shares_; }  ///< by driver: its coordinate in the rows over the course's
    const std::vector<bool>& frozen() const { return frozen_; }    ///< by column: undetermined, and at rest
    const std::vector<double>& state() const { return here_.q; }   ///< by column, here

private:
    using Spot = VectorOf<double>;
    using Row = ClosureRowOf<double>;
    static constexpr double least_slack = 1e-7;

    /// q: the closure's columns; v = dq/ds; slack: the last pivot over the first; sign: of the leading rows' determinant.
    struct State {
        double s = 0;
        std::vector<double> q, v;
        double slack = 1;
        int sign = 0;
    };
    Positions() = default;
    void prepare(const Closure& closure, const Mechanism& mechanism);
    void prepare_places(const Mechanism& mechanism, const Pose& pose);
    void prepare_course(const Mechanism& mechanism);
    std::optional<Error> choose_leading_rows(const Mechanism& mechanism);
    bool leave_change_point(const Mechanism& mechanism, const Pose& pose);
    std::optional<std::vector<double>> tangent_of(const Branch& branch);
    bool start_along(const std::vector<double>& tangent);

    const BodyPlaceOf<double>& now(BodyIndex body) const { return places_[at_index(body)]; }
    Spot world(BodyIndex body, const Spot& local) const { return now(body).at + faced(now(body).facing, local); }
    Spot contact_point(const JointRule& joint) const;
    void set_places(const std::vector<double>& q);
    void write_excesses(double s);
    void write_jacobian();
    void write(const Row& row, double* into) const;
    void put(double* into, BodyIndex body, const Spot& direction, double turning) const;
    bool close(State& state);
    void look_along(State& state);
    int sign_of_leading_rows();
    void predict(double s, std::vector<double>& q) const;
    bool try_step(double s);
    bool pass(State& from, const State& to);
    bool bridge(State& state);
    bool close_at(std::size_t column, State& state, double& slope);
    bool find_limit(double towards);
    void accept();

    std::vector<Row> rows_;
    std::vector<Closure::Body> bodies_;
    std::vector<BodyPlaceOf<double>> places_;
    std::vector<bool> frozen_;          ///< by column: undetermined, and at rest
    std::vector<std::size_t> leading_;  ///< as many rows as there are columns that move, independent as drawn
    Course course_;
    double unit_ = 1;                  ///< of the closure, m
    std::vector<double> shares_;       ///< by driver: its coordinate, in the closure's numbers, over the course's
    std::vector<Exact> exact_shares_;  ///< the same in rad and m
    double longest_step_ = 0;
    Elimination jacobian_, square_;
    std::vector<double> right_, delta_;
    State here_, before_, next_, regular_, low_, high_, middle_, start_here_, start_before_, start_regular_;
    bool has_before_ = false;
    std::optional<double> limit_;
    std::vector<double> change_points_;
    std::optional<BranchTaken> branch_;
    std::vector<PointRule> points_;
    std::vector<JointRule> joints_;
};

}  // namespace kinegraph
