// From one position to the next on the same branch: steps that are looked ahead for (a cubic through two positions and
// their dq/ds) and not believed where that did not foresee them; change points passed, limits found. Storage is made
// once.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "engine/motion/numeric_closure.hpp"

namespace kinegraph::closing {

class BranchWalk {
public:
    BranchWalk() = default;
    /// `longest_step`: of the course's coordinate, what a look ahead can well see.
    BranchWalk(NumericClosure closure, double longest_step)
        : closure_(std::move(closure)), longest_step_(longest_step) {}

    NumericClosure& closure() { return closure_; }
    const NumericClosure& closure() const { return closure_; }
    double longest_step() const { return longest_step_; }

    /// Starts in a position that is closed, with v, slack and sign.
    void start_at(const State& position);
    /// Starts in a change point, where v is of the branch; what comes next is seen from `ahead`, which lies on it.
    void start_at_change_point(const State& position, const State& ahead);

    const State& here() const { return here_; }
    /// On the branch that continuity gives. False: out of reach; `limit` says where the course stops, and nothing
    /// moved.
    bool move_to(double coordinate);
    std::optional<double> limit() const { return limit_; }
    const std::vector<double>& change_points() const { return change_points_; }
    /// The drivers do not determine the velocities here, or hardly for doubles.
    bool is_singular() const { return here_.slack < least_slack; }
    /// With a last pivot of this share of the first one, nine digits are left to the velocities.
    static constexpr double least_slack = 1e-7;
    /// The matrix is well told from a singular one.
    static bool is_regular(const State& state) { return state.slack >= 100 * least_slack; }

private:
    void predict(double s, std::vector<double>& q) const;
    bool try_step(double s);
    bool pass(State& from, const State& to);
    bool bridge(State& state);
    bool find_limit(double towards);
    void accept();

    NumericClosure closure_;
    double longest_step_ = 0;
    State here_, before_, next_, regular_, low_, high_, middle_, start_here_, start_before_, start_regular_;
    bool has_before_ = false;
    std::optional<double> limit_;
    std::vector<double> change_points_;
};

}  // namespace kinegraph::closing
