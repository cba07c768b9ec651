#include "engine/positions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/assert.hpp"
#include "engine/drivers.hpp"
#include "engine/mobility.hpp"

namespace kinegraph {
namespace {

using Spot = VectorOf<double>;

Spot rough(const Vector& a) { return {a.x.to_double(), a.y.to_double()}; }
Spot facing_of(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// A row in doubles, its lengths in the closure's unit.
ClosureRowOf<double> rough(const Closure::Row& row) {
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

double largest(const std::vector<double>& values) {
    double size = 0;
    for (const double value : values) size = std::max(size, std::abs(value));
    return size;
}

Error stuck(const Driver& driver) {
    return {ErrorCode::no_unique_answer,
            where_of(driver),
            {"the drawn position is a dead point or a change point: the driver moves from it in no or in several ways; draw the "
             "mechanism in another position",
             "la posizione disegnata è un punto morto o un punto di biforcazione: il movente se ne muove in nessun modo o in più "
             "d’uno; disegnare il meccanismo in un’altra posizione"}};
}

Error no_branch(const Driver& driver) {
    return {ErrorCode::bad_input,
            where_of(driver),
            {"no branch is to be chosen: the drawn position is no change point",
             "non c’è ramo da scegliere: la posizione disegnata "
             "non è un punto di biforcazione"}};
}
Error no_such_branch(const Driver& driver, std::size_t branch) {
    return {ErrorCode::no_unique_answer,
            where_of(driver),
            {"from the drawn position the driver has no branch {0}; the results list them under \"branches\"",
             "dalla posizione disegnata il movente non ha un ramo {0}; i risultati li elencano in \"branches\"",
             std::to_string(branch + 1)}};
}

}  // namespace

// --- making -------------------------------------------------------------------------------------------------------------------

Result<Positions> Positions::of(const Mechanism& mechanism, const Pose& pose, const Course& course) {
    auto closure = closure_of(mechanism, pose);
    if (!closure) return tl::unexpected(std::move(closure.error()));
    auto carriers = carriers_of(mechanism);
    if (!carriers) return tl::unexpected(std::move(carriers.error()));
    Positions made;
    made.course_ = course;
    made.points_.resize(carriers->size());
    for (std::size_t i = 0; i < carriers->size(); ++i) made.points_[i].carrier = (*carriers)[i];
    made.prepare(*closure, mechanism);
    made.prepare_places(mechanism, pose);
    auto error = made.choose_leading_rows(mechanism);
    if (error && !made.leave_change_point(mechanism, pose)) {
        if (course.branch) error = no_such_branch(mechanism.drivers[at_index(course.driver)], *course.branch);
        return tl::unexpected(Errors{*std::move(error)});
    }
    if (course.branch && !made.branch_) return tl::unexpected(Errors{no_branch(mechanism.drivers[at_index(course.driver)])});
    return made;
}

void Positions::prepare(const Closure& closure, const Mechanism& mechanism) {
    unit_ = closure.unit.to_double();
    prepare_course(mechanism);
    bodies_ = closure.bodies;
    places_.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) places_[i].at = rough(bodies_[i].reference);
    for (const Closure::Row& row : closure.rows) rows_.push_back(rough(row));
    const auto columns = static_cast<std::size_t>(closure.columns);
    frozen_.assign(columns, false);
    jacobian_.resize(rows_.size(), columns);
    right_.resize(rows_.size());
    delta_.resize(columns);
    here_.q.assign(columns, 0);
    here_.v.assign(columns, 0);
    for (const Closure::Body& body : bodies_) {
        if (body.x < 0) continue;
        here_.q[at_index(body.x)] = body.reference.x.to_double();
        here_.q[at_index(body.x) + 1] = body.reference.y.to_double();
    }
}

void Positions::prepare_course(const Mechanism& mechanism) {
    const std::vector<Driver>& drivers = mechanism.drivers;
    exact_shares_.resize(drivers.size());
    exact_shares_[at_index(course_.driver)] = 1;
    for (const Course::Along& each : course_.along) exact_shares_[at_index(each.driver)] = each.per;
    // Two degrees, or a fortieth of the drawing: what a look ahead by velocities can well see.
    constexpr double longest_turn = 0.035, longest_share = 1.0 / 40;
    longest_step_ = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < drivers.size(); ++i) {
        const double share = exact_shares_[i].to_double();
        shares_.push_back(turns(drivers[i]) ? share : share / unit_);
        if (share != 0)
            longest_step_ = std::min(longest_step_, (turns(drivers[i]) ? longest_turn : longest_share * unit_) / std::abs(share));
    }
}

void Positions::prepare_places(const Mechanism& mechanism, const Pose& pose) {
    const auto local = [&](BodyIndex body, PointIndex point) {
        return rough((1 / Exact::from_double(unit_)) * pose.at(point) - bodies_[at_index(body)].reference);
    };
    for (std::size_t i = 0; i < points_.size(); ++i)
        if (points_[i].carrier.body != none) points_[i].local = local(points_[i].carrier.body, PointIndex(i));
    for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
        const Joint& joint = mechanism.joints[k];
        const PlanePair& pair = joint.pair();
        JointRule& rule = joints_.emplace_back();
        if (pair.has_common_point()) continue;
        rule.bodies = {joint.bodies[0], joint.bodies[1]};
        rule.point = joint.point;
        rule.guide = rough(pose.guides[k]);
        rule.tangent = rough(pose.tangents[k]);
        rule.normal = rough(pose.normals[k]);
        rule.touches = pair.touches();
        rule.meshes = pair.meshes();
        rule.is_arc = joint.arc != none;
        rule.locals = {local(joint.bodies[0], joint.point), local(joint.bodies[1], rule.is_arc ? joint.arc : joint.point)};
        if (pair.has_guide() && !rule.is_arc) rule.turns_with = joint.bodies[1];
        if (!pair.touches()) continue;
        rule.pressure = rough(unit_along(direction_of(joint.pressure_angle.value_or(Angle{}), pose.bits), pose.bits));
        const auto sides = sides_of(mechanism, pose, joint);
        KG_ASSERT(sides.has_value(), "a closure has the profiles of every contact");
        for (std::size_t side = 0; side < 2; ++side) {
            const ContactSide& of = (*sides)[side];
            rule.is_straight[side] = of.straight;
            rule.reaches[side] = of.reach.to_double() / unit_;
            if (of.straight) rule.turns_with = joint.bodies[side];
            if (of.centre == none) continue;
            rule.locals[side] = local(joint.bodies[side], of.centre);
            if (rule.first_circle < 0) rule.first_circle = static_cast<int>(side);
        }
    }
}

/// The driver must lead somewhere. Bodies that nothing determines rest: their columns are taken out.
std::optional<Error> Positions::choose_leading_rows(const Mechanism& mechanism) {
    const Error error = stuck(mechanism.drivers[at_index(course_.driver)]);
    const auto rank_of = [&](bool with_drivers) {
        write_jacobian();
        for (std::size_t i = 0; i < rows_.size(); ++i)
            if (!with_drivers && rows_[i].driver >= 0) std::fill_n(jacobian_.row(i), jacobian_.columns(), 0.0);
        jacobian_.factor();
        // A point may miss its curve by 1e-9 of the size, so no smaller pivot can be told from a redundant row.
        constexpr double least = 1e-9;
        std::size_t rank = 0;
        while (rank < jacobian_.rank() && jacobian_.pivot_share(rank) > least) ++rank;
        return rank;
    };
    set_places(here_.q);
    const std::size_t of_joints = rank_of(false);
    const std::size_t rank = rank_of(true);
    if (rank < of_joints + mechanism.drivers.size()) return error;
    for (std::size_t k = rank; k < jacobian_.columns(); ++k) frozen_[jacobian_.column_of_pivot(k)] = true;
    for (std::size_t k = 0; k < rank; ++k) leading_.push_back(jacobian_.row_of_pivot(k));
    std::sort(leading_.begin(), leading_.end());
    square_.resize(rank, jacobian_.columns());
    look_along(here_);
    here_.slack = jacobian_.pivot_share(rank - 1);
    here_.sign = sign_of_leading_rows();
    for (State* state : {&before_, &next_, &regular_, &low_, &high_, &middle_}) *state = here_;
    if (rank == jacobian_.columns()) return std::nullopt;
    // What rests must be free everywhere; at a change point it is free in the drawn pose alone.
    const State drawn = here_;
    const bool moves = move_to(longest_step_ / 7);
    std::fill(frozen_.begin(), frozen_.end(), false);
    const bool stays_free = moves && rank_of(true) == rank;
    for (std::size_t k = rank; stays_free && k < jacobian_.columns(); ++k) frozen_[jacobian_.column_of_pivot(k)] = true;
    here_ = regular_ = drawn;
    has_before_ = false;
    set_places(here_.q);
    return stays_free ? std::nullopt : std::optional(error);
}

// --- out of a change point ----------------------------------------------------------------------------------------------------

/// The branches that the second order allows, each tried: those that a step along them confirms, of which one is taken.
bool Positions::leave_change_point(const Mechanism& mechanism, const Pose& pose) {
    const InstantMotion motion = instant_motion_of(mechanism, pose, mobility_of(mechanism, pose));
    if (motion.second_order != InstantMotion::SecondOrder::branches) return false;
    std::vector<std::pair<std::size_t, std::vector<double>>> ways;
    for (std::size_t i = 0; i < motion.branches.size(); ++i) {
        if (course_.branch && *course_.branch != i) continue;
        if (auto tangent = tangent_of(motion.branches[i])) ways.emplace_back(i, *std::move(tangent));
    }
    std::stable_sort(ways.begin(), ways.end(),
                     [](const auto& a, const auto& b) { return largest(a.second) < (1 - 1e-9) * largest(b.second); });
    for (const auto& [index, tangent] : ways) {
        if (!start_along(tangent)) continue;
        branch_ = {index, motion.branches.size()};
        return true;
    }
    return false;
}

/// dq/ds with the branch's ratios of angular velocities, at the drawn pose. Nothing where the drivers contradict them.
std::optional<std::vector<double>> Positions::tangent_of(const Branch& branch) {
    const std::size_t columns = here_.q.size();
    std::vector<bool> turning(columns, false);
    std::vector<double> ratio(columns, 0.0);
    for (std::size_t i = 1; i < bodies_.size(); ++i) {
        const std::size_t column = at_index(bodies_[i].turn);
        turning[column] = true;
        ratio[column] = branch.ratios.empty() ? 0 : branch.ratios[i];
    }
    // The places as they are, and one unknown more for all turns together.
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < columns; ++k)
        if (!turning[k]) places.push_back(k);
    std::vector<double> line(columns), wanted(rows_.size()), found;
    Elimination rates;
    rates.resize(rows_.size(), places.size() + 1);
    rates.clear();
    set_places(here_.q);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        std::fill(line.begin(), line.end(), 0.0);
        write(rows_[r], line.data());
        for (std::size_t k = 0; k < places.size(); ++k) rates.row(r)[k] = line[places[k]];
        for (std::size_t k = 0; k < columns; ++k) rates.row(r)[places.size()] += line[k] * ratio[k];
        wanted[r] = rows_[r].driver >= 0 ? shares_[at_index(rows_[r].driver)] : 0;
    }
    rates.factor();
    found.resize(places.size() + 1);
    std::vector<double> used = wanted;
    rates.solve(used, found);
    std::vector<double> tangent(columns, 0.0);
    for (std::size_t k = 0; k < places.size(); ++k) tangent[places[k]] = found[k];
    for (std::size_t k = 0; k < columns; ++k)
        if (turning[k]) tangent[k] = ratio[k] * found.back();
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        std::fill(line.begin(), line.end(), 0.0);
        write(rows_[r], line.data());
        double off = -wanted[r];
        for (std::size_t k = 0; k < columns; ++k) off += line[k] * tangent[k];
        if (std::abs(off) > 1e-6 * std::max(1.0, largest(tangent))) return std::nullopt;
    }
    return tangent;
}

/// Takes the tangent's branch if a position a little ahead lies on it; what comes next is seen from there.
bool Positions::start_along(const std::vector<double>& tangent) {
    const std::size_t columns = here_.q.size();
    for (double reach = 0.05 * longest_step_; reach < longest_step_; reach *= 3) {
        State ahead = here_;
        ahead.s = reach;
        for (std::size_t k = 0; k < columns; ++k) ahead.q[k] += reach * tangent[k];
        leading_.resize(columns);  // as many as are wanted; which they are is seen ahead
        if (!close(ahead) || jacobian_.rank() < columns || ahead.slack < 100 * least_slack) continue;
        write_jacobian();
        jacobian_.factor();
        look_along(ahead);
        double bend = 0;
        for (std::size_t k = 0; k < columns; ++k) bend = std::max(bend, std::abs(ahead.v[k] - tangent[k]));
        if (bend > 0.3 * std::max(largest(tangent), largest(ahead.v))) continue;
        for (std::size_t k = 0; k < columns; ++k) leading_[k] = jacobian_.row_of_pivot(k);
        std::sort(leading_.begin(), leading_.end());
        square_.resize(columns, columns);
        ahead.sign = sign_of_leading_rows();
        here_.v = tangent;
        here_.slack = 0;
        here_.sign = ahead.sign;
        for (State* state : {&before_, &next_, &low_, &high_, &middle_}) *state = here_;
        regular_ = ahead;
        change_points_ = {0};
        set_places(here_.q);
        return true;
    }
    return false;
}

// --- the equations ------------------------------------------------------------------------------------------------------------

void Positions::set_places(const std::vector<double>& q) {
    for (std::size_t i = 1; i < bodies_.size(); ++i) {
        BodyPlaceOf<double>& place = places_[i];
        if (bodies_[i].x >= 0) place.at = {q[at_index(bodies_[i].x)], q[at_index(bodies_[i].x) + 1]};
        place.turn = q[at_index(bodies_[i].turn)];
        place.facing = facing_of(place.turn);
    }
}

void Positions::write_excesses(double s) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        right_[i] = excess(rows_[i], now(rows_[i].i), now(rows_[i].j), facing_of);
        if (rows_[i].driver >= 0) right_[i] -= s * shares_[at_index(rows_[i].driver)];
    }
}

void Positions::put(double* into, BodyIndex body, const Spot& direction, double turning) const {
    if (body == frame) return;
    const Closure::Body& at = bodies_[at_index(body)];
    if (at.x >= 0 && !frozen_[at_index(at.x)]) into[at.x] += direction.x;
    if (at.x >= 0 && !frozen_[at_index(at.x) + 1]) into[at.x + 1] += direction.y;
    if (!frozen_[at_index(at.turn)]) into[at.turn] += turning;
}

/// The gradient: n · dD and what the turns add, with dD = dP − dQ.
void Positions::write(const Row& row, double* into) const {
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

void Positions::write_jacobian() {
    jacobian_.clear();
    for (std::size_t i = 0; i < rows_.size(); ++i) write(rows_[i], jacobian_.row(i));
}

/// Newton from state.q, the matrix kept as long as it serves. False: no position near.
bool Positions::close(State& state) {
    // With a matrix that is right to within the first correction, a correction leaves about its square; doubles keep 1e-15.
    constexpr double enough = 1e-15, farthest = 0.5;
    constexpr int most = 25;
    double first = 0, last = 0;
    bool is_fresh = false;
    for (int i = 0; i < most; ++i) {
        set_places(state.q);
        write_excesses(state.s);
        if (i == 0 || (!is_fresh && last > 1e-3 * first)) {
            write_jacobian();
            jacobian_.factor();
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
        // Within a few roundings nothing gets better.
        if (i > 3 && size < 1e-13) break;
        if (i + 1 == most) return false;
    }
    state.slack = jacobian_.pivot_share(leading_.size() - 1);
    set_places(state.q);
    return true;
}

/// dq/ds by the matrix factored last.
void Positions::look_along(State& state) {
    for (std::size_t i = 0; i < rows_.size(); ++i) right_[i] = rows_[i].driver >= 0 ? shares_[at_index(rows_[i].driver)] : 0;
    jacobian_.solve(right_, state.v);
}

int Positions::sign_of_leading_rows() {
    const bool same = leading_.size() == jacobian_.rows() && leading_.size() == jacobian_.columns();
    if (same) return jacobian_.rank() == leading_.size() ? jacobian_.sign() : 0;
    square_.clear();
    for (std::size_t i = 0; i < leading_.size(); ++i) write(rows_[leading_[i]], square_.row(i));
    square_.factor();
    return square_.rank() == leading_.size() ? square_.sign() : 0;
}

// --- from one position to the next --------------------------------------------------------------------------------------------

/// Through the last two positions and their dq/ds, a cubic; from the first alone a straight line.
void Positions::predict(double s, std::vector<double>& q) const {
    const double ahead = s - here_.s, back = here_.s - before_.s;
    const bool cubic = has_before_ && ahead * back > 0 && std::abs(ahead) <= 2 * std::abs(back);
    const double t = cubic ? ahead / back : 0;
    for (std::size_t k = 0; k < q.size(); ++k) {
        q[k] = here_.q[k] + here_.v[k] * ahead;
        if (!cubic) continue;
        // Hermite on [−1, 0], carried on to t.
        const double rise = before_.q[k] - here_.q[k] + here_.v[k] * back, bend = (before_.v[k] - here_.v[k]) * back;
        q[k] += t * t * (3 * rise + bend) + t * t * t * (2 * rise + bend);
    }
}

bool Positions::try_step(double s) {
    next_.s = s;
    predict(s, next_.q);
    middle_.q = next_.q;
    if (!close(next_)) return false;
    look_along(next_);
    double correction = 0, bend = 0, speed = 1e-9;
    for (std::size_t k = 0; k < next_.q.size(); ++k) {
        correction = std::max(correction, std::abs(next_.q[k] - middle_.q[k]));
        bend = std::max(bend, std::abs(next_.v[k] - here_.v[k]));
        speed = std::max({speed, std::abs(next_.v[k]), std::abs(here_.v[k])});
    }
    if (next_.slack < least_slack) return bridge(next_);
    // Another branch may lie near: what a look ahead did not foresee by far is not trusted.
    if (correction > 0.2 * speed * std::abs(s - here_.s) || bend > 0.3 * speed) return false;
    next_.sign = sign_of_leading_rows();
    return next_.sign == regular_.sign || pass(regular_, next_);
}

void Positions::accept() {
    if (!is_singular()) {
        std::swap(before_, here_);
        has_before_ = true;
    } else {
        has_before_ = false;
    }
    std::swap(here_, next_);
    if (!is_singular()) regular_ = here_;
}

/// Cubic between two positions.
static void between(const std::vector<double>& a, const std::vector<double>& va, const std::vector<double>& b,
                    const std::vector<double>& vb, double width, double t, std::vector<double>& q) {
    for (std::size_t k = 0; k < q.size(); ++k) {
        const double rise = b[k] - a[k];
        q[k] = a[k] + t * width * va[k] + t * t * (3 * rise - width * (2 * va[k] + vb[k])) +
               t * t * t * (width * (va[k] + vb[k]) - 2 * rise);
    }
}

/// The determinant changed its sign between two positions. If it vanishes in between, where they are joined smoothly, that is a
/// change point, and is noted; if only the leading rows are at fault, it is nothing. False: the two are not on one branch.
bool Positions::pass(State& from, const State& to) {
    low_ = from;
    high_ = to;
    double slack = 1;
    constexpr double near = 1e-10;
    const auto next = next_;  // close() below sets the places; they are set again at the end
    for (int i = 0; i < 60 && std::abs(high_.s - low_.s) > near * longest_step_; ++i) {
        middle_.s = (low_.s + high_.s) / 2;
        between(low_.q, low_.v, high_.q, high_.v, high_.s - low_.s, 0.5, middle_.q);
        if (!close(middle_)) return false;
        slack = middle_.slack;
        look_along(middle_);
        middle_.sign = sign_of_leading_rows();
        if (middle_.sign == 0) {
            low_ = high_ = middle_;
            break;
        }
        std::swap(middle_.sign == from.sign ? low_ : high_, middle_);
    }
    next_ = next;
    set_places(next_.q);
    const bool vanishes = slack < 1e-5;
    if (vanishes) {
        const double found = (low_.s + high_.s) / 2;
        const auto known = [&](double each) { return std::abs(each - found) < 1e-5 * longest_step_; };
        if (std::none_of(change_points_.begin(), change_points_.end(), known)) change_points_.push_back(found);
    }
    return vanishes || leading_.size() < rows_.size();
}

/// A position in which the matrix is singular: found between two beside it.
bool Positions::bridge(State& state) {
    State ahead = state;
    const double way = state.s > here_.s ? 1 : -1;
    for (double reach = 0.05 * longest_step_; reach < longest_step_; reach *= 3) {
        low_ = here_;
        low_.s = state.s - way * reach;
        ahead.s = state.s + way * reach;
        predict(low_.s, low_.q);
        if (!close(low_) || low_.slack < 100 * least_slack) continue;
        look_along(low_);
        low_.sign = sign_of_leading_rows();
        predict(ahead.s, ahead.q);
        if (!close(ahead) || ahead.slack < 100 * least_slack) continue;
        look_along(ahead);
        ahead.sign = sign_of_leading_rows();
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
        // pass() keeps next_, which `state` is; what comes next is seen from beyond.
        state.sign = ahead.sign;
        state.slack = 0;
        regular_ = ahead;
        set_places(state.q);
        return true;
    }
    return false;
}

bool Positions::move_to(double coordinate) {
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
            set_places(here_.q);
            return false;
        }
        accept();
        step = longest_step_;
    }
    return true;
}

/// With the unknown of a column given and the driver's coordinate unknown in its stead; slope: ds over that unknown.
bool Positions::close_at(std::size_t column, State& state, double& slope) {
    const double given = state.q[column];
    for (int i = 0; i < 25; ++i) {
        set_places(state.q);
        write_excesses(state.s);
        write_jacobian();
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            jacobian_.row(r)[column] = rows_[r].driver >= 0 ? -shares_[at_index(rows_[r].driver)] : 0;
        }
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

/// Steps became too small. Seen along the unknown that moves fastest, the driver's coordinate goes to an extreme and turns round:
/// that is the limit. True: it goes on to `towards` after all, which is then in next_.
bool Positions::find_limit(double towards) {
    std::size_t column = 0;
    for (std::size_t k = 0; k < here_.v.size(); ++k)
        if (std::abs(here_.v[k]) > std::abs(here_.v[column])) column = k;
    limit_ = here_.s;
    if (here_.v[column] == 0) return false;
    const double way = (towards > here_.s ? 1 : -1) * (here_.v[column] > 0 ? 1 : -1);
    double slope_low = 1 / here_.v[column], slope = 0;
    State low = here_, high = here_, middle = here_;
    for (double reach = 1e-4;; reach *= 2) {
        if (reach > 0.3) return false;
        high = low;
        high.q[column] += way * reach;
        for (std::size_t k = 0; k < high.q.size(); ++k)
            if (k != column) high.q[k] += way * reach * here_.v[k] / here_.v[column];
        if (!close_at(column, high, slope)) return false;
        if (slope * slope_low <= 0) break;
        if ((high.s - towards) * (here_.s - towards) <= 0) {
            next_.s = towards;
            next_.q = high.q;
            if (!close(next_) || next_.slack < least_slack) return false;
            look_along(next_);
            next_.sign = sign_of_leading_rows();
            return true;
        }
    }
    for (int i = 0; i < 60 && std::abs(high.q[column] - low.q[column]) > 1e-12; ++i) {
        for (std::size_t k = 0; k < middle.q.size(); ++k) middle.q[k] = (low.q[k] + high.q[k]) / 2;
        middle.s = (low.s + high.s) / 2;
        if (!close_at(column, middle, slope)) break;
        (slope * slope_low > 0 ? low : high) = middle;
    }
    limit_ = (low.s + high.s) / 2;
    return false;
}

// --- reading ------------------------------------------------------------------------------------------------------------------

/// Where two profiles touch: on the normal through the one's centre, or on the line of both.
Spot Positions::contact_point(const JointRule& rule) const {
    const std::array<Spot, 2> centres{world(rule.bodies[0], rule.locals[0]), world(rule.bodies[1], rule.locals[1])};
    for (std::size_t side = 0; side < 2; ++side) {
        if (!rule.is_straight[side]) continue;
        const Spot tangent = faced(now(rule.turns_with).facing, rule.tangent);
        const double size = std::hypot(tangent.x, tangent.y);
        return centres[1 - side] - (rule.reaches[1 - side] / size) * quarter_turn(tangent);
    }
    const double apart = rule.reaches[0] - rule.reaches[1];
    return (rule.reaches[0] / apart) * centres[1] - (rule.reaches[1] / apart) * centres[0];
}

void Positions::read(Places& places) const {
    places.points.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const PointRule& rule = points_[i];
        const Spot at = rule.carrier.body != none ? world(rule.carrier.body, rule.local)
                                                  : contact_point(joints_[at_index(rule.carrier.contact)]);
        places.points[i] = unit_ * at;
    }
    for (auto* list : {&places.guides, &places.normals, &places.tangents}) list->resize(joints_.size());
    for (std::size_t k = 0; k < joints_.size(); ++k) {
        const JointRule& rule = joints_[k];
        if (rule.point == none) continue;
        Spot &guide = places.guides[k], &normal = places.normals[k], &tangent = places.tangents[k];
        if (!rule.touches) {
            guide = rule.is_arc ? Spot{} : faced(now(rule.turns_with).facing, rule.guide);
            normal = rule.is_arc ? unit_ * (world(rule.bodies[0], rule.locals[0]) - world(rule.bodies[1], rule.locals[1]))
                                 : quarter_turn(guide);
            continue;
        }
        if (rule.turns_with != none) {
            tangent = faced(now(rule.turns_with).facing, rule.tangent);
            normal = quarter_turn(tangent);
        } else {
            const std::size_t side = rule.first_circle < 0 ? 0 : static_cast<std::size_t>(rule.first_circle);
            normal = unit_ * world(rule.bodies[side], rule.locals[side]) - places.points[at_index(rule.point)];
            tangent = -quarter_turn(normal);
        }
        if (rule.meshes) normal = faced(rule.pressure, tangent);
    }
}

Spot Positions::seen_from(BodyIndex body, const Spot& place) const {
    const BodyPlaceOf<double>& at = now(body);
    return unit_ *
           (faced(Spot{at.facing.x, -at.facing.y}, (1 / unit_) * place - at.at) + rough(bodies_[at_index(body)].reference));
}

double Positions::slid(JointIndex joint) const {
    const JointRule& rule = joints_[at_index(joint)];
    const Spot guide = faced(now(rule.turns_with).facing, rule.guide);
    const Spot apart = world(rule.bodies[0], rule.locals[0]) - world(rule.bodies[1], rule.locals[1]);
    return unit_ * dot(guide, apart) / std::hypot(guide.x, guide.y);
}

// --- exactly ------------------------------------------------------------------------------------------------------------------

/// The matrix in doubles gives some fifteen digits more of the exact excesses at every pass.
std::vector<BodyPlaceOf<Exact>> Positions::refined(const Closure& closure, const Exact& coordinate) {
    State state = here_;
    KG_ASSERT(close(state), "a position that was reached is reached again");
    write_jacobian();
    jacobian_.factor();
    set_places(here_.q);
    const int grid = closure.bits + 8;
    const auto facing = [&](const Exact& angle) { return unit_along(direction_of(Angle{angle, false}, grid), grid); };
    std::vector<Exact> q, targets;
    for (const double value : state.q) q.push_back(Exact::from_double(value));
    for (const Exact& share : exact_shares_) targets.push_back(coordinate * share);
    for (const Closure::Row& row : closure.rows)
        if (row.driver >= 0 && row.kind != Closure::Row::Kind::turns) targets[at_index(row.driver)] /= closure.unit;
    std::vector<BodyPlaceOf<Exact>> places(bodies_.size());
    const double done = std::ldexp(1, -closure.bits - 2);
    for (int pass = 0; pass < 40; ++pass) {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
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
            right_[r] = value.to_double();
        }
        jacobian_.solve(right_, delta_);
        if (largest(delta_) < done) break;
        for (std::size_t k = 0; k < q.size(); ++k) q[k] = rounded(q[k] - Exact::from_double(delta_[k]), grid);
    }
    return places;
}

}  // namespace kinegraph
