#include "engine/motion/numeric_closure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/number/functions.hpp"

namespace kinegraph::closing {
namespace {

Spot facing_of(double angle) { return {nearest::cos(angle), nearest::sin(angle)}; }

/// A row in doubles, its lengths in the closure's unit.
ClosureRowOf<double> rough_row(const Closure::Row& row) {
    return {static_cast<ClosureRowOf<double>::Kind>(row.kind),
            row.i,
            row.j,
            rough(row.p),
            rough(row.q),
            rough(row.along),
            row.offset.to_double(),
            row.lever.to_double(),
            row.share_i.to_double(),
            row.share_j.to_double(),
            row.driver};
}

}  // namespace

double largest(const std::vector<double>& values) {
    double size = 0;
    for (const double value : values) size = std::max(size, std::abs(value));
    return size;
}

NumericClosure::NumericClosure(const Closure& closure, std::vector<double> shares)
    : bodies_(closure.bodies), shares_(std::move(shares)), places_(closure.bodies.size()) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) places_[i].at = rough(bodies_[i].reference);
    for (const Closure::Row& row : closure.rows) rows_.push_back(rough_row(row));
    const auto columns = static_cast<std::size_t>(closure.columns);
    frozen_.assign(columns, false);
    jacobian_.resize(rows_.size(), columns);
    right_.resize(rows_.size());
    delta_.resize(columns);
}

State NumericClosure::drawn() const {
    State state;
    state.q.assign(columns(), 0);
    state.v.assign(columns(), 0);
    for (const Closure::Body& body : bodies_) {
        if (body.x < 0) continue;
        state.q[at_index(body.x)] = body.reference.x.to_double();
        state.q[at_index(body.x) + 1] = body.reference.y.to_double();
    }
    return state;
}

// --- the equations
// ------------------------------------------------------------------------------------------------------------

void NumericClosure::set_places(const std::vector<double>& q) {
    for (std::size_t i = 1; i < bodies_.size(); ++i) {
        BodyPlaceOf<double>& place = places_[i];
        if (bodies_[i].x >= 0) place.at = {q[at_index(bodies_[i].x)], q[at_index(bodies_[i].x) + 1]};
        place.turn = q[at_index(bodies_[i].turn)];
        place.facing = facing_of(place.turn);
    }
}

void NumericClosure::write_excesses(double s) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        right_[i] = excess(rows_[i], now(rows_[i].i), now(rows_[i].j), facing_of);
        if (rows_[i].driver >= 0) right_[i] -= s * rate(rows_[i]);
    }
}

void NumericClosure::put(double* into, BodyIndex body, const Spot& direction, double turning) const {
    if (body == frame) return;
    const Closure::Body& at = bodies_[at_index(body)];
    if (at.x >= 0 && !frozen_[at_index(at.x)]) into[at.x] += direction.x;
    if (at.x >= 0 && !frozen_[at_index(at.x) + 1]) into[at.x + 1] += direction.y;
    if (!frozen_[at_index(at.turn)]) into[at.turn] += turning;
}

void NumericClosure::write(const Row& row, double* into) const {
    using Kind = Row::Kind;
    if (row.kind == Kind::turns) {
        put(into, row.i, {}, 1);
        return put(into, row.j, {}, -1);
    }
    const BodyPlaceOf<double>&i = now(row.i), &j = now(row.j);
    const Spot p = faced(i.facing, row.p), q = faced(j.facing, row.q);
    const Spot d = i.at + p - j.at - q;
    Spot n = row.along;
    double more_i = 0, more_j = 0;
    if (row.kind == Kind::on_line) {
        n = faced(j.facing, row.along);
        more_i = -row.lever;
        more_j = row.lever + dot(quarter_turn(n), d);
    } else if (row.kind == Kind::at_distance) {
        n = (1 / row.offset) * d;
    } else if (row.kind == Kind::rolls_round) {
        const Spot e = faced(facing_of(row.share_i * i.turn + row.share_j * j.turn), row.along);
        n = quarter_turn(e);
        more_i = -row.share_i * dot(e, d);
        more_j = -row.share_j * dot(e, d);
    }
    put(into, row.i, n, dot(n, quarter_turn(p)) + more_i);
    put(into, row.j, -n, -dot(n, quarter_turn(q)) + more_j);
}

void NumericClosure::write_jacobian() {
    jacobian_.clear();
    for (std::size_t i = 0; i < rows_.size(); ++i) write(rows_[i], jacobian_.row(i));
}

void NumericClosure::factor() {
    write_jacobian();
    jacobian_.factor();
}

// --- rows that determine the motion
// -------------------------------------------------------------------------------------------

std::size_t NumericClosure::rank(bool with_drivers) {
    write_jacobian();
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (!with_drivers && rows_[i].driver >= 0) std::fill_n(jacobian_.row(i), jacobian_.columns(), 0.0);
    jacobian_.factor();
    // A point may miss its curve by 1e-9 of the size, so smaller pivots cannot be distinguished from redundant rows.
    constexpr double least = 1e-9;
    std::size_t rank = 0;
    while (rank < jacobian_.rank() && jacobian_.pivot_share(rank) > least) ++rank;
    return rank;
}

void NumericClosure::freeze_beyond(std::size_t rank) {
    for (std::size_t k = rank; k < columns(); ++k) frozen_[jacobian_.column_of_pivot(k)] = true;
}

void NumericClosure::unfreeze() { std::fill(frozen_.begin(), frozen_.end(), false); }

void NumericClosure::take_leading_rows(std::size_t count) {
    leading_.clear();
    for (std::size_t k = 0; k < count; ++k) leading_.push_back(jacobian_.row_of_pivot(k));
    std::sort(leading_.begin(), leading_.end());
    square_.resize(count, columns());
}

int NumericClosure::sign_of_leading_rows() {
    const bool same = leading_.size() == jacobian_.rows() && leading_.size() == jacobian_.columns();
    if (same) return jacobian_.rank() == leading_.size() ? jacobian_.sign() : 0;
    square_.clear();
    for (std::size_t i = 0; i < leading_.size(); ++i) write(rows_[leading_[i]], square_.row(i));
    square_.factor();
    return square_.rank() == leading_.size() ? square_.sign() : 0;
}

// --- Newton's method
// ----------------------------------------------------------------------------------------------------------

bool NumericClosure::close(State& state) {
    // With a matrix accurate to within the first correction, the error after a correction is about its square; doubles
    // resolve 1e-15.
    constexpr double enough = 1e-15, farthest = 0.5;
    constexpr int most = 25;
    double first = 0, last = 0;
    bool is_fresh = false;
    for (int i = 0; i < most; ++i) {
        set_places(state.q);
        write_excesses(state.s);
        if (i == 0 || (!is_fresh && last > 1e-3 * first)) {
            factor();
            is_fresh = true;
            first = 0;
        } else {
            is_fresh = false;
        }
        jacobian_.solve(right_, delta_);
        const double size = largest(delta_);
        if (!(size < farthest)) return false;
        for (std::size_t k = 0; k < delta_.size(); ++k) state.q[k] -= delta_[k];
        if (first == 0) first = size;
        last = size;
        if (size * std::max(first, size) < enough) break;
        // At rounding level further iterations do not improve.
        if (i > 3 && size < 1e-13) break;
        if (i + 1 == most) return false;
    }
    state.slack = slack();
    set_places(state.q);
    return true;
}

bool NumericClosure::close_at(std::size_t column, State& state, double& slope) {
    const double given = state.q[column];
    for (int i = 0; i < 25; ++i) {
        set_places(state.q);
        write_excesses(state.s);
        write_jacobian();
        for (std::size_t r = 0; r < rows_.size(); ++r) jacobian_.row(r)[column] = 0 - rate(rows_[r]);  // no −0
        jacobian_.factor();
        jacobian_.solve(right_, delta_);
        const double size = largest(delta_);
        if (!(size < 0.5)) return false;
        for (std::size_t k = 0; k < delta_.size(); ++k) state.q[k] -= delta_[k];
        state.s -= delta_[column];
        state.q[column] = given;
        if (size < 1e-9) break;
        if (i == 24) return false;
    }
    set_places(state.q);
    std::vector<double> line(jacobian_.columns());
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        std::fill(line.begin(), line.end(), 0.0);
        write(rows_[r], line.data());
        right_[r] = -line[column];
    }
    jacobian_.solve(right_, delta_);
    slope = delta_[column];
    state.v = delta_;
    return true;
}

void NumericClosure::look_along(State& state) {
    for (std::size_t i = 0; i < rows_.size(); ++i) right_[i] = rate(rows_[i]);
    jacobian_.solve(right_, state.v);
}

const std::vector<double>& NumericClosure::correction(std::vector<double>& excesses) {
    jacobian_.solve(excesses, delta_);
    return delta_;
}

}  // namespace kinegraph::closing
