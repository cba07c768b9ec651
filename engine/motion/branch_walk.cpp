#include "engine/motion/branch_walk.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace kinegraph::closing {
namespace {

/// Cubic Hermite interpolation between two positions.
void between(const std::vector<double>& a, const std::vector<double>& va, const std::vector<double>& b,
             const std::vector<double>& vb, double width, double t, std::vector<double>& q) {
    for (std::size_t k = 0; k < q.size(); ++k) {
        const double rise = b[k] - a[k];
        q[k] = a[k] + t * width * va[k] + t * t * (3 * rise - width * (2 * va[k] + vb[k])) +
               t * t * t * (width * (va[k] + vb[k]) - 2 * rise);
    }
}

/// Indices of the values, the largest |value| first.
std::vector<std::size_t> by_size(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return std::abs(values[a]) > std::abs(values[b]); });
    return order;
}

/// One step of the unknown in a column, by `reach` from a position whose v is over that unknown. False: there is no
/// position near, or it is far from the prediction and may be on another branch.
bool step_by(NumericClosure& closure, std::size_t column, const State& from, double slope_from, double reach, State& to,
             double& slope) {
    to = from;
    for (std::size_t k = 0; k < to.q.size(); ++k) to.q[k] += reach * (k == column ? 1 : from.v[k]);
    to.s += reach * slope_from;
    const std::vector<double> predicted = to.q;
    if (!closure.close_at(column, to, slope)) return false;
    double correction = 0;
    for (std::size_t k = 0; k < to.q.size(); ++k) correction = std::max(correction, std::abs(to.q[k] - predicted[k]));
    constexpr double share = 0.2, noise = 1e-9;
    return correction < share * std::abs(reach) + noise;
}

/// Where the last three values lead to, if their differences shrink as a geometric series.
std::optional<double> limit_of(const std::vector<double>& values) {
    if (values.size() < 3) return std::nullopt;
    const double* last = &values[values.size() - 3];
    const double before = last[1] - last[0], after = last[2] - last[1];
    if (!(after * before > 0 && std::abs(after) < std::abs(before))) return std::nullopt;
    return last[2] + after * after / (before - after);
}

}  // namespace

// --- the start
// ----------------------------------------------------------------------------------------------------------------

void BranchWalk::start_at(const State& position) {
    for (State* state : {&here_, &before_, &next_, &regular_, &low_, &high_, &middle_}) *state = position;
    has_before_ = false;
    sign_changes_.clear();
    closure_.set_places(here_.q);
}

void BranchWalk::start_at_change_point(const State& position, const State& ahead) {
    start_at(position);
    regular_ = ahead;
    change_points_ = {0};
}

// --- steps
// --------------------------------------------------------------------------------------------------------------------

/// Cubic through the last two positions and their dq/ds; a straight line if there is only one.
void BranchWalk::predict(double s, std::vector<double>& q) const {
    const double ahead = s - here_.s, back = here_.s - before_.s;
    const bool cubic = has_before_ && ahead * back > 0 && std::abs(ahead) <= 2 * std::abs(back);
    const double t = cubic ? ahead / back : 0;
    for (std::size_t k = 0; k < q.size(); ++k) {
        q[k] = here_.q[k] + here_.v[k] * ahead;
        if (!cubic) continue;
        // Hermite on [−1, 0], extrapolated to t.
        const double rise = before_.q[k] - here_.q[k] + here_.v[k] * back, bend = (before_.v[k] - here_.v[k]) * back;
        q[k] += t * t * (3 * rise + bend) + t * t * t * (2 * rise + bend);
    }
}

bool BranchWalk::try_step(double s) {
    next_.s = s;
    predict(s, next_.q);
    middle_.q = next_.q;
    if (!closure_.close(next_)) return false;
    closure_.look_along(next_);
    double correction = 0, bend = 0, speed = 1e-9;
    for (std::size_t k = 0; k < next_.q.size(); ++k) {
        correction = std::max(correction, std::abs(next_.q[k] - middle_.q[k]));
        bend = std::max(bend, std::abs(next_.v[k] - here_.v[k]));
        speed = std::max({speed, std::abs(next_.v[k]), std::abs(here_.v[k])});
    }
    if (next_.slack < least_slack) return bridge(next_);
    // Another branch may be near: a step far from its prediction is rejected.
    if (correction > 0.2 * speed * std::abs(s - here_.s) || bend > 0.3 * speed) return false;
    next_.sign = closure_.sign_of_leading_rows();
    return next_.sign == regular_.sign || pass(regular_, next_);
}

void BranchWalk::accept() {
    if (!is_singular()) {
        std::swap(before_, here_);
        has_before_ = true;
    } else {
        has_before_ = false;
    }
    std::swap(here_, next_);
    if (!is_singular()) regular_ = here_;
}

/// The determinant changed its sign between two positions. If it vanishes in between and the path is smooth there, that
/// is a change point, which is recorded. If only the choice of leading rows caused the sign, nothing happens. False:
/// the two positions are not on one branch.
bool BranchWalk::pass(State& from, const State& to) {
    // What was found once between the two is not sought again: a walk goes to and fro over the same positions.
    const auto lies_between = [&](double each) { return (each - from.s) * (each - to.s) < 0; };
    if (std::count_if(sign_changes_.begin(), sign_changes_.end(), lies_between) % 2 == 1) return true;
    low_ = from;
    high_ = to;
    double slack = 1;
    constexpr double near = 1e-10;
    const auto next = next_;  // closure_.close() below changes the places; they are restored at the end
    for (int i = 0; i < 60 && std::abs(high_.s - low_.s) > near * longest_step_; ++i) {
        middle_.s = (low_.s + high_.s) / 2;
        between(low_.q, low_.v, high_.q, high_.v, high_.s - low_.s, 0.5, middle_.q);
        if (!closure_.close(middle_)) return false;
        slack = middle_.slack;
        closure_.look_along(middle_);
        middle_.sign = closure_.sign_of_leading_rows();
        if (middle_.sign == 0) {
            low_ = high_ = middle_;
            break;
        }
        std::swap(middle_.sign == from.sign ? low_ : high_, middle_);
    }
    next_ = next;
    closure_.set_places(next_.q);
    const double found = (low_.s + high_.s) / 2;
    const bool vanishes = slack < 1e-5, is_on_branch = vanishes || !closure_.all_rows_lead();
    if (is_on_branch) sign_changes_.push_back(found);
    if (vanishes) {
        const auto known = [&](double each) { return std::abs(each - found) < 1e-5 * longest_step_; };
        if (std::none_of(change_points_.begin(), change_points_.end(), known)) change_points_.push_back(found);
    }
    return is_on_branch;
}

/// A position with a singular matrix: interpolated from two positions beside it.
bool BranchWalk::bridge(State& state) {
    State ahead = state;
    const double way = state.s > here_.s ? 1 : -1;
    for (double reach = 0.05 * longest_step_; reach < longest_step_; reach *= 3) {
        low_ = here_;
        low_.s = state.s - way * reach;
        ahead.s = state.s + way * reach;
        predict(low_.s, low_.q);
        if (!closure_.close(low_) || !is_regular(low_)) continue;
        closure_.look_along(low_);
        low_.sign = closure_.sign_of_leading_rows();
        predict(ahead.s, ahead.q);
        if (!closure_.close(ahead) || !is_regular(ahead)) continue;
        closure_.look_along(ahead);
        ahead.sign = closure_.sign_of_leading_rows();
        const double width = ahead.s - low_.s;
        double bend = 0, speed = 1e-9;
        for (std::size_t k = 0; k < ahead.q.size(); ++k) {
            bend = std::max(bend, std::abs(ahead.v[k] - low_.v[k]));
            speed = std::max({speed, std::abs(ahead.v[k]), std::abs(low_.v[k])});
        }
        if (bend > 0.5 * speed) return false;
        between(low_.q, low_.v, ahead.q, ahead.v, width, 0.5, state.q);
        for (std::size_t k = 0; k < state.q.size(); ++k)
            state.v[k] = 1.5 / width * (ahead.q[k] - low_.q[k]) - (low_.v[k] + ahead.v[k]) / 4;
        State from = low_;
        if (from.sign != ahead.sign && !pass(from, ahead)) return false;
        // pass() keeps next_, which is `state`; the next position is predicted from the one beyond.
        state.sign = ahead.sign;
        state.slack = 0;
        regular_ = ahead;
        closure_.set_places(state.q);
        return true;
    }
    return false;
}

/// Steps became too small. Parametrised by an unknown that moves fast, the driver's coordinate reaches an extreme and
/// reverses: that is the limit. True: the path reaches `towards` after all; that position is then in next_.
bool BranchWalk::find_limit(double towards) {
    limit_ = here_.s;
    is_limit_far_ = false;
    State high = here_;
    double slope = 0;
    // Whether the path, followed first by this unknown, reaches `towards` or its limit; nothing if it cannot be
    // followed, as by the driver's own unknown.
    const auto follow = [&](std::size_t column) -> std::optional<bool> {
        // The position again, by this unknown: nearly singular by the driver's coordinate, it has lost digits. ds over
        // the unknown, and the other unknowns over it:
        State low = here_;
        double slope_low = 0;
        if (!closure_.close_at(column, low, slope_low)) return std::nullopt;
        double way = (towards > here_.s ? 1 : -1) * (slope_low > 0 ? 1 : -1);
        // Steps begin short: beside a change point the path turns sharply, and another branch is near.
        constexpr double first = 1e-7, shortest = 1e-9, farthest = 0.3, faster = 1.5;
        // Where sizes are so far apart that steps stay short, the path is not followed: a hundred steps mostly do.
        constexpr int most_steps = 10'000;
        double gone = 0, reach = first;
        for (int count = 0; gone + reach <= farthest && count < most_steps; ++count) {
            if (!step_by(closure_, column, low, slope_low, way * reach, high, slope)) {
                reach /= 4;
                if (reach < shortest) return std::nullopt;
                continue;
            }
            gone += reach;
            if (slope * slope_low <= 0) {
                limit_ = turning_point(column, low, slope_low, high, slope);
                return false;
            }
            if ((high.s - towards) * (here_.s - towards) <= 0) {
                next_.s = towards;
                next_.q = high.q;
                if (!closure_.close(next_) || next_.slack < least_slack) return std::nullopt;
                closure_.look_along(next_);
                next_.sign = closure_.sign_of_leading_rows();
                return true;
            }
            low = high;
            slope_low = slope;
            reach *= 2;
            if (const std::size_t k = by_size(low.v).front(); std::abs(low.v[k]) > faster) {
                way *= low.v[k] > 0 ? 1 : -1;
                column = k;
                if (!closure_.close_at(column, low, slope_low)) return std::nullopt;
            }
        }
        return std::nullopt;
    };
    constexpr std::size_t most = 6;
    const std::vector<std::size_t> columns = by_size(here_.v);
    for (std::size_t i = 0; i < std::min(most, columns.size()) && here_.v[columns[i]] != 0; ++i)
        if (const auto reaches = follow(columns[i])) return *reaches;
    const std::optional<double> found = pole(towards);
    is_limit_far_ = found.has_value();
    if (found) limit_ = found;
    return false;
}

/// Where a place goes to infinity, as on two guides that become parallel, the course ends without turning round. By
/// that unknown u it goes on, and s(u) tends to the limit as a power of 1/u. So do places each twice as far as the one
/// before, from three of which Aitken's Δ² gives the limit; from three of these limits it gives a better one.
std::optional<double> BranchWalk::pole(double towards) {
    constexpr double far = 4, farthest = 1e6;  // in the closure's unit
    constexpr int steps = 8;                   // from one of these places to the next
    constexpr double known = 1e-9;             // of two such limits; the better one is known to a seventh of that
    const std::size_t column = by_size(here_.v).front();
    State at = here_, next = here_;
    double slope = 0;
    if (!(std::abs(at.q[column]) > far) || !closure_.close_at(column, at, slope)) return std::nullopt;
    if (slope * at.q[column] * (towards - at.s) <= 0) return std::nullopt;
    std::vector<double> reached{at.s}, limits, better;
    while (std::abs(at.q[column]) < farthest) {
        const double reach = at.q[column] / steps, sense = slope;
        for (int i = 0; i < steps; ++i) {
            if (!step_by(closure_, column, at, slope, reach, next, slope) || slope * sense <= 0) return std::nullopt;
            std::swap(at, next);
        }
        reached.push_back(at.s);
        if (const auto found = limit_of(reached)) limits.push_back(*found);
        if (const auto found = limit_of(limits)) better.push_back(*found);
        if (better.size() > 1 && std::abs(better.back() - better[better.size() - 2]) < known) return better.back();
    }
    return std::nullopt;
}

/// Between two positions of a path, by the unknown in a column, on both sides of the extreme of the driver's
/// coordinate: where its slope over the unknown vanishes, by false position with the end that stays halved (Illinois).
double BranchWalk::turning_point(std::size_t column, State low, double slope_low, State high, double slope_high) {
    double weight_low = slope_low, weight_high = slope_high, slope = 0;
    for (int i = 0; i < 60 && std::abs(high.q[column] - low.q[column]) > 1e-13; ++i) {
        const double share = i % 3 == 2 ? 0.5 : weight_low / (weight_low - weight_high);
        const double reach = share * (high.q[column] - low.q[column]);
        State middle = low;
        for (std::size_t k = 0; k < middle.q.size(); ++k) middle.q[k] += reach * (k == column ? 1 : low.v[k]);
        middle.s += reach * slope_low;
        if (!closure_.close_at(column, middle, slope)) break;
        if (slope == 0) return middle.s;
        if (slope * slope_low > 0) {
            low = std::move(middle);
            slope_low = weight_low = slope;
            weight_high /= 2;
        } else {
            high = std::move(middle);
            weight_high = slope;
            weight_low /= 2;
        }
    }
    return std::abs(weight_low) < std::abs(weight_high) ? low.s : high.s;
}

bool BranchWalk::move_to(double coordinate) {
    start_here_ = here_;
    start_before_ = before_;
    start_regular_ = regular_;
    const bool had_before = has_before_;
    double step = longest_step_;
    const double least = 1e-6 * longest_step_;
    while (here_.s != coordinate) {
        const double left = coordinate - here_.s;
        const double s = std::abs(left) <= step ? coordinate : here_.s + std::copysign(step, left);
        if (try_step(s)) {
            accept();
            step = std::min(2 * step, longest_step_);
            continue;
        }
        step = std::min(step, std::abs(left)) / 2;
        if (step > least) continue;
        if (!find_limit(coordinate)) {
            here_ = start_here_;
            before_ = start_before_;
            regular_ = start_regular_;
            has_before_ = had_before;
            closure_.set_places(here_.q);
            return false;
        }
        accept();
        step = longest_step_;
    }
    return true;
}

}  // namespace kinegraph::closing
