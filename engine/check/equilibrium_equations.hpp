// Equilibrium of every body as linear equations in doubles. Owns the model of each pair's reaction and the scaling that
// makes the equations well conditioned. The solver is elsewhere.
//
// Unknowns, a column each: joint by joint the components of the reactions (revolute, rolling: two; prismatic: force ⟂
// guide and couple; pin-slot, contact, gear: force along the normal; weld: two and a couple), then the efforts.
// Equations, three rows for each body but the frame:
//   Σ F = 0,      Σ (P − R) × F + Σ M = 0      about its reference R.
// At a hinge of three bodies or more each body meets a massless pin. The pin's own Σ F = 0 are rows after those of the
// bodies. Forces are in units of the largest load, couples in that unit times the drawing's size, moments are divided
// by the body's own size.
#pragma once

#include <Eigen/Dense>

#include <vector>

#include "engine/check/given_loads.hpp"
#include "engine/check/plane_pair.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph::numeric {

class EquilibriumEquations {
public:
    using Index = Eigen::Index;

    EquilibriumEquations(const Mechanism& mechanism, const Pose& pose, const GivenLoads& given);

    Index rows() const { return rows_; }
    Index columns() const { return columns_; }
    /// Relative error of a pivot due to rounded points, as a share of the largest pivot.
    double doubt() const { return doubt_; }
    /// `clockwise`, by joint: for a gear, whether the line of action is the one turned clockwise; the pose has the one
    /// turned counter-clockwise.
    Eigen::MatrixXd matrix(const std::vector<bool>& clockwise) const;
    /// By row: minus the given loads.
    const Eigen::VectorXd& right_side() const { return right_; }

    // Rows.
    /// The first of a body's three rows; not defined for the frame.
    static Index row_of(BodyIndex body) { return Index{3} * (body.number() - 1); }
    /// Whether the row belongs to a body, not to a pin.
    bool is_of_body(Index row) const { return row < row_of(BodyIndex(mechanism_.bodies.size())); }

    // Columns.
    Index first_column(JointIndex joint) const { return first_column_[at_index(joint)]; }
    Index column_of_effort(std::size_t effort) const { return first_effort_ + static_cast<Index>(effort); }
    /// Unit vectors of a joint's force. Each has a column; one more column follows for the couple where the joint
    /// transmits one. They act on the first body, exerted by the second; where the joint has a pin of its own, there is
    /// one set for each body, exerted by the pin.
    std::vector<Pair> directions(JointIndex joint, bool clockwise) const;
    static bool carries_couple(const Joint& joint);

private:
    void measure_bodies(const GivenLoads& given);
    void lay_out();
    void write_right_side(const GivenLoads& given);
    double moment(BodyIndex body, const Vector& place, const Pair& force) const;
    void add_force(Eigen::MatrixXd& matrix, Index column, BodyIndex body, const Vector& place,
                   const Pair& direction) const;
    void add_couple(Eigen::MatrixXd& matrix, Index column, BodyIndex body, double sign) const;
    void write(Eigen::MatrixXd& matrix, JointIndex index, bool clockwise) const;
    void write(Eigen::MatrixXd& matrix, Index column, const CoupleEffort& effort) const;
    void write(Eigen::MatrixXd& matrix, Index column, const ForceEffort& effort) const;
    void write(Eigen::MatrixXd& matrix, Index column, const ActuatorEffort& effort) const;

    const Mechanism& mechanism_;
    const Pose& pose_;
    double size_;  ///< of the drawing, m
    double doubt_ = 0;
    std::vector<Vector> references_;  ///< by body
    std::vector<double> own_size_;    ///< by body: divisor of its moments, m
    Index rows_ = 0, columns_ = 0, first_effort_ = 0;
    std::vector<Index> first_column_, first_pin_row_;  ///< by joint
    Eigen::VectorXd right_;
};

}  // namespace kinegraph::numeric
