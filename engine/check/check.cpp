// Writes the joints and drivers as linear equations in doubles and solves them with Eigen: velocities first, then
// accelerations, whose known terms need the velocities. Shares nothing with the constructions but Mechanism and Pose.
//
// Unknowns, for each body but the frame: velocity (or acceleration) of its reference place over the drawing's size L,
// and ω (or α). Below: n a unit vector, r = P − reference, z× a quarter turn, u·v the dot product, and
//   n·v_i(P) = n·v_ref + ω (r × n),      n·a_i(P) = n·a_ref + α (r × n) − ω² n·r.
#include "engine/check/check.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "engine/check/plane_pair.hpp"
#include "engine/mechanism/rounding.hpp"
#include "engine/number/wide.hpp"

namespace kinegraph {
namespace {

using namespace numeric;

Vector exactly(const Pair& a) { return {Exact::from_double(a[0]), Exact::from_double(a[1])}; }
Pair unit(const Vector& a) {
    const double l = length(a);
    return {a.x.to_double() / l, a.y.to_double() / l};
}

/// One equation: Σ coefficient·unknown = right side, for velocities and for accelerations.
struct Row {
    struct Term {
        Eigen::Index column;
        double factor;
    };
    std::vector<Term> terms;
    double velocity = 0;
    double acceleration = 0;
    bool acceleration_known = true;  ///< false where it needs an unknown curvature or velocity
};

struct Solved {
    Eigen::VectorXd values;
    std::vector<bool> known;  ///< by column: whether it is zero in every motion of the null space
};

/// Solves the rows in the least-squares sense with one step of refinement, its residuals in twice the digits.
class System {
public:
    /// `rounding`: error of the points, as a share of the drawing's size.
    System(const std::vector<Row>& rows, Eigen::Index columns, double rounding) : columns_(columns) {
        matrix_ = matrix_of(rows, columns);
        // Columns are scaled to equal size: a body's ω acts over its own length, which may be far smaller than the
        // drawing.
        scale_ = Eigen::VectorXd::Ones(columns);
        for (Eigen::Index j = 0; j < columns && matrix_.rows() > 0; ++j) {
            const double largest = matrix_.col(j).cwiseAbs().maxCoeff();
            if (largest > 0) scale_[j] = 1 / largest;
        }
        matrix_ = matrix_ * scale_.asDiagonal();
        // An entry has the rounding error of its points, divided by the body's size where it is small; a pivot that of
        // several entries.
        constexpr double entries = 16;
        const double doubt = entries * rounding * scale_.maxCoeff();
        nothing_ = std::max(nothing_, doubt);
        if (matrix_.rows() == columns && columns > 0) {
            square_.compute(matrix_);
            // Doubles give about 1e-16 where an exact matrix is singular; a matrix well above that is regular.
            const double regular = std::max(1e-12, doubt);
            // (The condition estimate is meaningless beside a pivot that vanishes.)
            const auto pivots = square_.matrixLU().diagonal().cwiseAbs();
            if (pivots.minCoeff() > regular * pivots.maxCoeff() && square_.rcond() > regular) {
                is_regular_ = true;
                return;
            }
        }
        if (matrix_.rows() == 0) return;
        orthogonal_.setThreshold(std::max(rank_threshold, doubt));
        orthogonal_.compute(matrix_);
    }

    static Eigen::MatrixXd matrix_of(const std::vector<Row>& rows, Eigen::Index columns) {
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), columns);
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (const auto& [column, factor] : rows[i].terms) matrix(static_cast<Eigen::Index>(i), column) += factor;
        return matrix;
    }

    /// For rounded data: the rank ends at the first small pivot that the shifts of the data explain, instead of at a
    /// fixed one. `shifted`: the same equations for the shifted drawings.
    void end_rank_within(const std::vector<Eigen::MatrixXd>& shifted, double share) {
        if (is_regular_ || matrix_.rows() == 0) return;
        const Eigen::VectorXd pivots = orthogonal_.matrixQR().diagonal().cwiseAbs();
        Eigen::VectorXd spread = Eigen::VectorXd::Zero(pivots.size());
        for (const Eigen::MatrixXd& each : shifted) {
            const Eigen::MatrixXd ordered = each * scale_.asDiagonal() * orthogonal_.colsPermutation();
            const Eigen::HouseholderQR<Eigen::MatrixXd> other(ordered);
            spread = spread.cwiseMax((other.matrixQR().diagonal().cwiseAbs() - pivots).cwiseAbs());
        }
        const double in_question = std::ldexp(orthogonal_.maxPivot(), -bits_in_question(share));
        double threshold = rank_threshold;
        constexpr double above = 1.000001;
        for (Eigen::Index i = 0; i < pivots.size() && threshold == rank_threshold; ++i)
            if (pivots[i] <= in_question && is_zero_within(pivots[i], spread[i]))
                threshold = std::max(threshold, above * pivots[i] / orthogonal_.maxPivot());
        orthogonal_.setThreshold(threshold);
    }

    Solved solve(const Eigen::VectorXd& right) const {
        Solved solved{Eigen::VectorXd::Zero(columns_),
                      std::vector<bool>(at_index(static_cast<int>(columns_)), is_regular_)};
        if (matrix_.rows() == 0) return solved;
        Eigen::VectorXd x = particular(right);
        const Eigen::VectorXd miss = residual(right, x);
        x += particular(miss);
        if (!is_regular_) mark_known(right, x, solved.known);
        solved.values = scale_.cwiseProduct(x);
        return solved;
    }

private:
    /// A point may miss its curve by 1e-9 of the size, so smaller pivots cannot be distinguished from redundant
    /// constraints.
    static constexpr double rank_threshold = 1e-9;

    Eigen::VectorXd residual(const Eigen::VectorXd& right, const Eigen::VectorXd& x) const {
        Eigen::VectorXd miss(right.size());
        for (Eigen::Index i = 0; i < matrix_.rows(); ++i) {
            wide::Wide sum{right[i]};
            for (Eigen::Index j = 0; j < columns_; ++j) sum = sum - wide::product_of(matrix_(i, j), x[j]);
            miss[i] = sum.rounded();
        }
        return miss;
    }
    /// A solution with zero for the free unknowns.
    Eigen::VectorXd particular(const Eigen::VectorXd& right) const {
        if (is_regular_) return square_.solve(right);
        const Eigen::Index rank = orthogonal_.rank();
        const Eigen::VectorXd turned = orthogonal_.householderQ().transpose() * right;
        Eigen::VectorXd x = Eigen::VectorXd::Zero(columns_);
        x.head(rank) =
            orthogonal_.matrixQR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solve(turned.head(rank));
        return orthogonal_.colsPermutation() * x;
    }
    void mark_known(const Eigen::VectorXd& right, const Eigen::VectorXd& x, std::vector<bool>& known) const {
        // Inconsistent equations (a driver at a dead point) determine nothing.
        const double largest = std::max(right.cwiseAbs().maxCoeff(), x.cwiseAbs().maxCoeff());
        if (residual(right, x).cwiseAbs().maxCoeff() > nothing_ * largest) return;
        const Eigen::Index rank = orthogonal_.rank();
        const Eigen::Index free = columns_ - rank;
        Eigen::MatrixXd null(columns_, free);
        if (free > 0) {
            const auto& qr = orthogonal_.matrixQR();
            null.topRows(rank) = -qr.topLeftCorner(rank, rank)
                                      .triangularView<Eigen::Upper>()
                                      .solve(qr.topRightCorner(rank, free))
                                      .eval();
            null.bottomRows(free).setIdentity();
            null = orthogonal_.colsPermutation() * null;
        }
        for (Eigen::Index j = 0; j < columns_; ++j) {
            known[static_cast<std::size_t>(j)] = free == 0 || null.row(j).cwiseAbs().maxCoeff() < nothing_;
        }
    }

    Eigen::Index columns_;
    Eigen::MatrixXd matrix_;
    Eigen::VectorXd scale_;
    bool is_regular_ = false;
    double nothing_ = 1e-8;  ///< values below this share of the largest are zero
    Eigen::PartialPivLU<Eigen::MatrixXd> square_;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> orthogonal_;
};

class CheckOfMotion {
public:
    CheckOfMotion(const Mechanism& mechanism, const Pose& pose)
        : mechanism_(mechanism),
          pose_(pose),
          size_(pose.size.to_double()),
          rounding_(pose.rounding()),
          columns_(3 * (static_cast<Eigen::Index>(mechanism.bodies.size()) - 1)) {
        motion_.bodies.resize(mechanism.bodies.size());
        for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
            const auto& points = mechanism.bodies[i].points;
            Pair& reference = motion_.bodies[i].reference;
            for (const PointIndex point : points) {
                const Pair place = rough(pose.at(point));
                for (const int k : {0, 1})
                    reference[at_index(k)] += place[at_index(k)] / static_cast<double>(points.size());
            }
            references_.push_back(exactly(reference));
        }
        motion_.bodies.front().velocity_known = motion_.bodies.front().acceleration_known = true;
    }

    NumericMotion run() {
        write_all();
        if (columns_ == 0) return std::move(motion_);

        System velocities(rows_, columns_, rounding_);
        if (pose_.is_rounded()) velocities.end_rank_within(shifted_matrices(), rounding_);
        take(velocities.solve(right_side([](const Row& row) { return row.velocity; })),
             &NumericMotion::BodyState::velocity, &NumericMotion::BodyState::omega,
             &NumericMotion::BodyState::velocity_known);

        for (std::size_t i = 0; i < rows_.size(); ++i) {
            Row& row = rows_[i];
            row.acceleration_known = std::all_of(row.terms.begin(), row.terms.end(), [&](const Row::Term& term) {
                return motion_.bodies[static_cast<std::size_t>(term.column / 3 + 1)].velocity_known;
            });
            const std::optional<double> right = row.acceleration_known ? second_order_[i]() : std::nullopt;
            row.acceleration_known = right.has_value();
            row.acceleration = right.value_or(0);
        }
        const auto unknown = [](const Row& row) { return !row.acceleration_known; };
        const auto acceleration = [](const Row& row) { return row.acceleration; };
        const bool all_known = later_.empty() && std::none_of(rows_.begin(), rows_.end(), unknown);
        if (!all_known) rows_.erase(std::remove_if(rows_.begin(), rows_.end(), unknown), rows_.end());
        for (auto& [row, second_order] : later_) {
            row.acceleration = second_order().value_or(0);
            rows_.push_back(std::move(row));
        }
        const auto solved = all_known ? velocities.solve(right_side(acceleration))
                                      : System(rows_, columns_, rounding_).solve(right_side(acceleration));
        take(solved, &NumericMotion::BodyState::acceleration, &NumericMotion::BodyState::alpha,
             &NumericMotion::BodyState::acceleration_known);
        for (auto& body : motion_.bodies) body.acceleration_known = body.acceleration_known && body.velocity_known;
        return std::move(motion_);
    }

private:
    void write_all() {
        for (const Joint& joint : mechanism_.joints) write(joint, mechanism_.index_of(joint));
        for (const Driver& driver : mechanism_.drivers) {
            std::visit([&](const auto& form) { write(form); }, driver);
        }
        if (mechanism_.motion) write(*mechanism_.motion);
    }
    std::vector<Eigen::MatrixXd> shifted_matrices() const {
        std::vector<Eigen::MatrixXd> matrices;
        for (const ShiftedDrawing& each : *pose_.shifted) {
            CheckOfMotion other(each.mechanism, each.pose);
            other.write_all();
            matrices.push_back(System::matrix_of(other.rows_, columns_));
        }
        return matrices;
    }

    using SecondOrder = std::function<std::optional<double>()>;

    template <class Side>
    Eigen::VectorXd right_side(Side side) const {
        Eigen::VectorXd right(static_cast<Eigen::Index>(rows_.size()));
        for (std::size_t i = 0; i < rows_.size(); ++i) right[static_cast<Eigen::Index>(i)] = side(rows_[i]);
        return right;
    }
    template <class OfPlace, class OfTurn, class Known>
    void take(const Solved& solved, OfPlace of_place, OfTurn of_turn, Known known) {
        for (std::size_t i = 1; i < motion_.bodies.size(); ++i) {
            auto& body = motion_.bodies[i];
            const auto first = static_cast<Eigen::Index>(3 * (i - 1));
            body.*of_place = {size_ * solved.values[first], size_ * solved.values[first + 1]};
            body.*of_turn = solved.values[first + 2];
            const std::size_t column = 3 * (i - 1);
            body.*known = solved.known[column] && solved.known[column + 1] && solved.known[column + 2];
        }
    }

    // --- pieces of equations; lengths over the drawing's size
    // ----------------------------------------------------------------
    Pair arm(BodyIndex body, const Vector& place) const {
        const Vector& reference = references_[at_index(body)];
        const Pair r{difference_to_double(place.x, reference.x), difference_to_double(place.y, reference.y)};
        return {r[0] / size_, r[1] / size_};
    }
    void add_speed(Row& row, BodyIndex body, const Vector& place, const Pair& n, double sign) const {
        if (body != frame) add_speed(row, body, arm(body, place), n, sign);
    }
    static void add_speed(Row& row, BodyIndex body, const Pair& r, const Pair& n, double sign) {
        if (body == frame) return;
        const Eigen::Index first = Eigen::Index{3} * (body.number() - 1);
        row.terms.push_back({first, sign * n[0]});
        row.terms.push_back({first + 1, sign * n[1]});
        row.terms.push_back({first + 2, sign * (r[0] * n[1] - r[1] * n[0])});
    }
    static void add_turn(Row& row, BodyIndex body, double sign) {
        if (body != frame) row.terms.push_back({Eigen::Index{3} * (body.number() - 1) + 2, sign});
    }
    void enter(Row row, double velocity, SecondOrder second_order) {
        row.velocity = velocity;
        rows_.push_back(std::move(row));
        second_order_.push_back(std::move(second_order));
    }
    double omega(BodyIndex body) const { return motion_.bodies[at_index(body)].omega; }
    Pair speed(BodyIndex body, const Vector& place) const {
        const auto& state = motion_.bodies[at_index(body)];
        const Pair r = arm(body, place);
        return {state.velocity[0] / size_ - state.omega * r[1], state.velocity[1] / size_ + state.omega * r[0]};
    }
    /// The contribution of −ω²r of both bodies to the right side of n·(a_i(P_i) − a_j(P_j)) = …
    double centripetal(BodyIndex i, const Pair& on_i, BodyIndex j, const Pair& on_j, const Pair& n) const {
        return square_of(omega(i)) * inner(n, on_i) - square_of(omega(j)) * inner(n, on_j);
    }
    double centripetal(BodyIndex i, const Vector& at_i, BodyIndex j, const Vector& at_j, const Pair& n) const {
        return centripetal(i, arm(i, at_i), j, arm(j, at_j), n);
    }
    static double square_of(double x) { return x * x; }

    /// n·(v_i − v_j) at P is `velocity`; n·(a_i − a_j) there is `second_order()`.
    void equal_speeds(BodyIndex i, BodyIndex j, const Vector& place, const Pair& n, double velocity,
                      SecondOrder second_order) {
        Row row;
        const Pair on_i = arm(i, place), on_j = arm(j, place);
        add_speed(row, i, on_i, n, 1);
        add_speed(row, j, on_j, n, -1);
        enter(std::move(row), velocity, [=, this, more = std::move(second_order)]() -> std::optional<double> {
            const auto relative = more();
            if (!relative) return std::nullopt;
            return *relative + centripetal(i, on_i, j, on_j, n);
        });
    }
    void equal_turns(BodyIndex i, BodyIndex j, double velocity = 0, double acceleration = 0) {
        Row row;
        add_turn(row, i, 1);
        add_turn(row, j, -1);
        enter(std::move(row), velocity, [=] { return acceleration; });
    }

    // --- joints
    // --------------------------------------------------------------------------------------------------------------
    void write(const Joint& joint, JointIndex index) {
        switch (joint.kind) {
            case JointKind::revolute:
            case JointKind::weld:
                for (std::size_t k = 1; k < joint.bodies.size(); ++k) {
                    pin(joint.bodies[0], joint.bodies[k], pose_.at(joint.point));
                    if (joint.kind == JointKind::weld) equal_turns(joint.bodies[0], joint.bodies[k]);
                }
                return;
            case JointKind::prismatic:
                slide(joint, index);
                equal_turns(joint.bodies[0], joint.bodies[1]);
                return;
            case JointKind::pin_slot:
                if (joint.arc != none) {
                    slide_on_arc(joint);
                } else {
                    slide(joint, index);
                }
                return;
            case JointKind::rolling: roll(joint, index); return;
            case JointKind::contact: touch(joint, index); return;
            case JointKind::gear: mesh(joint, index); return;
        }
    }

    void pin(BodyIndex i, BodyIndex j, const Vector& place) {
        for (const Pair& n : {Pair{1, 0}, Pair{0, 1}}) equal_speeds(i, j, place, n, 0, [] { return 0.0; });
    }

    /// P of i moves along u in j, at s:  a_i = a_j + 2ω_j z×(s u) + s̈ u,  so with n = z×u:  n·(a_i − a_j) = 2 ω_j s.
    void slide(const Joint& joint, JointIndex index) {
        const Pair u = unit(pose_.guides[at_index(index)]);
        slot_along(joint.bodies[0], joint.bodies[1], pose_.at(joint.point), u);
    }
    void slot_along(BodyIndex i, BodyIndex j, const Vector& place, const Pair& u) {
        equal_speeds(i, j, place, quarter(u), 0,
                     [=, this] { return 2 * omega(j) * inner(u, speed(i, place) - speed(j, place)); });
    }

    /// About C of j, at distance ρ, at s along z×n:  n·(a_i − a_j) = −s²/ρ − 2 ω_j s, n from C to P.
    void slide_on_arc(const Joint& joint) {
        const Vector place = pose_.at(joint.point);
        const Vector radius = place - pose_.at(joint.arc);
        const Pair n = unit(radius);
        const double rho = length(radius) / size_;
        const BodyIndex i = joint.bodies[0];
        const BodyIndex j = joint.bodies[1];
        equal_speeds(i, j, place, n, 0, [=, this] {
            const double s = inner(quarter(n), speed(i, place) - speed(j, place));
            return -s * s / rho - 2 * omega(j) * s;
        });
    }

    /// The position of the profile's centre of curvature along the normal, divided by the size; empty for a straight
    /// profile.
    struct Curvature {
        bool stated = false;
        bool straight = false;
        double centre = 0;
        Vector place;  ///< the centre itself
    };
    Curvature curvature(const Joint& joint, BodyIndex body, const Pair& n) const {
        const auto found = joint.profiles.find(body);
        if (found == joint.profiles.end()) return {};
        if (std::holds_alternative<LineProfile>(found->second)) return {true, true, 0, {}};
        const auto* circle = std::get_if<CircleProfile>(&found->second);
        const Vector place = pose_.at(circle == nullptr ? joint.point : circle->centre);
        const Pair reach = rough(place - pose_.at(joint.point));
        return {true, false, inner(n, reach) / size_, place};
    }

    /// Rolling: the points in contact differ by ω_ij² / (1/x_i − 1/x_j) along n, x the centres' places along n (a line
    /// has 1/x = 0).
    void roll(const Joint& joint, JointIndex index) {
        const BodyIndex i = joint.bodies[0];
        const BodyIndex j = joint.bodies[1];
        const Vector place = pose_.at(joint.point);
        const Pair n = unit(pose_.normals[at_index(index)]);
        const Curvature on_i = curvature(joint, i, n);
        const Curvature on_j = curvature(joint, j, n);
        std::optional<double> lever;
        if (on_i.stated && on_j.stated) {
            if (on_i.straight != on_j.straight) lever = on_j.straight ? on_i.centre : -on_j.centre;
            if (!on_i.straight && !on_j.straight && !same_place(on_i, on_j)) {
                lever = on_i.centre * on_j.centre / (on_j.centre - on_i.centre);
            }
        }
        equal_speeds(i, j, place, n, 0, [=, this]() -> std::optional<double> {
            if (!lever) return std::nullopt;
            return *lever * square_of(omega(i) - omega(j));
        });
        equal_speeds(i, j, place, quarter(n), 0, [] { return 0.0; });
    }
    static bool same_place(const Curvature& a, const Curvature& b) {
        constexpr double same = 1e-12;
        return std::abs(a.centre - b.centre) <= same * std::max(std::abs(a.centre), std::abs(b.centre));
    }

    /// Sliding contact: to second order a rod between the centres of curvature, or a pin at the one centre in a
    /// straight slot.
    void touch(const Joint& joint, JointIndex index) {
        const BodyIndex i = joint.bodies[0];
        const BodyIndex j = joint.bodies[1];
        const Pair n = unit(pose_.normals[at_index(index)]);
        const Pair u{n[1], -n[0]};  // n = z×u
        const Curvature on_i = curvature(joint, i, n);
        const Curvature on_j = curvature(joint, j, n);
        if (on_i.stated && on_j.stated && on_i.straight != on_j.straight) {
            if (on_j.straight) {
                slot_along(i, j, on_i.place, u);
            } else {
                slot_along(j, i, on_j.place, u);
            }
            return;
        }
        if (!on_i.stated || !on_j.stated || on_i.straight || same_place(on_i, on_j)) {
            equal_speeds(i, j, pose_.at(joint.point), n, 0, [] { return std::optional<double>(); });
            return;
        }
        Row row;
        add_speed(row, i, on_i.place, n, 1);
        add_speed(row, j, on_j.place, n, -1);
        const double rod = on_i.centre - on_j.centre;  // from C_j to C_i along n
        enter(std::move(row), 0, [=, this] {
            const Pair relative = speed(i, on_i.place) - speed(j, on_j.place);
            return -inner(relative, relative) / rod + centripetal(i, on_i.place, j, on_j.place, n);
        });
    }

    /// Gears: equal velocities along the common tangent of the pitch curves. Relative to the arm k that carries both
    /// centres,
    ///   (ω_i − ω_k) x_i = (ω_j − ω_k) x_j  at every instant, so the same holds for the α. Substituted into the
    ///   accelerations at P, the terms of the arm cancel and the tangential components are equal (the remainder is
    ///   along the normal). The same is true for a rack.
    void mesh(const Joint& joint, JointIndex index) {
        const Pair t = unit(pose_.tangents[at_index(index)]);
        equal_speeds(joint.bodies[0], joint.bodies[1], pose_.at(joint.point), t, 0, [] { return 0.0; });
    }

    // --- drivers
    // -------------------------------------------------------------------------------------------------------------
    void write(const SpinDriver& driver) {
        equal_turns(driver.body, driver.relative_to, driver.omega.to_double(), driver.alpha.to_double());
    }
    /// Second derivative of the coordinate along u, relative to j: u·(a_i − a_j), because the Coriolis term is
    /// perpendicular to u.
    void write(const SlideDriver& driver) {
        const Joint& joint = mechanism_.joint(driver.joint);
        const Vector place = pose_.at(joint.point);
        const bool straight = !pose_.guides[at_index(driver.joint)].is_zero();
        const Pair u = straight ? unit(pose_.guides[at_index(driver.joint)])
                                : quarter(unit(pose_.normals[at_index(driver.joint)]));
        const double second = driver.acceleration.to_double() / size_;
        equal_speeds(joint.bodies[0], joint.bodies[1], place, u, driver.speed.to_double() / size_,
                     [=] { return second; });
    }
    void write(const PointDriver& driver) {
        const double second = driver.acceleration.to_double() / size_;
        equal_speeds(driver.body, frame, pose_.at(driver.at), unit(direction_of(driver.along, pose_)),
                     driver.speed.to_double() / size_, [=] { return second; });
    }
    void write(const InstantaneousMotion& motion) {
        // A given direction means that the perpendicular component is zero. Accelerations are separate rows, without
        // given velocities: both lists are written as rows of one of the two systems only.
        given(motion.body, motion.velocities, true);
        given(motion.body, motion.accelerations, false);
    }
    void given(BodyIndex body, const std::vector<GivenMotion>& values, bool velocity) {
        for (const GivenMotion& each : values) {
            const Vector place = pose_.at(each.point);
            const auto enter_component = [&](const Pair& n, double value) {
                Row row;
                add_speed(row, body, place, n, 1);
                if (velocity) {
                    enter(std::move(row), value, [] { return std::nullopt; });
                } else {
                    later_.emplace_back(std::move(row), [=, this] {
                        return value + square_of(omega(body)) * inner(n, arm(body, place));
                    });
                }
            };
            if (const auto* vector = std::get_if<Vector>(&each.value)) {
                enter_component({1, 0}, vector->x.to_double() / size_);
                enter_component({0, 1}, vector->y.to_double() / size_);
            } else {
                enter_component(quarter(unit(direction_of(std::get<Bearing>(each.value), pose_))), 0);
            }
        }
    }

    const Mechanism& mechanism_;
    const Pose& pose_;
    double size_, rounding_;
    Eigen::Index columns_;
    NumericMotion motion_;
    std::vector<Vector> references_;  ///< the states' references as exact places
    std::vector<Row> rows_;
    std::vector<SecondOrder>
        second_order_;  ///< by row: the right side of its accelerations, once the velocities are known
    std::vector<std::pair<Row, SecondOrder>> later_;  ///< rows for accelerations only
};

}  // namespace

NumericMotion check_motion(const Mechanism& mechanism, const Pose& pose) {
    return CheckOfMotion(mechanism, pose).run();
}

std::array<double, 2> NumericMotion::arm(BodyIndex body, const Vector& place) const {
    const Vector reference = exactly(bodies[at_index(body)].reference);
    return {difference_to_double(place.x, reference.x), difference_to_double(place.y, reference.y)};
}

std::array<double, 2> NumericMotion::velocity_at_arm(BodyIndex body, const Pair& arm) const {
    const BodyState& state = bodies[at_index(body)];
    return {state.velocity[0] - state.omega * arm[1], state.velocity[1] + state.omega * arm[0]};
}

std::array<double, 2> NumericMotion::acceleration_at_arm(BodyIndex body, const Pair& arm) const {
    const BodyState& state = bodies[at_index(body)];
    const double squared = state.omega * state.omega;
    return {state.acceleration[0] - state.alpha * arm[1] - squared * arm[0],
            state.acceleration[1] + state.alpha * arm[0] - squared * arm[1]};
}

}  // namespace kinegraph
