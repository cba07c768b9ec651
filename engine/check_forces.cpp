// Writes the equilibrium of every body as linear equations in doubles and solves them with Eigen. Owns the model of each pair's
// reaction and the rule that picks a gear's line of action; shares nothing with the constructions but Mechanism and Pose.
//
// Unknowns: the components of the reactions (revolute, rolling: two; prismatic: force ⟂ guide and couple; pin-slot, contact,
// gear: force along the normal; weld: two and a couple) and the efforts. Equations, for each body but the frame:
//   Σ F = 0,      Σ (P − R) × F + Σ M = 0      about its reference R,
// weights, springs, distributed loads (by Simpson's rule) and −m a_G, −J_G α among the loads. At a hinge of three bodies or more
// each body meets a massless pin, which adds its own Σ F = 0. Forces are counted in units of the largest load, moments over the
// body's own size.
#include "engine/check_forces.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/assert.hpp"

namespace kinegraph {
namespace {

using Pair = std::array<double, 2>;
using Eigen::Index;

double inner(const Pair& a, const Pair& b) { return a[0] * b[0] + a[1] * b[1]; }
double outer(const Pair& a, const Pair& b) { return a[0] * b[1] - a[1] * b[0]; }
Pair operator*(double s, const Pair& a) { return {s * a[0], s * a[1]}; }
Pair operator+(const Pair& a, const Pair& b) { return {a[0] + b[0], a[1] + b[1]}; }
Pair quarter(const Pair& a) { return {-a[1], a[0]}; }
Pair rough(const Vector& a) { return {a.x.to_double(), a.y.to_double()}; }
double largest(const Eigen::VectorXd& a) { return a.size() == 0 ? 0 : a.cwiseAbs().maxCoeff(); }

/// No smaller pivot can be told from a redundant constraint: a point may miss its curve by 1e-9 of the size.
constexpr double rank_threshold = 1e-9;
/// What is smaller, relative to the largest force, is taken for nothing.
constexpr double least_nothing = 1e-8;

/// A x = b in the least-squares sense, with refinement in long double, and what of x the equations determine.
class Solver {
public:
    /// `doubt`: how far rounded points may move a pivot.
    Solver(const Eigen::MatrixXd& matrix, double doubt)
        : matrix_(matrix), scale_(Eigen::VectorXd::Ones(matrix.cols())), nothing_(std::max(least_nothing, doubt)) {
        if (is_empty()) return;
        for (Index j = 0; j < matrix_.cols(); ++j) {
            const double size = matrix_.col(j).cwiseAbs().maxCoeff();
            if (size > 0) scale_[j] = 1 / size;
        }
        matrix_ = matrix_ * scale_.asDiagonal();
        orthogonal_.setThreshold(std::max(rank_threshold, doubt));
        orthogonal_.compute(matrix_);
    }

    Index rank() const { return is_empty() ? 0 : orthogonal_.rank(); }

    Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
        if (is_empty()) return Eigen::VectorXd::Zero(matrix_.cols());
        Eigen::VectorXd x = particular(right);
        constexpr int refinements = 2;
        for (int i = 0; i < refinements; ++i) x += particular(scaled_residual(right, x));
        return scale_.cwiseProduct(x);
    }
    /// b − A x.
    Eigen::VectorXd residual(const Eigen::VectorXd& right, const Eigen::VectorXd& x) const {
        return scaled_residual(right, x.cwiseQuotient(scale_));
    }
    /// A basis of the null space, a column each, of unknowns brought to one size: how an equilibrium may differ from another.
    Eigen::MatrixXd null_space() const {
        const Index columns = matrix_.cols();
        const Index free = columns - rank();
        if (free == 0) return Eigen::MatrixXd::Zero(columns, 0);
        if (free == columns) return Eigen::MatrixXd::Identity(columns, columns);
        const auto& qr = orthogonal_.matrixQR();
        Eigen::MatrixXd null(columns, free);
        null.topRows(rank()) =
            -qr.topLeftCorner(rank(), rank()).triangularView<Eigen::Upper>().solve(qr.topRightCorner(rank(), free)).eval();
        null.bottomRows(free).setIdentity();
        null = orthogonal_.colsPermutation() * null;
        for (Index j = 0; j < free; ++j) null.col(j).normalize();
        return null;
    }
    /// By unknown: no vector of the null space moves it.
    std::vector<bool> determined() const {
        const Eigen::MatrixXd null = null_space();
        std::vector<bool> known(static_cast<std::size_t>(matrix_.cols()), true);
        for (Index i = 0; i < matrix_.cols() && null.cols() > 0; ++i)
            known[static_cast<std::size_t>(i)] = null.row(i).cwiseAbs().maxCoeff() < nothing_;
        return known;
    }
    /// Of two unknowns the one combination that no vector of the null space moves, of unit length; none: there is none, or both
    /// stand.
    std::optional<Pair> common_direction(Index first) const {
        const Eigen::MatrixXd null = null_space();
        if (null.cols() == 0) return std::nullopt;
        Eigen::MatrixXd of_two = null.middleRows(first, 2);
        for (Index i = 0; i < 2; ++i) of_two.row(i) *= scale_[first + i];
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(of_two, Eigen::ComputeFullU);
        const auto& sizes = svd.singularValues();
        const double least = sizes.size() > 1 ? sizes[1] : 0;
        const double all = null.cwiseAbs().maxCoeff() * std::max(scale_[first], scale_[first + 1]);
        if (sizes[0] < nothing_ * all || least > nothing_ * all) return std::nullopt;
        Pair along{svd.matrixU()(0, 1), svd.matrixU()(1, 1)};
        if (along[0] < -nothing_ || (std::abs(along[0]) <= nothing_ && along[1] < 0)) along = -1 * along;
        return along;
    }

private:
    bool is_empty() const { return matrix_.rows() == 0 || matrix_.cols() == 0; }
    Eigen::VectorXd scaled_residual(const Eigen::VectorXd& right, const Eigen::VectorXd& x) const {
        Eigen::VectorXd miss(right.size());
        for (Index i = 0; i < matrix_.rows(); ++i) {
            long double sum = right[i];
            for (Index j = 0; j < matrix_.cols(); ++j) sum -= static_cast<long double>(matrix_(i, j)) * x[j];
            miss[i] = static_cast<double>(sum);
        }
        return miss;
    }
    /// A solution with zero for the unknowns that are free.
    Eigen::VectorXd particular(const Eigen::VectorXd& right) const {
        const Eigen::VectorXd turned = orthogonal_.householderQ().transpose() * right;
        Eigen::VectorXd x = Eigen::VectorXd::Zero(matrix_.cols());
        x.head(rank()) =
            orthogonal_.matrixQR().topLeftCorner(rank(), rank()).triangularView<Eigen::Upper>().solve(turned.head(rank()));
        return orthogonal_.colsPermutation() * x;
    }

    Eigen::MatrixXd matrix_;  ///< columns brought to one size
    Eigen::VectorXd scale_;
    double nothing_;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> orthogonal_;
};

/// A force at a place of a body or on the pin of a hinge, or a couple, that the file gives.
struct Given {
    BodyIndex body = frame;
    Pair force{};
    Vector place;
    double couple = 0;
    JointIndex pin = none;
};

class Equilibrium {
public:
    Equilibrium(const Mechanism& mechanism, const Pose& pose, const NumericMotion& motion)
        : mechanism_(mechanism), pose_(pose), motion_(motion), size_(pose.size.to_double()) {
        gather_loads();
        measure_bodies();
        lay_out();
        write_right_side();
    }

    NumericForces run() {
        std::vector<bool> clockwise(mechanism_.joints.size(), false);
        Solved solved = solve(clockwise);
        // The other line changes the radial component only, and with wheels on their axles nothing that the sense depends on: one
        // round settles them all. Where wheels float, a few more may be needed.
        for (std::size_t round = 0; round <= mechanism_.joints.size() && turn_gears(solved, clockwise); ++round)
            solved = solve(clockwise);
        return report(solved, clockwise);
    }

private:
    struct Solved {
        Eigen::VectorXd values;
        std::vector<bool> known;
        std::vector<std::optional<Pair>>
            common;  ///< by unknown: of it and the next, in the plane, what is the same in every equilibrium
        int indeterminacy = 0;
        bool balanced = true;
        double residual = 0;
    };

    // --- what is given ---------------------------------------------------------------------------------------------------------
    void gather_loads() {
        for (const Load& load : mechanism_.loads) {
            std::visit([&](const auto& form) { take(form); }, load);
        }
        unknown_inertia_.resize(mechanism_.bodies.size(), false);
        for (const Mass& mass : mechanism_.masses) {
            if (mass.body == frame) continue;
            const Vector& centre = pose_.at(mass.centre);
            const double m = mass.mass.to_double();
            if (mechanism_.gravity) given_.push_back({mass.body, m * rough(*mechanism_.gravity), centre, 0});
            if (!mechanism_.inertia_forces) continue;
            const auto& state = motion_.bodies[at_index(mass.body)];
            if (!state.acceleration_known) {
                unknown_inertia_[at_index(mass.body)] = m > 0 || !mass.inertia.is_zero();
                continue;
            }
            given_.push_back(
                {mass.body, -m * motion_.acceleration(mass.body, centre), centre, -mass.inertia.to_double() * state.alpha});
        }
        for (const Given& each : given_) {
            unit_ = std::max({unit_, std::hypot(each.force[0], each.force[1]), std::abs(each.couple) / size_});
        }
        if (unit_ == 0) unit_ = 1;
    }
    void take(const ForceLoad& load) {
        const Pair force = load.value ? rough(*load.value)
                                      : load.magnitude->first.to_double() *
                                            rough(unit_along(direction_of(load.magnitude->second, pose_), pose_.bits));
        given_.push_back({load.pin == none ? load.body : frame, force, pose_.at(load.at), 0, load.pin});
    }
    void take(const CoupleLoad& load) { given_.push_back({load.body, {}, {}, load.value.to_double()}); }
    void take(const SpringLoad& load) {
        const Vector& p = pose_.at(load.between[0]);
        const Vector& q = pose_.at(load.between[1]);
        if (p == q) return;  // no direction to pull in
        const Pair apart = rough(q - p);
        const double stretch = std::hypot(apart[0], apart[1]);
        const double size = load.elastic ? load.elastic->stiffness.to_double() * (stretch - load.elastic->free_length.to_double())
                                         : load.magnitude.to_double();
        const Pair pull = size * rough(unit_along(q - p, pose_.bits));
        given_.push_back({load.bodies[0], pull, p, 0});
        given_.push_back({load.bodies[1], -1 * pull, q, 0});
    }
    /// Simpson's rule, exact for moments of what varies linearly: no centroid is asked.
    void take(const DistributedLoad& load) {
        const Vector &p = pose_.at(load.from), &q = pose_.at(load.to);
        const Pair along = rough(unit_along(direction_of(load.along, pose_), pose_.bits));
        const Pair apart = rough(q - p);
        const double sixth = std::hypot(apart[0], apart[1]) / 6;
        const double first = load.intensity[0].to_double(), last = load.intensity[1].to_double();
        given_.push_back({load.body, sixth * first * along, p, 0});
        given_.push_back({load.body, 2 * sixth * (first + last) * along, Exact::ratio(1, 2) * (p + q), 0});
        given_.push_back({load.body, sixth * last * along, q, 0});
    }
    void take(const TorsionLoad& load) {
        const double couple = -load.stiffness.to_double() * load.turned.to_double();
        given_.push_back({load.bodies[0], {}, {}, couple});
        given_.push_back({load.bodies[1], {}, {}, -couple});
    }

    // --- bodies ----------------------------------------------------------------------------------------------------------------
    /// Each body's reference amid the places where forces act, and its own size: a moment there is to be felt by its own arms.
    void measure_bodies() {
        std::vector<std::vector<const Vector*>> places(mechanism_.bodies.size());
        for (const Joint& joint : mechanism_.joints) {
            for (const BodyIndex body : joint.bodies) places[at_index(body)].push_back(&pose_.at(joint.point));
        }
        for (const Given& each : given_) {
            if (each.force != Pair{}) places[at_index(each.body)].push_back(&each.place);
        }
        for (const Effort& effort : mechanism_.efforts) {
            if (const auto* force = std::get_if<ForceEffort>(&effort))
                places[at_index(force->body)].push_back(&pose_.at(force->at));
        }
        references_.resize(places.size());
        own_size_.resize(places.size(), size_);
        for (std::size_t b = 1; b < places.size(); ++b) {
            if (places[b].empty()) continue;
            Pair mean{};
            for (const Vector* place : places[b]) mean = mean + 1 / static_cast<double>(places[b].size()) * rough(*place);
            references_[b] = {Exact::from_double(mean[0]), Exact::from_double(mean[1])};
            double reach = 0;
            for (const Vector* place : places[b]) reach = std::max(reach, length(*place - references_[b]));
            constexpr double a_point = 1e-12;  // all places are one; what is left is rounding
            if (reach > a_point * size_) own_size_[b] = reach;
        }
        // An entry is off by the rounding of its points beside the body's own size; a pivot by a few entries.
        constexpr double entries = 16;
        doubt_ = entries * pose_.rounding() * size_ / *std::min_element(own_size_.begin(), own_size_.end());
    }

    // --- layout ----------------------------------------------------------------------------------------------------------------
    static int reactions_of(const Joint& joint) {
        const int of_each = joint.has_own_node() ? static_cast<int>(joint.bodies.size()) : 1;  // a pin in between meets each body
        switch (joint.kind) {
            case JointKind::revolute:
            case JointKind::rolling:
                return 2 * of_each;
            case JointKind::weld:
                return 3 * of_each;
            case JointKind::prismatic:
                return 2;
            case JointKind::pin_slot:
            case JointKind::contact:
            case JointKind::gear:
                return 1;
        }
        return 0;
    }
    void lay_out() {
        rows_ = 3 * (static_cast<Index>(mechanism_.bodies.size()) - 1);
        for (const Joint& joint : mechanism_.joints) {
            first_column_.push_back(columns_);
            first_pin_row_.push_back(rows_);
            columns_ += reactions_of(joint);
            if (joint.has_own_node()) rows_ += joint.kind == JointKind::weld ? 3 : 2;
        }
        first_effort_ = columns_;
        columns_ += static_cast<Index>(mechanism_.efforts.size());
    }

    // --- equations -------------------------------------------------------------------------------------------------------------
    static Index row_of(BodyIndex body) { return Index{3} * (body.number() - 1); }
    double moment(BodyIndex body, const Vector& place, const Pair& force) const {
        return outer(rough(place - references_[at_index(body)]), force) / own_size_[at_index(body)];
    }
    void add_force(Eigen::MatrixXd& matrix, Index column, BodyIndex body, const Vector& place, const Pair& direction) const {
        if (body == frame) return;
        const Index row = row_of(body);
        matrix(row, column) += direction[0];
        matrix(row + 1, column) += direction[1];
        matrix(row + 2, column) += moment(body, place, direction);
    }
    /// A couple is counted in units of (largest load)·(size of the drawing).
    void add_couple(Eigen::MatrixXd& matrix, Index column, BodyIndex body, double sign) const {
        if (body != frame) matrix(row_of(body) + 2, column) += sign * size_ / own_size_[at_index(body)];
    }
    void write_right_side() {
        right_ = Eigen::VectorXd::Zero(rows_);
        for (const Given& each : given_) {
            if (each.pin != none) {
                const Index row = first_pin_row_[at_index(each.pin)];
                right_[row] -= each.force[0] / unit_;
                right_[row + 1] -= each.force[1] / unit_;
            }
            if (each.body == frame) continue;
            const Index row = row_of(each.body);
            right_[row] -= each.force[0] / unit_;
            right_[row + 1] -= each.force[1] / unit_;
            right_[row + 2] -= each.couple / own_size_[at_index(each.body)] / unit_;
            if (each.force != Pair{}) right_[row + 2] -= moment(each.body, each.place, 1 / unit_ * each.force);
        }
    }

    Pair unit_of(const Vector& direction) const { return rough(unit_along(direction, pose_.bits)); }

    /// The directions of a joint's force, for which there is one unknown each.
    std::vector<Pair> directions(const Joint& joint, bool clockwise) const {
        const std::size_t index = static_cast<std::size_t>(&joint - mechanism_.joints.data());
        switch (joint.kind) {
            case JointKind::revolute:
            case JointKind::rolling:
            case JointKind::weld:
                return {{1, 0}, {0, 1}};
            case JointKind::prismatic:
                return {quarter(unit_of(pose_.guides[index]))};
            case JointKind::pin_slot:
            case JointKind::contact:
                return {unit_of(pose_.normals[index])};
            case JointKind::gear: {
                const Pair action = unit_of(pose_.normals[index]);
                if (!clockwise) return {action};
                const Pair t = unit_of(pose_.tangents[index]);
                return {2 * inner(t, action) * t + -1 * action};
            }
        }
        return {};
    }
    static bool carries_couple(const Joint& joint) { return joint.kind == JointKind::prismatic || joint.kind == JointKind::weld; }

    void write(Eigen::MatrixXd& matrix, const Joint& joint, std::size_t index, bool clockwise) const {
        const Vector& place = pose_.at(joint.point);
        const auto along = directions(joint, clockwise);
        Index column = first_column_[index];
        if (!joint.has_own_node()) {
            for (const Pair& direction : along) {
                add_force(matrix, column, joint.bodies[0], place, direction);
                add_force(matrix, column++, joint.bodies[1], place, -1 * direction);
            }
            if (!carries_couple(joint)) return;
            add_couple(matrix, column, joint.bodies[0], 1);
            add_couple(matrix, column, joint.bodies[1], -1);
            return;
        }
        for (const BodyIndex body : joint.bodies) {
            Index pin_row = first_pin_row_[index];
            for (const Pair& direction : along) {
                matrix(pin_row++, column) = -1;
                add_force(matrix, column++, body, place, direction);
            }
            if (!carries_couple(joint)) continue;
            matrix(pin_row, column) = -1;
            add_couple(matrix, column++, body, 1);
        }
    }
    void write(Eigen::MatrixXd& matrix, Index column, const CoupleEffort& effort) const {
        add_couple(matrix, column, effort.body, 1);
        add_couple(matrix, column, effort.from, -1);
    }
    void write(Eigen::MatrixXd& matrix, Index column, const ForceEffort& effort) const {
        add_force(matrix, column, effort.body, pose_.at(effort.at), unit_of(direction_of(effort.along, pose_)));
    }
    void write(Eigen::MatrixXd& matrix, Index column, const ActuatorEffort& effort) const {
        const Joint& joint = mechanism_.joint(effort.joint);
        const Pair along = rough(pose_.guide_units[at_index(effort.joint)]);
        add_force(matrix, column, joint.bodies[0], pose_.at(joint.point), along);
        add_force(matrix, column, joint.bodies[1], pose_.at(joint.point), -1 * along);
    }

    Solved solve(const std::vector<bool>& clockwise) const {
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows_, columns_);
        for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) write(matrix, mechanism_.joints[i], i, clockwise[i]);
        for (std::size_t i = 0; i < mechanism_.efforts.size(); ++i) {
            const Index column = first_effort_ + static_cast<Index>(i);
            std::visit([&](const auto& form) { write(matrix, column, form); }, mechanism_.efforts[i]);
        }

        // A body whose inertia nobody knows has no equations that could be used.
        std::vector<bool> used(static_cast<std::size_t>(rows_), true);
        for (std::size_t b = 1; b < mechanism_.bodies.size(); ++b) {
            if (unknown_inertia_[b]) leave_out(row_of(BodyIndex(b)), used);
        }
        Solved solved;
        const Solver all(matrix, doubt_);
        solved.indeterminacy = static_cast<int>(columns_ - all.rank());
        const bool every = std::find(used.begin(), used.end(), false) == used.end();
        if (!every) return solve_part(matrix, used, solved);

        solved.values = all.solve(right_);
        const Eigen::VectorXd miss = all.residual(right_, solved.values);
        if (note_balance(miss, solved)) {
            solved.known = all.determined();
            solved.common = common_directions(all);
            return solved;
        }
        leave_out_unbalanced(miss, solved.values, used);
        return solve_part(matrix, used, solved);
    }
    /// Some bodies are left out: what the others determine. What the residual of the least squares leaves untouched is satisfied
    /// without the rest, so one pass finds the part that is in equilibrium by itself.
    Solved solve_part(const Eigen::MatrixXd& matrix, std::vector<bool>& used, Solved solved) const {
        for (;;) {
            const auto count = static_cast<Index>(std::count(used.begin(), used.end(), true));
            Eigen::MatrixXd part(count, columns_);
            Eigen::VectorXd right(count);
            std::vector<Index> row_in_all;
            for (Index i = 0; i < rows_; ++i) {
                if (!used[static_cast<std::size_t>(i)]) continue;
                const auto row = static_cast<Index>(row_in_all.size());
                if (columns_ > 0) part.row(row) = matrix.row(i);  // Eigen steps to a row even where there is no element
                right[row] = right_[i];
                row_in_all.push_back(i);
            }
            const Solver some(part, doubt_);
            solved.values = some.solve(right);
            Eigen::VectorXd miss = Eigen::VectorXd::Zero(rows_);
            const Eigen::VectorXd part_miss = some.residual(right, solved.values);
            for (std::size_t i = 0; i < row_in_all.size(); ++i) miss[row_in_all[i]] = part_miss[static_cast<Index>(i)];
            if (note_balance(miss, solved)) {
                solved.known = some.determined();
                solved.common = common_directions(some);
                return solved;
            }
            leave_out_unbalanced(miss, solved.values, used);
        }
    }
    /// By unknown; of the first component of a force that has two.
    std::vector<std::optional<Pair>> common_directions(const Solver& solver) const {
        std::vector<std::optional<Pair>> common(static_cast<std::size_t>(columns_));
        for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
            const Joint& joint = mechanism_.joints[i];
            const auto width = static_cast<Index>(directions(joint, false).size());
            if (width != 2) continue;
            const Index ends = joint.has_own_node() ? static_cast<Index>(joint.bodies.size()) : 1;
            const Index step = width + (carries_couple(joint) ? 1 : 0);
            for (Index end = 0; end < ends; ++end) {
                const Index column = first_column_[i] + end * step;
                common[static_cast<std::size_t>(column)] = solver.common_direction(column);
            }
        }
        return common;
    }
    double nothing() const { return std::max(least_nothing, doubt_); }
    double tolerance(const Eigen::VectorXd& values) const { return nothing() * std::max(largest(right_), largest(values)); }
    /// True where nothing is left over. The first imbalance found is the one reported.
    bool note_balance(const Eigen::VectorXd& miss, Solved& solved) const {
        const double left = largest(miss);
        const bool holds = left <= tolerance(solved.values);
        if (solved.balanced) solved.residual = left / std::max(1.0, largest(right_));
        solved.balanced = solved.balanced && holds;
        return holds;
    }
    static void leave_out(Index first, std::vector<bool>& used) {
        for (Index k = 0; k < 3; ++k) used[static_cast<std::size_t>(first + k)] = false;
    }
    /// Whole bodies: one of whose equations fails is not at rest, so its others say nothing either.
    void leave_out_unbalanced(const Eigen::VectorXd& miss, const Eigen::VectorXd& values, std::vector<bool>& used) const {
        const double tolerated = tolerance(values);
        const Index of_bodies = row_of(BodyIndex(mechanism_.bodies.size()));
        for (Index i = 0; i < rows_; ++i) {
            if (std::abs(miss[i]) <= tolerated) continue;
            if (i < of_bodies) {
                leave_out(i - i % 3, used);
            } else {
                used[static_cast<std::size_t>(i)] = false;
            }
        }
    }

    // --- gears -----------------------------------------------------------------------------------------------------------------
    /// Teeth only push, so the radial component of a gear's force separates the wheels: on bodies[0] it points into its own
    /// material. With n the normal of the pitch curves and 1/x their curvatures (x the centre's place along n; 0 for a rack) the
    /// material of bodies[0] lies on the side sign(1/x_0 − 1/x_1) of n: two wheels outside each other curve apart, and a wheel
    /// inside a ring curves more than the ring. Of the two lines of action the one is taken on which the tangential force that
    /// equilibrium asks for comes with a radial force of that sign. (Joints given by "tangent" alone do not say where their
    /// material lies and keep the line turned counter-clockwise.) True where a line was changed.
    bool turn_gears(const Solved& solved, std::vector<bool>& clockwise) const {
        bool changed = false;
        for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
            const Joint& joint = mechanism_.joints[i];
            if (joint.kind != JointKind::gear || !solved.known[static_cast<std::size_t>(first_column_[i])]) continue;
            const double force = solved.values[first_column_[i]];
            if (std::abs(force) <= nothing() * largest(solved.values)) continue;
            const Pair n = quarter(unit_of(pose_.tangents[i]));
            const double radial = force * inner(n, directions(joint, clockwise[i]).front());
            const double material = curvature(joint, joint.bodies[0], n) - curvature(joint, joint.bodies[1], n);
            if (radial * material >= 0) continue;
            clockwise[i] = !clockwise[i];
            changed = true;
        }
        return changed;
    }
    double curvature(const Joint& joint, BodyIndex body, const Pair& n) const {
        const auto found = joint.profiles.find(body);
        if (found == joint.profiles.end()) return 0;
        const auto* circle = std::get_if<CircleProfile>(&found->second);
        if (circle == nullptr) return 0;
        return 1 / inner(n, rough(pose_.at(circle->centre) - pose_.at(joint.point)));
    }

    // --- answer ----------------------------------------------------------------------------------------------------------------
    /// Of a joint whose unknowns begin at a column, which goes on behind them.
    template <class Directions>
    NumericForces::Action action_at(Index& column, JointIndex index, const Directions& along, const Solved& solved) const {
        const auto known = [&](Index each) { return static_cast<bool>(solved.known[static_cast<std::size_t>(each)]); };
        const Joint& joint = mechanism_.joint(index);
        NumericForces::Action action;
        action.joint = index;
        const Index first = column;
        action.force_known = true;
        for (const Pair& direction : along) {
            action.force_known = action.force_known && known(column);
            action.force = action.force + unit_ * solved.values[column++] * direction;
        }
        action.couple_known = !carries_couple(joint) || known(column);
        if (carries_couple(joint)) action.couple = unit_ * size_ * solved.values[column++];
        action.known = action.force_known && action.couple_known;
        if (const auto& common = solved.common[static_cast<std::size_t>(first)]; common && !action.force_known) {
            action.along = common;
            action.component = inner(action.force, *common);
        }
        if (!action.force_known) action.force = {};
        if (!action.couple_known) action.couple = 0;
        return action;
    }
    NumericForces report(const Solved& solved, const std::vector<bool>& clockwise) const {
        NumericForces forces;
        forces.indeterminacy = solved.indeterminacy;
        forces.balanced = solved.balanced;
        forces.residual = solved.residual;
        forces.given.resize(mechanism_.bodies.size());
        for (const Given& each : given_) {
            const auto& on = each.pin == none ? each.body : mechanism_.joint(each.pin).bodies.back();
            NumericForces::Sum& sum = forces.given[at_index(on)];
            sum.force = sum.force + each.force;
            sum.couple += each.couple + outer(rough(each.place), each.force);
        }
        const auto known = [&](Index column) { return static_cast<bool>(solved.known[static_cast<std::size_t>(column)]); };
        for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
            const Joint& joint = mechanism_.joints[i];
            const auto along = directions(joint, clockwise[i]);
            Index column = first_column_[i];
            const auto next_action = [&] { return action_at(column, JointIndex(i), along, solved); };
            if (joint.has_own_node()) {
                for (const BodyIndex body : joint.bodies) {
                    forces.actions.push_back(next_action());
                    forces.actions.back().on = body;
                }
                continue;
            }
            auto action = next_action();
            action.on = joint.bodies[0];
            action.from = joint.bodies[1];
            forces.actions.push_back(action);
            std::swap(action.on, action.from);
            action.force = {0 - action.force[0], 0 - action.force[1]};  // no −0
            action.couple = 0 - action.couple;
            action.component = 0 - action.component;
            forces.actions.push_back(action);
        }
        for (std::size_t i = 0; i < mechanism_.efforts.size(); ++i) {
            const Index column = first_effort_ + static_cast<Index>(i);
            const double unit = std::holds_alternative<CoupleEffort>(mechanism_.efforts[i]) ? unit_ * size_ : unit_;
            forces.effort_known.push_back(known(column));
            forces.efforts.push_back(known(column) ? unit * solved.values[column] : 0);
        }
        return forces;
    }

    const Mechanism& mechanism_;
    const Pose& pose_;
    const NumericMotion& motion_;
    double size_;
    double unit_ = 0;  ///< the largest load, N
    double doubt_ = 0;
    std::vector<Given> given_;
    std::vector<bool> unknown_inertia_;  ///< by body
    std::vector<Vector> references_;     ///< by body
    std::vector<double> own_size_;       ///< by body: what its moments are divided by, m
    Index rows_ = 0, columns_ = 0, first_effort_ = 0;
    std::vector<Index> first_column_, first_pin_row_;  ///< by joint
    Eigen::VectorXd right_;
};

}  // namespace

NumericForces check_forces(const Mechanism& mechanism, const Pose& pose, const NumericMotion& motion) {
    KG_ASSERT(motion.bodies.size() == mechanism.bodies.size(), "the motion is this mechanism's");
    return Equilibrium(mechanism, pose, motion).run();
}

}  // namespace kinegraph
