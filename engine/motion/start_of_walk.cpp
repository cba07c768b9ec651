#include "engine/motion/start_of_walk.hpp"

#include <algorithm>
#include <cmath>

#include "engine/motion/mobility.hpp"
#include "engine/number/elimination.hpp"
#include "engine/number/functions.hpp"

namespace kinegraph::closing {
namespace {

/// By how much the rows are off at the current places, those too that Newton's method left out as dependent.
double largest_excess(const NumericClosure& closure, double s) {
    const auto facing = [](double angle) { return Spot{nearest::cos(angle), nearest::sin(angle)}; };
    const BodyPlaces& places = closure.places();
    double largest = 0;
    for (const NumericClosure::Row& row : closure.rows()) {
        const double off = excess(row, places[at_index(row.i)], places[at_index(row.j)], facing);
        largest = std::max(largest, std::abs(off - s * closure.rate(row)));
    }
    return largest;
}

}  // namespace

// --- as drawn
// -----------------------------------------------------------------------------------------------------------------

bool StartOfWalk::start_as_drawn(std::size_t drivers) {
    closure_.set_places(drawn_.q);
    const std::size_t of_joints = closure_.rank(false);
    const std::size_t rank = closure_.rank(true);
    if (rank < of_joints + drivers) return false;
    closure_.freeze_beyond(rank);
    closure_.take_leading_rows(rank);
    closure_.look_along(drawn_);
    drawn_.slack = closure_.slack();
    drawn_.sign = closure_.sign_of_leading_rows();
    walk_.start_at(drawn_);
    if (rank == closure_.columns()) return true;
    // A body at rest must be free everywhere; at a change point it is free in the drawn pose only.
    const double step = walk_.longest_step() / 7, as_drawn = largest_excess(closure_, 0);
    constexpr double rounding = 1e-7;
    const bool moves = walk_.move_to(step) && largest_excess(closure_, step) < rounding + 4 * as_drawn;
    closure_.unfreeze();
    const bool stays_free = moves && closure_.rank(true) == rank;
    if (stays_free) closure_.freeze_beyond(rank);
    walk_.start_at(drawn_);
    return stays_free;
}

// --- out of a change point
// ----------------------------------------------------------------------------------------------------

std::optional<BranchTaken> StartOfWalk::start_at_change_point(const Mechanism& mechanism, const Pose& pose,
                                                              std::optional<std::size_t> asked) {
    const InstantMotion motion = instant_motion_of(mechanism, pose, mobility_of(mechanism, pose));
    if (motion.second_order != InstantMotion::SecondOrder::branches) return std::nullopt;
    for (std::size_t i = 0; i < motion.branches.size(); ++i) {
        if (asked && *asked != i) continue;
        const auto tangent = tangent_of(motion.branches[i]);
        if (tangent && start_along(*tangent)) return BranchTaken{i, motion.branches.size()};
    }
    return std::nullopt;
}

/// dq/ds with the branch's ratios of angular velocities, at the drawn pose. Nothing where the drivers contradict them.
std::optional<std::vector<double>> StartOfWalk::tangent_of(const Branch& branch) {
    const std::size_t columns = drawn_.q.size();
    std::vector<bool> turning(columns, false);
    std::vector<double> ratio(columns, 0.0);
    for (std::size_t i = 1; i < closure_.bodies().size(); ++i) {
        const std::size_t column = at_index(closure_.bodies()[i].turn);
        turning[column] = true;
        ratio[column] = branch.ratios.empty() ? 0 : branch.ratios[i];
    }
    // Keeps the places, with one additional unknown that scales all rotations.
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < columns; ++k)
        if (!turning[k]) places.push_back(k);
    const auto& rows = closure_.rows();
    std::vector<double> line(columns), wanted(rows.size()), found(places.size() + 1);
    Elimination rates;
    rates.resize(rows.size(), places.size() + 1);
    rates.clear();
    closure_.set_places(drawn_.q);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        std::fill(line.begin(), line.end(), 0.0);
        closure_.write(rows[r], line.data());
        for (std::size_t k = 0; k < places.size(); ++k) rates.row(r)[k] = line[places[k]];
        for (std::size_t k = 0; k < columns; ++k) rates.row(r)[places.size()] += line[k] * ratio[k];
        wanted[r] = closure_.rate(rows[r]);
    }
    rates.factor();
    rates.solve(wanted, found);
    std::vector<double> tangent(columns, 0.0);
    for (std::size_t k = 0; k < places.size(); ++k) tangent[places[k]] = found[k];
    for (std::size_t k = 0; k < columns; ++k)
        if (turning[k]) tangent[k] = ratio[k] * found.back();
    if (contradicts_rows(tangent)) return std::nullopt;
    return tangent;
}

bool StartOfWalk::contradicts_rows(const std::vector<double>& tangent) const {
    std::vector<double> line(tangent.size());
    const double tolerated = 1e-6 * std::max(1.0, largest(tangent));
    return std::any_of(closure_.rows().begin(), closure_.rows().end(), [&](const NumericClosure::Row& row) {
        std::fill(line.begin(), line.end(), 0.0);
        closure_.write(row, line.data());
        double off = -closure_.rate(row);
        for (std::size_t k = 0; k < line.size(); ++k) off += line[k] * tangent[k];
        return std::abs(off) > tolerated;
    });
}

/// Accepts the tangent's branch if a position a little ahead lies on it; the next position is predicted from there.
bool StartOfWalk::start_along(const std::vector<double>& tangent) {
    const std::size_t columns = drawn_.q.size();
    for (double reach = 0.05 * walk_.longest_step(); reach < walk_.longest_step(); reach *= 3) {
        State ahead = drawn_;
        ahead.s = reach;
        for (std::size_t k = 0; k < columns; ++k) ahead.q[k] += reach * tangent[k];
        closure_.expect_leading_rows(columns);
        if (!closure_.close(ahead) || closure_.rank_factored() < columns || !BranchWalk::is_regular(ahead)) continue;
        closure_.factor();
        closure_.look_along(ahead);
        double bend = 0;
        for (std::size_t k = 0; k < columns; ++k) bend = std::max(bend, std::abs(ahead.v[k] - tangent[k]));
        if (bend > 0.3 * std::max(largest(tangent), largest(ahead.v))) continue;
        closure_.take_leading_rows(columns);
        ahead.sign = closure_.sign_of_leading_rows();
        drawn_.v = tangent;
        drawn_.slack = 0;
        drawn_.sign = ahead.sign;
        walk_.start_at_change_point(drawn_, ahead);
        return true;
    }
    return false;
}

}  // namespace kinegraph::closing
