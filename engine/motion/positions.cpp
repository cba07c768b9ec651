#include "engine/motion/positions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/mechanism/drivers.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/positions.hpp"

namespace kinegraph {
namespace {

Error stuck(const Driver& driver) {
    return {ErrorCode::no_unique_answer, where_of(driver), {lang::positions::the_drawn_position_is_a_dead}};
}

Error no_branch(const Driver& driver) {
    return {ErrorCode::bad_input, where_of(driver), {lang::positions::no_branch_is_to_be_chosen}};
}
Error no_such_branch(const Driver& driver, std::size_t branch) {
    return {ErrorCode::no_unique_answer,
            where_of(driver),
            {lang::positions::from_the_drawn_position_the_driver, std::to_string(branch + 1)}};
}

/// By driver: its coordinate divided by the course's, in rad and m.
std::vector<Exact> shares_in(const Course& course, const std::vector<Driver>& drivers) {
    std::vector<Exact> shares(drivers.size());
    shares[at_index(course.driver)] = 1;
    for (const Course::Along& each : course.along) shares[at_index(each.driver)] = each.per;
    return shares;
}

/// The longest step of a course: two degrees, or a fortieth of the drawing, for each driver. Prediction from velocities
/// is reliable that far.
double longest_step(const std::vector<Driver>& drivers, const std::vector<Exact>& shares, double unit) {
    constexpr double longest_turn = 0.035, longest_share = 1.0 / 40;
    double longest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < drivers.size(); ++i) {
        const double share = shares[i].to_double();
        if (share != 0)
            longest = std::min(longest, (turns(drivers[i]) ? longest_turn : longest_share * unit) / std::abs(share));
    }
    return longest;
}

}  // namespace

Result<Positions> Positions::of(const Mechanism& mechanism, const Pose& pose, const Course& course) {
    auto closure = closure_of(mechanism, pose);
    if (!closure) return tl::unexpected(std::move(closure.error()));
    auto carriers = carriers_of(mechanism);
    if (!carriers) return tl::unexpected(std::move(carriers.error()));
    const std::vector<Driver>& drivers = mechanism.drivers;
    const Driver& first = drivers[at_index(course.driver)];
    Positions made;
    made.unit_ = closure->unit.to_double();
    made.shares_ = shares_in(course, drivers);
    std::vector<double> shares_in_rows;
    for (std::size_t i = 0; i < drivers.size(); ++i) {
        const double share = made.shares_[i].to_double();
        shares_in_rows.push_back(turns(drivers[i]) ? share : share / made.unit_);
    }
    made.rules_ = closing::PlaceRules(mechanism, pose, *closure, *carriers);
    made.walk_ = closing::BranchWalk(closing::NumericClosure(*closure, std::move(shares_in_rows)),
                                     longest_step(drivers, made.shares_, made.unit_));
    closing::StartOfWalk start(made.walk_);
    if (!start.start_as_drawn(drivers.size())) {
        made.branch_ = start.start_at_change_point(mechanism, pose, course.branch);
        if (!made.branch_)
            return tl::unexpected(Errors{course.branch ? no_such_branch(first, *course.branch) : stuck(first)});
    }
    if (course.branch && !made.branch_) return tl::unexpected(Errors{no_branch(first)});
    return made;
}

VectorOf<double> Positions::seen_from(BodyIndex body, const VectorOf<double>& place) const {
    const BodyPlaceOf<double>& at = now(body);
    return unit_ * (faced(VectorOf<double>{at.facing.x, -at.facing.y}, (1 / unit_) * place - at.at) +
                    closing::rough(bodies()[at_index(body)].reference));
}

/// Iterative refinement: with the matrix in doubles each pass adds some fifteen digits, from exact residuals.
std::vector<BodyPlaceOf<Exact>> Positions::refined(const Closure& closure, const Exact& coordinate) {
    closing::NumericClosure& numeric = walk_.closure();
    closing::State state = walk_.here();
    KG_ASSERT(numeric.close(state), "a position that was reached is reached again");
    numeric.factor();
    numeric.set_places(walk_.here().q);
    const int grid = closure.bits + 8;
    const auto facing = [&](const Exact& angle) { return unit_along(direction_of(Angle{angle, false}, grid), grid); };
    std::vector<Exact> q, targets;
    for (const double value : state.q) q.push_back(Exact::from_double(value));
    for (const Exact& share : shares_) targets.push_back(coordinate * share);
    for (const Closure::Row& row : closure.rows)
        if (row.driver >= 0 && row.kind != Closure::Row::Kind::turns) targets[at_index(row.driver)] /= closure.unit;
    std::vector<BodyPlaceOf<Exact>> places(closure.bodies.size());
    std::vector<double> excesses(closure.rows.size());
    const double done = std::ldexp(1, -closure.bits - 2);
    for (int pass = 0; pass < 40; ++pass) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Closure::Body& body = closure.bodies[i];
            places[i].at = body.x < 0 ? body.reference : Vector{q[at_index(body.x)], q[at_index(body.x) + 1]};
            if (i == 0) continue;
            places[i].turn = q[at_index(body.turn)];
            places[i].facing = places[i].turn.is_zero() ? Vector{1, 0} : facing(places[i].turn);
        }
        for (std::size_t r = 0; r < closure.rows.size(); ++r) {
            const Closure::Row& row = closure.rows[r];
            Exact value = excess(row, places[at_index(row.i)], places[at_index(row.j)], facing);
            if (row.driver >= 0) value -= targets[at_index(row.driver)];
            excesses[r] = value.to_double();
        }
        const std::vector<double>& correction = numeric.correction(excesses);
        if (closing::largest(correction) < done) break;
        for (std::size_t k = 0; k < q.size(); ++k) q[k] = rounded(q[k] - Exact::from_double(correction[k]), grid);
    }
    return places;
}

}  // namespace kinegraph
