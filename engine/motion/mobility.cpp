// Counts freedoms: Grübler's formula from the kinds of joints, and the rank of their constraints at this pose, joint by
// joint, so that redundant ones are named. The constraints are templates over a field: residues modulo a large prime
// where the pose is exact, 512-bit reals where roots were taken or data are rounded. Velocities are not computed.
#include "engine/motion/mobility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "engine/mechanism/rounding.hpp"
#include "engine/motion/constraint_rows.hpp"
#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {

// --- two fields
// ----------------------------------------------------------------------------------------------------------------

/// Integers modulo a prime p < 2^61. The rank modulo p is never above the true one, and is below it only if p divides a
/// minor: probability about 2^-60 for one prime, negligible for two.
class Residues {
public:
    using Number = std::uint64_t;
    explicit Residues(std::uint64_t prime) : prime_(prime) {}

    /// Zero for a number whose denominator is divisible by the prime; `failed` then requests another prime (also after
    /// a division by a value that is zero modulo this prime only).
    Number from(const Exact& value) {
        const auto above = mpz_fdiv_ui(value.rational().get_num_mpz_t(), prime_);
        const auto below = mpz_fdiv_ui(value.rational().get_den_mpz_t(), prime_);
        failed_ = failed_ || below == 0;
        if (below == 1) return above;
        return below == 0 ? 0 : product(above, inverse(below));
    }
    bool failed() const { return failed_; }
    Number zero() const { return 0; }
    Number difference(Number a, Number b) const { return a >= b ? a - b : a + prime_ - b; }
    Number product(Number a, Number b) const { return static_cast<Number>(static_cast<Wide>(a) * b % prime_); }
    void divide(Number& a, Number b) {
        failed_ = failed_ || b == 0;
        a = product(a, inverse(b));
    }
    void subtract_product(Number& from, Number a, Number b) const { from = difference(from, product(a, b)); }
    /// All non-zero pivots are equally good.
    double magnitude(Number a) const { return a == 0 ? 0 : 1; }

private:
    __extension__ using Wide = unsigned __int128;
    Number inverse(Number a) const {
        // Extended Euclidean algorithm: a·x ≡ r throughout
        std::int64_t x = 1, next_x = 0;
        auto r = static_cast<std::int64_t>(a);
        auto next_r = static_cast<std::int64_t>(prime_);
        while (next_r != 0) {
            const std::int64_t q = r / next_r;
            x = std::exchange(next_x, x - q * next_x);
            r = std::exchange(next_r, r - q * next_r);
        }
        return x < 0 ? static_cast<Number>(x + static_cast<std::int64_t>(prime_)) : static_cast<Number>(x);
    }
    std::uint64_t prime_;
    bool failed_ = false;
};

/// Reals of 512 bits: five times the digits of a pose, so that a small value is due to the pose and not to rounding.
class Reals {
public:
    using Number = mpf_class;
    static constexpr mp_bitcnt_t bits = 512;

    Number from(const Exact& value) const {
        Number number(0, bits);
        mpf_set_q(number.get_mpf_t(), value.rational().get_mpq_t());
        return number;
    }
    Number zero() const { return Number(0, bits); }
    Number difference(const Number& a, const Number& b) const {
        Number result(0, bits);
        mpf_sub(result.get_mpf_t(), a.get_mpf_t(), b.get_mpf_t());
        return result;
    }
    Number product(const Number& a, const Number& b) const {
        Number result(0, bits);
        mpf_mul(result.get_mpf_t(), a.get_mpf_t(), b.get_mpf_t());
        return result;
    }
    void divide(Number& a, const Number& b) const { mpf_div(a.get_mpf_t(), a.get_mpf_t(), b.get_mpf_t()); }
    void subtract_product(Number& from, const Number& a, const Number& b) {
        mpf_mul(product_.get_mpf_t(), a.get_mpf_t(), b.get_mpf_t());
        mpf_sub(from.get_mpf_t(), from.get_mpf_t(), product_.get_mpf_t());
        // The residue of a cancellation to this depth is rounding; the error of a finer pose is at most 2^-200.
        constexpr long rounding = -400;
        long exponent = 0;
        mpf_get_d_2exp(&exponent, from.get_mpf_t());
        if (exponent < rounding) mpf_set_ui(from.get_mpf_t(), 0);
    }
    double magnitude(const Number& a) const { return std::abs(mpf_get_d(a.get_mpf_t())); }

private:
    Number product_{0, bits};
};

/// Doubles, for an estimate of the size of a reduced row.
class Doubles {
public:
    using Number = double;
    double from(const Exact& value) const { return value.to_double(); }
    double zero() const { return 0; }
    double difference(double a, double b) const { return a - b; }
    double product(double a, double b) const { return a * b; }
    void divide(double& a, double b) const { a /= b; }
    void subtract_product(double& from, double a, double b) const { from -= a * b; }
    double magnitude(double a) const { return std::abs(a); }
};

// --- the constraints
// -----------------------------------------------------------------------------------------------------------

/// Coefficients of one constraint; unknowns of body b > 0 are columns 3(b−1): v_x, v_y of the origin's place, +2: ω.
template <class Number>
using SparseRow = std::vector<std::pair<int, Number>>;

/// The owner of a row: a joint or a driver, by index; none for a given motion.
struct Owner {
    JointIndex joint = none;
    int driver = -1;
};

/// Which rows are eliminated.
struct Rows {
    bool drivers = true;  ///< those of drivers and of a given motion, after the joints'
    /// Only joints between bodies of one group, each joint within each of its groups; null: all.
    const std::vector<BodyIndex>* within = nullptr;
};

/// The joints' rows, restricted to these groups: where a joint connects more than two bodies, each is bound to the
/// first of its own group.
std::vector<ConstraintRow> rows_within(const std::vector<BodyIndex>& groups, std::vector<ConstraintRow> rows,
                                       const Mechanism& mechanism) {
    std::vector<ConstraintRow> kept;
    for (ConstraintRow& row : rows) {
        const std::vector<BodyIndex>& bodies = mechanism.joint(row.joint).bodies;
        const auto first = std::find_if(bodies.begin(), bodies.end(), [&](BodyIndex body) {
            return groups[at_index(body)] == groups[at_index(row.j)];
        });
        if (*first == row.j) continue;
        row.i = *first;
        kept.push_back(row);
    }
    return kept;
}

template <class Field>
class Constraints {
public:
    using Number = typename Field::Number;
    std::vector<SparseRow<Number>> rows;
    std::vector<Owner> owners;  ///< joints first, then drivers

    Constraints(Field& field, const Mechanism& mechanism, const Pose& pose, const Rows& asked = {})
        : field_(field), mechanism_(mechanism), pose_(pose) {
        // Lengths are relative to the first point and divided by the size, so that distance from the origin does not
        // enlarge entries.
        size_ = field.from(pose.size);
        points_.reserve(pose.points.size());
        if (!pose.points.empty()) origin_ = converted(pose.points.front());
        for (const Vector& point : pose.points) {
            Pair place = converted(point);
            for (const std::size_t k : {0U, 1U}) {
                place[k] = field.difference(place[k], origin_[k]);
                field.divide(place[k], size_);
            }
            points_.push_back(std::move(place));
        }
        std::vector<ConstraintRow> joints = constraint_rows(mechanism, pose);
        if (asked.within != nullptr) joints = rows_within(*asked.within, std::move(joints), mechanism);
        for (const ConstraintRow& row : joints) write(row);
        if (!asked.drivers) return;
        for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
            owner_ = {none, static_cast<int>(i)};
            std::visit([&](const auto& driver) { write(driver); }, mechanism.drivers[i]);
        }
        owner_ = {};
        if (mechanism.motion) write(*mechanism.motion);
    }

private:
    using Pair = std::array<Number, 2>;

    Pair converted(const Vector& a) { return {field_.from(a.x), field_.from(a.y)}; }
    /// A direction, scaled so that its larger component is one.
    Pair direction(const Vector& a) {
        KG_ASSERT(!a.is_zero(), "a constraint has a direction");
        const bool is_steep = abs(a.y) > abs(a.x);
        const Exact& largest = is_steep ? a.y : a.x;
        const Exact one = largest.sign(), other = (is_steep ? a.x : a.y) / abs(largest);
        return is_steep ? converted({other, one}) : converted({one, other});
    }

    /// Σ ± (n·v_b at the point) = 0: n·v = n_x v_x + n_y v_y + ω (P × n).
    void equal_speeds(BodyIndex i, BodyIndex j, PointIndex point, const Pair& n) {
        if (i == j) return enter({});  // an empty row
        SparseRow<Number> row;
        const Pair& place = points_[at_index(point)];
        Number moment = field_.product(place[0], n[1]);
        field_.subtract_product(moment, place[1], n[0]);
        const auto add = [&](BodyIndex body, bool negative) {
            if (body == frame) return;
            const auto signed_of = [&](const Number& value) {
                return negative ? field_.difference(field_.zero(), value) : value;
            };
            const int first = 3 * (body.number() - 1);
            row.emplace_back(first, signed_of(n[0]));
            row.emplace_back(first + 1, signed_of(n[1]));
            row.emplace_back(first + 2, signed_of(moment));
        };
        add(i, false);
        add(j, true);
        enter(std::move(row));
    }
    void equal_turns(BodyIndex i, BodyIndex j) {
        if (i == j) return enter({});
        SparseRow<Number> row;
        if (i != frame) row.emplace_back(3 * (i.number() - 1) + 2, field_.from(1));
        if (j != frame) row.emplace_back(3 * (j.number() - 1) + 2, field_.from(-1));
        enter(std::move(row));
    }
    void enter(SparseRow<Number> row) {
        rows.push_back(std::move(row));
        owners.push_back(owner_);
    }
    void pinned(BodyIndex i, BodyIndex j, PointIndex point) {
        for (const Vector& n : {Vector{1, 0}, Vector{0, 1}}) equal_speeds(i, j, point, direction(n));
    }

    void write(const ConstraintRow& row) {
        owner_ = {row.joint, -1};
        if (row.turn) {
            equal_turns(row.i, row.j);
        } else {
            equal_speeds(row.i, row.j, row.point, direction(row.along));
        }
    }
    void write(const SpinDriver& driver) { equal_turns(driver.body, driver.relative_to); }
    void write(const SlideDriver& driver) {
        const Joint& joint = mechanism_.joint(driver.joint);
        const Vector& guide = pose_.guides[at_index(driver.joint)];
        equal_speeds(joint.bodies[0], joint.bodies[1], joint.point,
                     direction(guide.is_zero() ? quarter_turn(pose_.normals[at_index(driver.joint)]) : guide));
    }
    void write(const PointDriver& driver) {
        equal_speeds(driver.body, frame, driver.at, direction(direction_of(driver.along, pose_)));
    }
    void write(const InstantaneousMotion& motion) {
        for (const GivenMotion& given : motion.velocities) {
            if (const auto* along = std::get_if<Bearing>(&given.value)) {
                equal_speeds(motion.body, frame, given.point, direction(quarter_turn(direction_of(*along, pose_))));
            } else {
                pinned(motion.body, frame, given.point);
            }
        }
    }

    Field& field_;
    const Mechanism& mechanism_;
    const Pose& pose_;
    Number size_;
    Pair origin_;
    std::vector<Pair> points_;
    Owner owner_;
};

// --- elimination
// ---------------------------------------------------------------------------------------------------------------

/// Rows reduced by the rows kept before; a kept row is scaled to one in its pivot column.
template <class Field>
class Echelon {
public:
    using Number = typename Field::Number;
    Echelon(Field& field, int columns) : field_(field), row_(at_index(columns), field.zero()) {}

    /// Takes a row and subtracts its dependence on the kept rows.
    void reduce(const SparseRow<Number>& row) {
        for (Number& entry : row_) entry = 0;
        for (const auto& [column, value] : row) row_[at_index(column)] = value;
        for (const auto& [pivot, kept] : kept_) {
            if (row_[at_index(pivot)] == 0) continue;
            std::swap(factor_, row_[at_index(pivot)]);
            row_[at_index(pivot)] = 0;
            for (const auto& [column, value] : kept) field_.subtract_product(row_[at_index(column)], factor_, value);
        }
    }
    /// The column of the largest entry of the reduced row (the first of equals), and its size; zero if the row
    /// vanishes.
    std::pair<int, double> largest() const {
        std::pair<int, double> found{-1, 0};
        for (std::size_t i = 0; i < row_.size(); ++i) {
            if (row_[i] == 0) continue;
            const double size = field_.magnitude(row_[i]);
            if (size > found.second) found = {static_cast<int>(i), size};
        }
        return found;
    }
    /// The largest difference between the reduced rows.
    double distance(const Echelon& there) const {
        double apart = 0;
        for (std::size_t i = 0; i < row_.size(); ++i)
            apart = std::max(apart, field_.magnitude(field_.difference(row_[i], there.row_[i])));
        return apart;
    }
    void keep(int pivot) {
        const Number scale = row_[at_index(pivot)];
        SparseRow<Number> kept;
        for (std::size_t i = 0; i < row_.size(); ++i) {
            if (static_cast<int>(i) == pivot || row_[i] == 0) continue;
            Number entry = row_[i];
            field_.divide(entry, scale);
            kept.emplace_back(static_cast<int>(i), std::move(entry));
        }
        kept_.emplace_back(pivot, std::move(kept));
    }
    /// A motion that the kept rows allow: the columns without a pivot have arbitrary values, always the same ones.
    std::vector<Number> free_motion() {
        std::vector<Number> motion;
        std::uint64_t state = 0;
        for (std::size_t i = 0; i < row_.size(); ++i) {
            // splitmix64: numbers in [1, 2) among which no small relation is to be expected.
            std::uint64_t bits = state += 0x9E3779B97F4A7C15U;
            bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9U;
            bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBU;
            constexpr std::int64_t one = std::int64_t{1} << 60;
            motion.push_back(field_.from(Exact::ratio(one + static_cast<std::int64_t>(bits >> 4), one)));
        }
        // A kept row has entries in its own pivot column and in those of later rows.
        for (auto kept = kept_.rbegin(); kept != kept_.rend(); ++kept) {
            Number value = field_.zero();
            for (const auto& [column, entry] : kept->second)
                field_.subtract_product(value, entry, motion[at_index(column)]);
            motion[at_index(kept->first)] = std::move(value);
        }
        return motion;
    }

private:
    Field& field_;
    std::vector<Number> row_;
    Number factor_{field_.zero()};
    std::vector<std::pair<int, SparseRow<Number>>> kept_;  ///< pivot column, and the row without its one there
};

/// Which rows add to the rank of those before them, and which bodies all rows together determine.
struct Verdict {
    std::vector<bool> independent;
    std::vector<Owner> owners;
    std::vector<bool> determined;
    std::vector<BodyIndex> rest;  ///< where drivers are left out: as RelativeRest
    bool decided_by_finer_pose = false;
    bool decided_by_precision = false;
    bool is_full = false;  ///< the rank is maximal
};

/// The motion of body i relative to body j.
template <class Field>
std::array<typename Field::Number, 3> relative(Field& field, const std::vector<typename Field::Number>& motion,
                                               BodyIndex i, BodyIndex j) {
    const auto component = [&](int k) {
        const auto of = [&](BodyIndex body) {
            return body == frame ? field.zero() : motion[at_index(3 * (body.number() - 1) + k)];
        };
        typename Field::Number value = of(i);
        field.subtract_product(value, field.from(1), of(j));  // which knows what is rounding
        return value;
    };
    return {component(0), component(1), component(2)};
}
template <class Field, class Number>
double size_of(Field& field, const std::array<Number, 3>& motion) {
    return std::max({field.magnitude(motion[0]), field.magnitude(motion[1]), field.magnitude(motion[2])});
}

/// By BodyIndex: the first body that `together(i, j)` puts into the same group.
template <class Together>
std::vector<BodyIndex> groups_of(int bodies, Together together) {
    std::vector<BodyIndex> groups, firsts;
    for (const BodyIndex body : indices<BodyIndex>(at_index(bodies))) {
        const auto first =
            std::find_if(firsts.begin(), firsts.end(), [&](BodyIndex other) { return together(other, body); });
        groups.push_back(first == firsts.end() ? body : *first);
        if (first == firsts.end()) firsts.push_back(body);
    }
    return groups;
}

/// `keep(i)`: reduces row i, keeps the result, and returns whether it is not zero. `spanned(row)`: returns whether the
/// row reduces to zero.
template <class Field, class Keep, class Spanned>
Verdict judge(Field& field, const Constraints<Field>& constraints, int bodies, const Rows& asked, Keep keep,
              Spanned spanned) {
    Verdict verdict;
    verdict.owners = constraints.owners;
    const auto one = field.from(1);
    int rank = 0;
    for (std::size_t i = 0; i < constraints.rows.size(); ++i) {
        verdict.independent.push_back(keep(i));
        if (verdict.independent.back()) ++rank;
    }
    const int columns = 3 * (bodies - 1);
    verdict.is_full = rank == columns || rank == static_cast<int>(constraints.rows.size());
    if (!asked.drivers) return verdict;
    verdict.determined.assign(at_index(bodies), true);
    for (int body = 1; body < bodies && rank < columns; ++body) {
        for (int k = 0; k < 3 && verdict.determined[at_index(body)]; ++k) {
            verdict.determined[at_index(body)] = spanned({{3 * (body - 1) + k, one}});
        }
    }
    return verdict;
}

std::optional<Verdict> judge_exactly(const Mechanism& mechanism, const Pose& pose, const Rows& asked,
                                     std::uint64_t prime) {
    Residues field(prime);
    const Constraints<Residues> constraints(field, mechanism, pose, asked);
    if (field.failed()) return std::nullopt;
    const auto bodies = static_cast<int>(mechanism.bodies.size());
    Echelon<Residues> echelon(field, 3 * (bodies - 1));
    const auto keep = [&](std::size_t i) {
        echelon.reduce(constraints.rows[i]);
        const int pivot = echelon.largest().first;
        if (pivot >= 0) echelon.keep(pivot);
        return pivot >= 0;
    };
    const auto spanned = [&](const SparseRow<std::uint64_t>& row) {
        echelon.reduce(row);
        return echelon.largest().first < 0;
    };
    Verdict verdict = judge(field, constraints, bodies, asked, keep, spanned);
    if (asked.drivers) return verdict;
    const std::vector<std::uint64_t> motion = echelon.free_motion();
    verdict.rest =
        groups_of(bodies, [&](BodyIndex i, BodyIndex j) { return size_of(field, relative(field, motion, i, j)) == 0; });
    return verdict;
}

Verdict judge_exactly(const Mechanism& mechanism, const Pose& pose, const Rows& asked) {
    // The largest primes below 2^61.
    constexpr std::array<std::uint64_t, 6> primes{2305843009213693951U, 2305843009213693921U, 2305843009213693907U,
                                                  2305843009213693723U, 2305843009213693693U, 2305843009213693669U};
    std::optional<Verdict> best;
    int looks = 0;
    for (const std::uint64_t prime : primes) {
        auto verdict = judge_exactly(mechanism, pose, asked, prime);
        if (!verdict) continue;
        const auto rank = [](const Verdict& v) { return std::count(v.independent.begin(), v.independent.end(), true); };
        if (!best || rank(*verdict) > rank(*best)) best = std::move(verdict);
        if (best->is_full || ++looks == 2) break;
    }
    KG_ASSERT(best, "six primes do not all divide the denominators of one drawing");
    return *std::move(best);
}

/// On an inexact pose. Once a pivot is small enough to be an error of the pose, a finer pose is reduced in parallel: a
/// value that shrinks with the pose is zero, one that stays is not. Empty where the finer pose is needed and not given.
std::optional<Verdict> judge_in_reals(const Mechanism& mechanism, const Pose& pose, const Rows& asked,
                                      const Pose* finer) {
    const double suspicious = std::ldexp(1, -pose.bits * 2 / 5);
    const double shrinks = std::ldexp(1, -pose.bits / 2);
    Reals field;
    const auto bodies = static_cast<int>(mechanism.bodies.size());
    const Constraints<Reals> rows(field, mechanism, pose, asked);
    Echelon<Reals> echelon(field, 3 * (bodies - 1));
    std::optional<Constraints<Reals>> finer_rows;
    Echelon<Reals> finer_echelon(field, 3 * (bodies - 1));
    if (finer != nullptr) finer_rows.emplace(field, mechanism, *finer, asked);
    bool needs_finer = false;
    bool decided = false;

    // Reduces in both; returns the pivot column, or −1 where the result is zero.
    const auto left_of = [&](const SparseRow<mpf_class>& row, const SparseRow<mpf_class>& finer_row) {
        echelon.reduce(row);
        const auto [pivot, size] = echelon.largest();
        if (finer != nullptr) finer_echelon.reduce(finer_row);
        if (pivot < 0 || size > suspicious) return pivot;
        if (finer == nullptr) {
            needs_finer = true;
            return -1;
        }
        if (finer_echelon.largest().second > shrinks * size) return pivot;
        decided = true;
        return -1;
    };
    const auto keep = [&](std::size_t i) {
        if (needs_finer) return false;
        const int pivot = left_of(rows.rows[i], finer_rows ? finer_rows->rows[i] : rows.rows[i]);
        if (pivot < 0) return false;
        echelon.keep(pivot);
        if (finer != nullptr) finer_echelon.keep(pivot);
        return true;
    };
    const auto spanned = [&](const SparseRow<mpf_class>& row) { return needs_finer || left_of(row, row) < 0; };
    Verdict verdict = judge(field, rows, bodies, asked, keep, spanned);
    if (!asked.drivers && !needs_finer) {
        const std::vector<mpf_class> motion = echelon.free_motion();
        const std::vector<mpf_class> finer_motion = finer != nullptr ? finer_echelon.free_motion() : motion;
        verdict.rest = groups_of(bodies, [&](BodyIndex i, BodyIndex j) {
            const double size = size_of(field, relative(field, motion, i, j));
            if (size == 0 || size > suspicious) return size == 0;
            needs_finer = needs_finer || finer == nullptr;
            return size_of(field, relative(field, finer_motion, i, j)) <= shrinks * size;
        });
    }
    if (needs_finer) return std::nullopt;
    verdict.decided_by_finer_pose = decided;
    return verdict;
}

Verdict judge_in_reals(const Mechanism& mechanism, const Pose& pose, const Rows& asked, const FinerPose& given) {
    if (auto verdict = judge_in_reals(mechanism, pose, asked, nullptr)) return *std::move(verdict);
    // A drawing that closes at 100 bits and not at 200 depends on a coincidence of its numbers; then nothing shrinks.
    const Result<Pose> finer = given ? Result<Pose>(given()) : draw_pose(mechanism, 2 * pose.bits);
    auto verdict = judge_in_reals(mechanism, pose, asked, finer ? &*finer : &pose);
    KG_ASSERT(verdict, "a finer pose decides every pivot");
    return *std::move(verdict);
}

/// How large the relative motion of two bodies is in the given drawing, and how far the shifted ones change it.
std::pair<double, double> relative_size(Reals& field, const std::vector<std::vector<mpf_class>>& motions, BodyIndex i,
                                        BodyIndex j) {
    const auto here = relative(field, motions.front(), i, j);
    double spread = 0;
    for (const auto& motion : motions) {
        const auto there = relative(field, motion, i, j);
        for (std::size_t k = 0; k < here.size(); ++k)
            spread = std::max(spread, field.magnitude(field.difference(here[k], there[k])));
    }
    return {size_of(field, here), spread};
}

/// On rounded data, in parallel with the shifted drawings: a reduced row is zero if the precision explains it. A row
/// above bits_in_question is never zero.
Verdict judge_within_precision(const Mechanism& mechanism, const Pose& pose, const Rows& asked) {
    Reals field;
    const auto bodies = static_cast<int>(mechanism.bodies.size());
    struct Elimination {
        Constraints<Reals> rows;
        Echelon<Reals> echelon;
    };
    std::vector<Elimination> all;
    all.reserve(pose.shifted->size() + 1);
    const auto add = [&](const Mechanism& drawn, const Pose& as) {
        all.push_back({Constraints<Reals>(field, drawn, as, asked), Echelon<Reals>(field, 3 * (bodies - 1))});
    };
    add(mechanism, pose);
    for (const ShiftedDrawing& each : *pose.shifted) add(each.mechanism, each.pose);
    Elimination& given = all.front();
    const double in_question = std::ldexp(1, -bits_in_question(pose.rounding()));
    bool decided = false;

    // Whether a value of this size is zero, since the shifts change it by so much.
    const auto vanishes = [&](double size, double spread) {
        const bool finer = !pose.exact && size < std::ldexp(1, -pose.bits * 2 / 5);
        return size <= in_question && (is_zero_within(size, spread) || finer);
    };
    // The pivot column, or −1 where the result is zero. `row(i)` is that of the i-th drawing.
    const auto left_of = [&](auto row) {
        for (Elimination& each : all) each.echelon.reduce(row(each));
        const auto [pivot, size] = given.echelon.largest();
        if (pivot < 0 || size > in_question) return pivot;
        double spread = 0;
        for (std::size_t k = 1; k < all.size(); ++k) spread = std::max(spread, given.echelon.distance(all[k].echelon));
        if (!vanishes(size, spread)) return pivot;
        decided = true;
        return -1;
    };
    const auto keep = [&](std::size_t i) {
        const int pivot = left_of([&](const Elimination& each) -> const auto& { return each.rows.rows[i]; });
        if (pivot < 0) return false;
        for (Elimination& each : all) each.echelon.keep(pivot);
        return true;
    };
    const auto spanned = [&](const SparseRow<mpf_class>& row) {
        return left_of([&](const Elimination&) -> const auto& { return row; }) < 0;
    };
    Verdict verdict = judge(field, given.rows, bodies, asked, keep, spanned);
    verdict.decided_by_precision = decided;
    if (asked.drivers) return verdict;
    std::vector<std::vector<mpf_class>> motions;
    for (Elimination& each : all) motions.push_back(each.echelon.free_motion());
    verdict.rest = groups_of(bodies, [&](BodyIndex i, BodyIndex j) {
        const auto [size, spread] = relative_size(field, motions, i, j);
        return size == 0 || (size <= in_question && vanishes(size, spread));
    });
    return verdict;
}

Verdict judge(const Mechanism& mechanism, const Pose& pose, const Rows& asked, const FinerPose& finer) {
    if (pose.is_rounded()) return judge_within_precision(mechanism, pose, asked);
    return pose.exact ? judge_exactly(mechanism, pose, asked) : judge_in_reals(mechanism, pose, asked, finer);
}

void count_joints(const Mechanism& mechanism, Mobility& mobility) {
    for (const Joint& joint : mechanism.joints) {
        const int freedoms = joint.pair().freedoms();
        int& count = freedoms == 0 ? mobility.welds : freedoms == 1 ? mobility.class_1 : mobility.class_2;
        count += static_cast<int>(joint.bodies.size()) - 1;
    }
    mobility.bodies = static_cast<int>(mechanism.bodies.size());
    mobility.gruebler = 3 * (mobility.bodies - 1) - 2 * mobility.class_1 - mobility.class_2 - 3 * mobility.welds;
}

}  // namespace

int Mobility::repeated() const {
    int rows = 0;
    for (const Redundant& each : redundant) rows += each.rows;
    return rows;
}

Mobility::Verdict Mobility::verdict() const {
    if (effective == 0) return redundant.empty() ? Verdict::isostatic : Verdict::hyperstatic;
    return gruebler > 0 ? Verdict::mechanism : Verdict::labile;
}

const char* name_of(Mobility::Verdict verdict) {
    switch (verdict) {
        case Mobility::Verdict::mechanism: return "mechanism";
        case Mobility::Verdict::isostatic: return "isostatic";
        case Mobility::Verdict::hyperstatic: return "hyperstatic";
        case Mobility::Verdict::labile: break;
    }
    return "labile";
}

Mobility mobility_of(const Mechanism& mechanism, const Pose& pose, const FinerPose& finer) {
    Mobility mobility;
    count_joints(mechanism, mobility);
    Verdict verdict = judge(mechanism, pose, {}, finer);
    int rank = 0;
    for (std::size_t i = 0; i < verdict.owners.size(); ++i) {
        const auto [joint, driver] = verdict.owners[i];
        if (verdict.independent[i]) {
            ++(joint != none ? rank : mobility.driven);
        } else if (joint != none) {
            auto& redundant = mobility.redundant;
            if (redundant.empty() || redundant.back().joint != joint) redundant.push_back({joint, 0});
            ++redundant.back().rows;
        } else if (driver >= 0) {
            mobility.idle_drivers.push_back(driver);
        }
    }
    mobility.effective = 3 * (mobility.bodies - 1) - rank;
    mobility.determined = std::move(verdict.determined);
    mobility.decided_by_finer_pose = verdict.decided_by_finer_pose;
    mobility.decided_by_precision = verdict.decided_by_precision;
    return mobility;
}

RelativeRest relative_rest(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility,
                           const FinerPose& finer) {
    RelativeRest rest;
    if (mobility.effective == 0) {
        rest.here.assign(mechanism.bodies.size(), frame);
        rest.always = rest.here;
        return rest;
    }
    rest.here = judge(mechanism, pose, {.drivers = false}, finer).rest;
    const bool all_move = std::is_sorted(rest.here.begin(), rest.here.end()) &&
                          std::adjacent_find(rest.here.begin(), rest.here.end()) == rest.here.end();
    rest.always = all_move ? rest.here : judge(mechanism, pose, {.drivers = false, .within = &rest.here}, finer).rest;
    return rest;
}

std::vector<JointIndex> nearly_redundant_joints(const Mechanism& mechanism, const Pose& pose,
                                                const Mobility& mobility) {
    constexpr double nearly = 1e-3, rounding = 1e-13;
    Doubles field;
    const Constraints<Doubles> constraints(field, mechanism, pose);
    Echelon<Doubles> echelon(field, 3 * (static_cast<int>(mechanism.bodies.size()) - 1));
    std::vector<JointIndex> found;
    for (std::size_t i = 0; i < constraints.rows.size(); ++i) {
        const JointIndex joint = constraints.owners[i].joint;
        if (joint == none) continue;
        echelon.reduce(constraints.rows[i]);
        const auto [pivot, size] = echelon.largest();
        const bool is_redundant = std::any_of(mobility.redundant.begin(), mobility.redundant.end(),
                                              [&](const Mobility::Redundant& each) { return each.joint == joint; });
        if (size < nearly && !is_redundant && (found.empty() || found.back() != joint)) found.push_back(joint);
        if (size > rounding) echelon.keep(pivot);
    }
    return found;
}

}  // namespace kinegraph
