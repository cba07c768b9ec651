// Equilibrium of every body as linear equations in doubles. Owns the model of each pair's reaction and the units in
// which the equations are well conditioned; how they are solved it does not know.
//
// Unknowns, a column each: joint by joint the components of the reactions (revolute, rolling: two; prismatic: force ⟂
// guide and couple; pin-slot, contact, gear: force along the normal; weld: two and a couple), then the efforts.
// Equations, three rows for each body but the frame:
//   Σ F = 0,      Σ (P − R) × F + Σ M = 0      about its reference R.
// At a hinge of three bodies or more each body meets a massless pin, whose own Σ F = 0 are rows after those of the
// bodies. Forces are counted in units of the largest load, couples in that times the drawing's size, moments over the
// body's own size.
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
    /// How far rounded points may move a pivot, relative to the largest one.
    double doubt() const { return doubt_; }
    /// `clockwise`, by joint: of a gear, which of its two lines of action holds; the pose has the one turned
    /// counter-clockwise.
    Eigen::MatrixXd matrix(const std::vector<bool>& clockwise) const;
    /// By row: what is given, with the opposite sign.
    const Eigen::VectorXd& right_side() const { return right_; }

    // Rows.
    /// The first of a body's three; not of the frame.
    static Index row_of(BodyIndex body) { return Index{3} * (body.number() - 1); }
    /// A row of a body, not of a pin.
    bool is_of_body(Index row) const { return row < row_of(BodyIndex(mechanism_.bodies.size())); }

    // Columns.
    Index first_column(JointIndex joint) const { return first_column_[at_index(joint)]; }
    Index column_of_effort(std::size_t effort) const { return first_effort_ + static_cast<Index>(effort); }
    /// Unit vectors of a joint's force: there is a column for each, then one for the couple where the joint carries
    /// one; all that once, on the first body by the second, or where the joint has a pin of its own once for each body,
    /// by the pin.
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
    std::vector<double> own_size_;    ///< by body: what its moments are divided by, m
    Index rows_ = 0, columns_ = 0, first_effort_ = 0;
    std::vector<Index> first_column_, first_pin_row_;  ///< by joint
    Eigen::VectorXd right_;
};

}  // namespace kinegraph::numeric
