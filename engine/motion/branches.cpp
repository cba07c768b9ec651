#include "engine/motion/branches.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "engine/mechanism/rounding.hpp"
#include "engine/motion/branch_order.hpp"
#include "engine/motion/constraint_rows.hpp"

namespace kinegraph {
namespace {

using DenseRow = std::vector<Exact>;

/// The test for zero, and the maximal length of numbers.
class Arithmetic {
public:
    /// On rounded data the numbers here, all of order one, have an error of a few hundred times the share of the size.
    explicit Arithmetic(const Pose& pose)
        : exact_(pose.exact && !pose.is_rounded()), nothing_(Exact::power_of_two(-60)) {
        constexpr int times = 256;
        if (pose.is_rounded()) nothing_ = std::max(nothing_, times * pose.precision / pose.size);
    }
    bool is_exact() const { return exact_; }
    bool is_zero(const Exact& value) const { return exact_ ? value.is_zero() : abs(value) < nothing_; }
    bool is_nearly_zero(const Exact& value) const { return abs(value) < nothing_; }
    Exact trimmed(const Exact& value) const { return exact_ ? value : rounded(value, 400); }

private:
    bool exact_;
    Exact nothing_;
};

/// The second-order terms of constraints, with lengths in units of the drawing's size, relative to its first point.
class SecondOrderTerms {
public:
    SecondOrderTerms(const Mechanism& mechanism, const Pose& pose) : mechanism_(mechanism), pose_(pose) {}

    Vector place(PointIndex point) const {
        const Vector from = pose_.at(point) - pose_.points.front();
        return {from.x / pose_.size, from.y / pose_.size};
    }

    /// q of the row: its time derivative is (row) · a + q(u) = 0, a the accelerations of the bodies' points at the
    /// origin.
    std::optional<Exact> quadratic(const ConstraintRow& row, const DenseRow& u) const {
        if (row.turn) return Exact();
        const Joint& joint = mechanism_.joint(row.joint);
        const OriginVelocity i = state(u, row.i), j = state(u, row.j);
        const Vector p = place(row.point);
        const Exact centripetal = (square(j.omega) - square(i.omega)) * dot(row.along, p);
        if (joint.pair().has_guide()) {
            const Vector sliding = velocity(i, p) - velocity(j, p);
            Exact q = centripetal - 2 * j.omega * dot(row.along, quarter_turn(sliding));
            if (joint.arc != none) {
                const Vector inwards = place(joint.arc) - p;
                q -= squared_length(sliding) * dot(row.along, inwards) / squared_length(inwards);
            }
            return q;
        }
        if (!joint.pair().asks_curvatures()) return centripetal;
        const Vector& normal = pose_.normals[at_index(row.joint)];
        const auto along = normal_difference(joint, u, normal);
        if (!along) return std::nullopt;
        return centripetal - *along * dot(row.along, normal) / squared_length(normal);
    }

private:
    OriginVelocity state(const DenseRow& u, BodyIndex body) const {
        if (body == frame) return {};
        const std::size_t first = 3 * at_index(body.number() - 1);
        return {{u[first], u[first + 1]}, u[first + 2]};
    }

    static Vector velocity(const OriginVelocity& state, const Vector& at) {
        return state.v + state.omega * quarter_turn(at);
    }

    /// Centre of curvature of a profile at the contact; a tip is its own centre. Empty for a line; sets `known` to
    /// false where the file gives no profile.
    std::optional<Vector> centre(const Joint& joint, BodyIndex body, bool& known) const {
        const auto profile = joint.profiles.find(body);
        known = profile != joint.profiles.end();
        if (!known) return std::nullopt;
        if (const auto* circle = std::get_if<CircleProfile>(&profile->second)) return place(circle->centre);
        if (std::holds_alternative<TipProfile>(profile->second)) return place(joint.point);
        return std::nullopt;
    }

    /// For two profiles in contact: n · (a_i(P) − a_j(P)) of the material points at P, by the equivalent linkage
    /// through the centres of curvature. Empty where data are missing.
    std::optional<Exact> normal_difference(const Joint& joint, const DenseRow& u, const Vector& normal) const {
        const BodyIndex i = joint.bodies[0], j = joint.bodies[1];
        bool known_i = false, known_j = false;
        const auto c_i = centre(joint, i, known_i), c_j = centre(joint, j, known_j);
        if (!known_i || !known_j || (!c_i && !c_j)) return std::nullopt;
        const OriginVelocity s_i = state(u, i), s_j = state(u, j);
        const Vector p = place(joint.point);
        if (c_i && c_j) {
            // |C_i C_j| is constant: d·(a(C_i) − a(C_j)) = −|v(C_i) − v(C_j)|²
            const Vector d = *c_i - *c_j;
            if (d.is_zero()) return std::nullopt;
            const Exact along = -squared_length(velocity(s_i, *c_i) - velocity(s_j, *c_j)) +
                                square(s_i.omega) * dot(d, *c_i - p) - square(s_j.omega) * dot(d, *c_j - p);
            return along * dot(normal, d) / squared_length(d);
        }
        // The centre keeps its distance from a line of the other body: a pin in a slot, shifted.
        const bool first = c_i.has_value();
        const OriginVelocity& round = first ? s_i : s_j;
        const OriginVelocity& flat = first ? s_j : s_i;
        const Vector& c = first ? *c_i : *c_j;
        const Vector sliding = velocity(round, c) - velocity(flat, c);
        const Exact along = 2 * flat.omega * dot(normal, quarter_turn(sliding)) +
                            (square(round.omega) - square(flat.omega)) * dot(normal, c - p);
        return first ? along : -along;
    }

    const Mechanism& mechanism_;
    const Pose& pose_;
};

/// The space of velocities and its second order, with lengths in units of the drawing's size, relative to its middle.
class Analysis {
public:
    /// `leader`: the analysis of the same mechanism on another drawing, whose pivots are reused.
    Analysis(const Mechanism& mechanism, const Pose& pose, const Analysis* leader = nullptr)
        : mechanism_(mechanism),
          pose_(pose),
          terms_(mechanism, pose),
          arithmetic_(pose),
          columns_(3 * (static_cast<int>(mechanism.bodies.size()) - 1)),
          rows_(constraint_rows(mechanism, pose)) {
        for (ConstraintRow& row : rows_) {
            const Exact largest = std::max(abs(row.along.x), abs(row.along.y));
            if (!largest.is_zero()) row.along = {row.along.x / largest, row.along.y / largest};
        }
        eliminate(leader);
        if (pose.is_rounded())
            for (const ShiftedDrawing& each : *pose.shifted) shifted_.emplace_back(each.mechanism, each.pose, this);
    }

    InstantMotion result(int freedoms) const {
        InstantMotion motion;
        motion.freedoms = static_cast<int>(velocities_.size());
        if (motion.freedoms != freedoms) {
            motion.freedoms = freedoms;
            motion.second_order = InstantMotion::SecondOrder::open;
            return motion;
        }
        for (const BodyIndex body : mechanism_.moving_bodies()) {
            const auto rests = [&](int from, int to) {
                return std::all_of(velocities_.begin(), velocities_.end(), [&](const DenseRow& u) {
                    const auto first =
                        u.begin() + static_cast<DenseRow::difference_type>(3 * at_index(body.number() - 1));
                    return std::all_of(first + from, first + to,
                                       [&](const Exact& value) { return arithmetic_.is_zero(value); });
                });
            };
            if (rests(0, 3)) {
                motion.still.push_back(body);
            } else if (rests(2, 3)) {
                motion.unturning.push_back(body);
            }
        }
        if (!stresses_.empty() && freedoms > 0) second_order(motion);
        return motion;
    }

private:
    /// Gauss–Jordan on [J | 1]: rows that vanish give the states of self-stress, the pivots the null space.
    void eliminate(const Analysis* leader) {
        const std::size_t columns = at_index(columns_), count = rows_.size();
        std::vector<std::pair<std::size_t, DenseRow>> kept;
        for (std::size_t i = 0; i < count; ++i) {
            DenseRow row = coefficients(rows_[i]);
            row.resize(columns + count);
            row[columns + i] = 1;
            for (const auto& [pivot, other] : kept) subtract(row, pivot, other);
            pivots_.push_back(leader != nullptr ? leader->pivots_[i] : pivot_of(row));
            const std::size_t pivot = pivots_.back().value_or(0);
            if (!pivots_.back()) {
                stresses_.emplace_back(row.begin() + static_cast<std::ptrdiff_t>(columns), row.end());
                continue;
            }
            const Exact scale = row[pivot];
            for (Exact& entry : row)
                if (!entry.is_zero()) entry = arithmetic_.trimmed(entry / scale);
            for (auto& [unused, other] : kept) subtract(other, pivot, row);
            kept.emplace_back(pivot, std::move(row));
        }
        std::vector<bool> is_pivot(columns);
        for (const auto& each : kept) is_pivot[each.first] = true;
        for (std::size_t free = 0; free < columns; ++free) {
            if (is_pivot[free]) continue;
            DenseRow u(columns);
            u[free] = 1;
            for (const auto& [pivot, row] : kept) u[pivot] = -row[free];
            velocities_.push_back(std::move(u));
        }
    }
    /// The largest of a row's coefficients; none where the row vanishes.
    std::optional<std::size_t> pivot_of(const DenseRow& row) const {
        const auto smaller = [](const Exact& a, const Exact& b) { return abs(a) < abs(b); };
        const auto pivot = std::max_element(row.begin(), row.begin() + columns_, smaller);
        if (columns_ == 0 || arithmetic_.is_zero(*pivot)) return std::nullopt;
        return static_cast<std::size_t>(pivot - row.begin());
    }
    /// `column`: the column of `from` with the factor, read before the row changes.
    void subtract(DenseRow& from, std::size_t column, const DenseRow& other) const {
        const Exact factor = from[column];
        if (factor.is_zero()) return;
        for (std::size_t k = 0; k < from.size(); ++k)
            if (!other[k].is_zero()) from[k] = arithmetic_.trimmed(from[k] - factor * other[k]);
    }

    DenseRow coefficients(const ConstraintRow& row) const {
        DenseRow entries(at_index(columns_));
        const auto add = [&](BodyIndex body, int sign) {
            if (body == frame) return;
            const std::size_t first = 3 * at_index(body.number() - 1);
            if (row.turn) {
                entries[first + 2] += sign;
                return;
            }
            entries[first] += sign * row.along.x;
            entries[first + 1] += sign * row.along.y;
            entries[first + 2] += sign * cross(terms_.place(row.point), row.along);
        };
        add(row.i, 1);
        add(row.j, -1);
        return entries;
    }

    /// s·q(u); empty where a row with a nonzero factor in s has no second order.
    std::optional<Exact> stress_times_quadratic(const DenseRow& stress, const DenseRow& u) const {
        Exact sum;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            if (arithmetic_.is_zero(stress[i])) continue;
            const auto q = terms_.quadratic(rows_[i], u);
            if (!q) return std::nullopt;
            sum = arithmetic_.trimmed(sum + stress[i] * *q);
        }
        return sum;
    }

    /// Its coefficients on the basis: of x_a x_b for a ≤ b, in order.
    std::optional<DenseRow> form(const DenseRow& stress) const {
        const std::size_t k = velocities_.size();
        DenseRow squares;
        for (const DenseRow& u : velocities_) {
            auto value = stress_times_quadratic(stress, u);
            if (!value) return std::nullopt;
            squares.push_back(std::move(*value));
        }
        DenseRow coefficients;
        for (std::size_t a = 0; a < k; ++a) {
            for (std::size_t b = a; b < k; ++b) {
                if (a == b) {
                    coefficients.push_back(squares[a]);
                    continue;
                }
                DenseRow sum = velocities_[a];
                for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += velocities_[b][c];
                const auto both = stress_times_quadratic(stress, sum);
                if (!both) return std::nullopt;
                coefficients.push_back(*both - squares[a] - squares[b]);
            }
        }
        return coefficients;
    }

    /// For the stress of this index. On rounded data also true where their precision explains every coefficient.
    bool vanishes(const DenseRow& form_here, std::size_t stress) const {
        std::vector<DenseRow> elsewhere;
        for (const Analysis& each : shifted_)
            if (auto found = each.form(each.stresses_[stress])) elsewhere.push_back(*std::move(found));
        for (std::size_t i = 0; i < form_here.size(); ++i) {
            if (arithmetic_.is_zero(form_here[i])) continue;
            std::vector<Vector> shifted;
            for (const DenseRow& each : elsewhere) shifted.push_back({each[i], 0});
            if (!is_zero_within({form_here[i], 0}, shifted)) return false;
        }
        return true;
    }

    void second_order(InstantMotion& motion) const {
        std::vector<DenseRow> forms;
        for (std::size_t s = 0; s < stresses_.size(); ++s) {
            auto found = form(stresses_[s]);
            if (!found) {
                motion.second_order = InstantMotion::SecondOrder::open;
                return;
            }
            if (!vanishes(*found, s)) forms.push_back(std::move(*found));
        }
        motion.conditions = static_cast<int>(forms.size());
        using SecondOrder = InstantMotion::SecondOrder;
        if (forms.empty()) {
            motion.second_order = SecondOrder::free;
        } else if (velocities_.size() == 1) {
            motion.second_order = SecondOrder::impossible;
        } else if (velocities_.size() > 2) {
            motion.second_order = SecondOrder::open;
        } else {
            put_in_order(common_roots(forms), motion.branches);
            motion.second_order = motion.branches.empty() ? SecondOrder::impossible : SecondOrder::branches;
        }
    }

    /// A direction x u₁ + y u₂.
    struct Root {
        Exact x, y;
        bool exact = true;
    };

    /// The directions in which A x² + B x y + C y² vanishes for every form.
    std::vector<Root> common_roots(const std::vector<DenseRow>& forms) const {
        std::vector<Root> roots;
        for (Root& root : roots_of(forms.front())) {
            const bool common = std::all_of(forms.begin() + 1, forms.end(), [&](const DenseRow& form) {
                const Exact value = form[0] * square(root.x) + form[1] * root.x * root.y + form[2] * square(root.y);
                // An irrational root is known to 2^-200.
                return root.exact ? arithmetic_.is_zero(value) : arithmetic_.is_nearly_zero(value);
            });
            if (common) roots.push_back(std::move(root));
        }
        return roots;
    }
    std::vector<Root> roots_of(const DenseRow& form) const {
        const Exact &a = form[0], &b = form[1], &c = form[2];
        if (arithmetic_.is_zero(a)) {
            std::vector<Root> roots{{1, 0}};
            if (!arithmetic_.is_zero(b)) roots.push_back({-c, b});
            return roots;
        }
        const Exact discriminant = square(b) - 4 * a * c;
        if (arithmetic_.is_zero(discriminant)) return {{-b, 2 * a}};
        if (discriminant.sign() < 0) return {};
        constexpr int bits = 200;
        const auto root = square_root(discriminant, bits);
        const bool exact = root.leftover.is_zero();
        return {{root.value - b, 2 * a, exact}, {-root.value - b, 2 * a, exact}};
    }

    void put_in_order(const std::vector<Root>& roots, std::vector<Branch>& branches) const {
        std::vector<std::pair<BranchRank, Branch>> ranked;
        for (const Root& root : roots) {
            std::vector<OriginVelocity> velocities(mechanism_.bodies.size());
            const auto sum = [&](std::size_t column) {
                return root.x * velocities_[0][column] + root.y * velocities_[1][column];
            };
            for (std::size_t body = 1; body < velocities.size(); ++body) {
                const std::size_t first = 3 * (body - 1);
                velocities[body] = {{sum(first), sum(first + 1)}, sum(first + 2)};
            }
            ranked.emplace_back(rank_of_branch(mechanism_, pose_, velocities), branch(root, velocities));
        }
        std::stable_sort(ranked.begin(), ranked.end(),
                         [](const auto& a, const auto& b) { return comes_before(a.first, b.first); });
        for (auto& each : ranked) branches.push_back(std::move(each.second));
    }

    Branch branch(const Root& root, const std::vector<OriginVelocity>& velocities) const {
        std::vector<Exact> omega;
        for (const OriginVelocity& each : velocities) omega.push_back(each.omega);
        Branch branch;
        const auto turns = [&](BodyIndex body) { return body > frame && !arithmetic_.is_zero(omega[at_index(body)]); };
        for (const Driver& driver : mechanism_.drivers) {
            const auto* spin = std::get_if<SpinDriver>(&driver);
            if (spin != nullptr && spin->relative_to == frame && branch.reference == none && turns(spin->body))
                branch.reference = spin->body;
        }
        if (branch.reference == none) {
            const auto by_name = [&](BodyIndex a, BodyIndex b) {
                return name_comes_before(mechanism_.body(a).name, mechanism_.body(b).name);
            };
            for (const BodyIndex body : mechanism_.moving_bodies())
                if (turns(body) && (branch.reference == none || by_name(body, branch.reference)))
                    branch.reference = body;
        }
        if (branch.reference == none) return branch;
        for (const Exact& each : omega) {
            const Exact ratio = arithmetic_.is_zero(each) ? Exact() : each / omega[at_index(branch.reference)];
            branch.ratios.push_back(ratio.to_double());
            if (root.exact && arithmetic_.is_exact()) branch.exact.push_back(ratio);
        }
        return branch;
    }

    const Mechanism& mechanism_;
    const Pose& pose_;
    SecondOrderTerms terms_;
    Arithmetic arithmetic_;
    int columns_;
    std::vector<ConstraintRow> rows_;
    std::vector<std::optional<std::size_t>> pivots_;  ///< by row; none where it depends on those before
    std::vector<Analysis> shifted_;                   ///< on the shifted drawings of rounded data, with the same pivots
    std::vector<DenseRow> velocities_;                ///< a basis of the null space
    std::vector<DenseRow> stresses_;                  ///< a basis of the left null space
};

}  // namespace

InstantMotion instant_motion_of(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility) {
    return Analysis(mechanism, pose).result(mobility.effective);
}

}  // namespace kinegraph
