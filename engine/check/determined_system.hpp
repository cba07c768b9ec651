// A system of linear equations that need not determine all of its unknowns: one solution, and what all solutions have
// in common. Householder's QR with column pivoting (Businger and Golub 1965) gives rank and null space; residuals in
// twice the digits refine the solution.
#pragma once

#include <Eigen/Dense>

#include <optional>
#include <vector>

#include "engine/check/plane_pair.hpp"

namespace kinegraph::numeric {

/// The largest |a_i|; 0 if empty.
double largest(const Eigen::VectorXd& a);

/// A x = b in the least-squares sense, with refinement, and which components of x the equations determine.
class DeterminedSystem {
public:
    /// `matrix`: A, of any shape, also without rows or columns. `doubt`: relative error of a pivot due to rounded
    /// points, as a share of the largest pivot.
    DeterminedSystem(const Eigen::MatrixXd& matrix, double doubt);

    /// Values below this share of the largest value count as zero, where points are rounded by `doubt`.
    static double nothing(double doubt);

    Eigen::Index rank() const { return is_empty() ? 0 : orthogonal_.rank(); }
    /// x, a value for each column; undetermined ones are arbitrary.
    Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
    /// b − A x.
    Eigen::VectorXd residual(const Eigen::VectorXd& right, const Eigen::VectorXd& x) const;
    /// By unknown: whether it has the same value in all solutions.
    std::vector<bool> determined() const;
    /// For the unknowns `first` and the next, x_i and x_j: the unit vector (c, s), c ≥ 0, such that c·x_i + s·x_j is
    /// the same in all solutions. None where there is no such combination, or where both unknowns are determined.
    std::optional<Pair> common_direction(Eigen::Index first) const;

private:
    bool is_empty() const { return matrix_.rows() == 0 || matrix_.cols() == 0; }
    Eigen::MatrixXd null_space() const;
    Eigen::VectorXd scaled_residual(const Eigen::VectorXd& right, const Eigen::VectorXd& x) const;
    Eigen::VectorXd particular(const Eigen::VectorXd& right) const;

    Eigen::MatrixXd matrix_;  ///< columns scaled to equal size
    Eigen::VectorXd scale_;   ///< by column: its scale factor
    double nothing_;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> orthogonal_;
};

}  // namespace kinegraph::numeric
