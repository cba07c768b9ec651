// Path following: from one position to the next on the same branch. Each step is predicted (a cubic through two
// positions and their dq/ds) and rejected if the prediction was poor; change points are passed, limits found. Storage
// is allocated once.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "engine/motion/numeric_closure.hpp"

namespace kinegraph::closing {

class BranchWalk {
public:
    BranchWalk() = default;
    /// `longest_step`: the largest step, in the course's coordinate, for which the prediction is used.
    BranchWalk(NumericClosure closure, double longest_step)
        : closure_(std::move(closure)), longest_step_(longest_step) {}

    NumericClosure& closure() { return closure_; }
    const NumericClosure& closure() const { return closure_; }
    double longest_step() const { return longest_step_; }

    /// Starts in a closed position, with v, slack and sign set.
    void start_at(const State& position);
    /// Starts in a change point, where v belongs to the branch; the next position is predicted from `ahead`, which lies
    /// on it.
    void start_at_change_point(const State& position, const State& ahead);

    const State& here() const { return here_; }
    /// Moves along the branch by continuity. False: out of reach; `limit` gives where the course stops, and the
    /// position is unchanged.
    bool move_to(double coordinate);
    std::optional<double> limit() const { return limit_; }
    /// Whether the course stops there because a place goes to infinity.
    bool is_limit_far() const { return is_limit_far_; }
    const std::vector<double>& change_points() const { return change_points_; }
    /// Whether the velocities are undetermined here, or too ill-conditioned for doubles.
    bool is_singular() const { return here_.slack < least_slack; }
    /// With a last pivot of this share of the first one, velocities keep nine digits.
    static constexpr double least_slack = 1e-7;
    /// Whether the matrix is safely distinguished from a singular one.
    static bool is_regular(const State& state) { return state.slack >= 100 * least_slack; }

private:
    void predict(double s, std::vector<double>& q) const;
    bool try_step(double s);
    bool pass(State& from, const State& to);
    bool bridge(State& state);
    bool find_limit(double towards);
    std::optional<double> pole(double towards);
    double turning_point(std::size_t column, State low, double slope_low, State high, double slope_high);
    void accept();

    NumericClosure closure_;
    double longest_step_ = 0;
    State here_, before_, next_, regular_, low_, high_, middle_, start_here_, start_before_, start_regular_;
    bool has_before_ = false;
    std::optional<double> limit_;
    bool is_limit_far_ = false;
    std::vector<double> change_points_;
    std::vector<double> sign_changes_;  ///< of the determinant along the branch, as far as pass() has met them
};

}  // namespace kinegraph::closing
