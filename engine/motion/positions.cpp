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

/// Bits after the point of refined unknowns.
int grid_of(const Closure& closure) { return closure.bits + 8; }

Vector facing_on_grid(const Exact& angle, int grid) {
    return unit_along(direction_of(Angle{angle, false}, grid), grid);
}

/// `q`: the unknowns by column.
std::vector<BodyPlaceOf<Exact>> places_at(const Closure& closure, const std::vector<Exact>& q) {
    std::vector<BodyPlaceOf<Exact>> places(closure.bodies.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Closure::Body& body = closure.bodies[i];
        places[i].at = body.x < 0 ? body.reference : Vector{q[at_index(body.x)], q[at_index(body.x) + 1]};
        if (i == 0) continue;
        places[i].turn = q[at_index(body.turn)];
        places[i].facing = places[i].turn.is_zero() ? Vector{1, 0} : facing_on_grid(places[i].turn, grid_of(closure));
    }
    return places;
}

/// Weight of the values at ±k in the middle of the polynomial through those at ±1, … ±m: (−1)^(k+1) m!²/((m−k)!(m+k)!).
Exact weight_at_middle(int k, int m) {
    Exact weight = k % 2 == 1 ? 1 : -1;
    for (int i = 1; i <= k; ++i) weight *= Exact::ratio(m - k + i, m + i);
    return weight;
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
    made.origin_ = closure->origin;
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

bool Positions::is_near(double coordinate) const {
    constexpr double most_steps = 180'000;
    return std::abs(coordinate - this->coordinate()) <= most_steps * walk_.longest_step();
}

VectorOf<double> Positions::seen_from(BodyIndex body, const VectorOf<double>& place) const {
    const BodyPlaceOf<double>& at = now(body);
    return unit_ * (faced(VectorOf<double>{at.facing.x, -at.facing.y}, (1 / unit_) * place - at.at) +
                    closing::rough(numeric().bodies()[at_index(body)].reference));
}

std::vector<Closure::Body> Positions::bodies() const {
    std::vector<Closure::Body> all = numeric().bodies();
    for (Closure::Body& body : all) body.reference = body.reference + (1 / Exact::from_double(unit_)) * origin_;
    return all;
}

RigidMotion Positions::motion(BodyIndex body) const {
    const BodyPlaceOf<double>& at = now(body);
    const VectorOf<double> reference = closing::rough(numeric().bodies()[at_index(body)].reference);
    return {at.facing, unit_ * (at.at - faced(at.facing, reference)) + origin() - faced(at.facing, origin())};
}

/// Beside a limit at the distance e, positions are a power series in √e: 3 q(e) − 3 q(4e) + q(9e) is free of its first
/// two terms.
std::optional<Positions> Positions::at_limit(double limit, double inward) const {
    // Limits are known to 1e-9, or less well beside a change point.
    for (const double near : {1e-8, 1e-7, 1e-6, 1e-5}) {
        Positions close = *this;
        std::vector<double> q(close.state().size());
        bool is_reached = true;
        for (const auto& [steps, share] : {std::pair(9, 1), {4, -3}, {1, 3}}) {
            is_reached = is_reached && close.move_to(limit + steps * near * inward);
            for (std::size_t k = 0; k < q.size() && is_reached; ++k) q[k] += share * close.state()[k];
        }
        if (!is_reached) continue;
        close.walk_.closure().set_places(q);
        return close;
    }
    return std::nullopt;
}

/// Iterative refinement: with the matrix in doubles each pass adds some fifteen digits, from exact residuals.
std::optional<std::vector<Exact>> Positions::refined_state(const Closure& closure, const Exact& coordinate) {
    closing::NumericClosure& numeric = walk_.closure();
    closing::State state = walk_.here();
    // At the edge of what doubles can close, the position is as good as it was.
    if (!numeric.close(state)) state = walk_.here();
    numeric.set_places(state.q);
    numeric.factor();
    numeric.set_places(walk_.here().q);
    const int grid = grid_of(closure);
    const auto facing = [&](const Exact& angle) { return facing_on_grid(angle, grid); };
    std::vector<Exact> q, targets;
    for (const double value : state.q) q.push_back(Exact::from_double(value));
    for (const Exact& share : shares_) targets.push_back(coordinate * share);
    for (const Closure::Row& row : closure.rows)
        if (row.driver >= 0 && row.kind != Closure::Row::Kind::turns) targets[at_index(row.driver)] /= closure.unit;
    std::vector<double> excesses(closure.rows.size());
    const double done = std::ldexp(1, -closure.bits - 2);
    for (int pass = 0; pass < 40; ++pass) {
        const std::vector<BodyPlaceOf<Exact>> places = places_at(closure, q);
        for (const BodyPlaceOf<Exact>& each : places)
            for (const Exact* number : {&each.at.x, &each.at.y, &each.facing.x, &each.facing.y})
                refined_bits_ += number->bits();
        for (std::size_t r = 0; r < closure.rows.size(); ++r) {
            const Closure::Row& row = closure.rows[r];
            Exact value = excess(row, places[at_index(row.i)], places[at_index(row.j)], facing);
            if (row.driver >= 0) value -= targets[at_index(row.driver)];
            refined_bits_ += value.bits();
            excesses[r] = value.to_double();
        }
        const std::vector<double>& correction = numeric.correction(excesses);
        if (!std::all_of(correction.begin(), correction.end(), [](double each) { return std::isfinite(each); }))
            return std::nullopt;
        if (closing::largest(correction) < done) break;
        for (std::size_t k = 0; k < q.size(); ++k) q[k] = rounded(q[k] - Exact::from_double(correction[k]), grid);
    }
    return q;  // beside a change point after many passes, each of which adds few digits
}

std::optional<std::vector<BodyPlaceOf<Exact>>> Positions::refined(const Closure& closure, const Exact& coordinate) {
    const auto q = refined_state(closure, coordinate);
    return q ? std::optional(places_at(closure, *q)) : std::nullopt;
}

std::optional<std::vector<BodyPlaceOf<Exact>>> Positions::refined_across(const Closure& closure,
                                                                         const Exact& coordinate) const {
    // Sixteen positions on either side: the error of the polynomial is about (h/r)^32, where r is the distance of the
    // next limit or change point. It is estimated by fourteen of them.
    constexpr int most = 16, fewer = 14;
    const Exact enough = Exact::power_of_two(-closure.bits);
    for (int finer = 4; finer <= 14; ++finer) {
        const Exact h = Exact::power_of_two(std::ilogb(walk_.longest_step()) - finer);
        std::vector<Exact> found(walk_.here().q.size()), estimate(found.size());
        const auto add = [&](int k) {
            Positions beside = *this;
            const Exact at = coordinate + k * h;
            if (!beside.move_to(at.to_double()) || beside.is_singular()) return false;
            const auto q = beside.refined_state(closure, at);
            if (!q) return false;
            const int side = std::abs(k);
            for (std::size_t i = 0; i < q->size(); ++i) {
                found[i] += weight_at_middle(side, most) * (*q)[i];
                if (side <= fewer) estimate[i] += weight_at_middle(side, fewer) * (*q)[i];
            }
            return true;
        };
        bool is_found = true;
        for (int k = 1; k <= most && is_found; ++k) is_found = add(k) && add(-k);
        for (std::size_t i = 0; i < found.size() && is_found; ++i) is_found = abs(found[i] - estimate[i]) < enough;
        if (!is_found) continue;
        for (Exact& each : found) each = rounded(each, grid_of(closure));
        return places_at(closure, found);
    }
    return std::nullopt;
}

}  // namespace kinegraph
