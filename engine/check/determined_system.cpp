#include "engine/check/determined_system.hpp"

#include <algorithm>
#include <cmath>

#include "engine/number/wide.hpp"

namespace kinegraph::numeric {
namespace {

using Eigen::Index;

/// Smaller pivots cannot be distinguished from redundant constraints: a point may miss its curve by 1e-9 of the size.
constexpr double rank_threshold = 1e-9;
/// The residue of cancelling sums of doubles stays well below this.
constexpr double least_nothing = 1e-8;

}  // namespace

double largest(const Eigen::VectorXd& a) { return a.size() == 0 ? 0 : a.cwiseAbs().maxCoeff(); }

double DeterminedSystem::nothing(double doubt) { return std::max(least_nothing, doubt); }

DeterminedSystem::DeterminedSystem(const Eigen::MatrixXd& matrix, double doubt)
    : matrix_(matrix), scale_(Eigen::VectorXd::Ones(matrix.cols())), nothing_(nothing(doubt)) {
    if (is_empty()) return;
    for (Index j = 0; j < matrix_.cols(); ++j) {
        const double size = matrix_.col(j).cwiseAbs().maxCoeff();
        if (size > 0) scale_[j] = 1 / size;
    }
    matrix_ = matrix_ * scale_.asDiagonal();
    orthogonal_.setThreshold(std::max(rank_threshold, doubt));
    orthogonal_.compute(matrix_);
}

Eigen::VectorXd DeterminedSystem::solve(const Eigen::VectorXd& right) const {
    if (is_empty()) return Eigen::VectorXd::Zero(matrix_.cols());
    Eigen::VectorXd x = particular(right);
    constexpr int refinements = 2;
    for (int i = 0; i < refinements; ++i) x += particular(scaled_residual(right, x));
    return scale_.cwiseProduct(x);
}

Eigen::VectorXd DeterminedSystem::residual(const Eigen::VectorXd& right, const Eigen::VectorXd& x) const {
    return scaled_residual(right, x.cwiseQuotient(scale_));
}

/// A basis of the null space, a column each, in scaled unknowns.
Eigen::MatrixXd DeterminedSystem::null_space() const {
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

std::vector<bool> DeterminedSystem::determined() const {
    const Eigen::MatrixXd null = null_space();
    std::vector<bool> known(static_cast<std::size_t>(matrix_.cols()), true);
    for (Index i = 0; i < matrix_.cols() && null.cols() > 0; ++i)
        known[static_cast<std::size_t>(i)] = null.row(i).cwiseAbs().maxCoeff() < nothing_;
    return known;
}

std::optional<Pair> DeterminedSystem::common_direction(Index first) const {
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

Eigen::VectorXd DeterminedSystem::scaled_residual(const Eigen::VectorXd& right, const Eigen::VectorXd& x) const {
    Eigen::VectorXd miss(right.size());
    for (Index i = 0; i < matrix_.rows(); ++i) {
        wide::Wide sum{right[i]};
        for (Index j = 0; j < matrix_.cols(); ++j) sum = sum - wide::product_of(matrix_(i, j), x[j]);
        miss[i] = sum.rounded();
    }
    return miss;
}

/// With zero for the free unknowns.
Eigen::VectorXd DeterminedSystem::particular(const Eigen::VectorXd& right) const {
    const Eigen::VectorXd turned = orthogonal_.householderQ().transpose() * right;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(matrix_.cols());
    x.head(rank()) =
        orthogonal_.matrixQR().topLeftCorner(rank(), rank()).triangularView<Eigen::Upper>().solve(turned.head(rank()));
    return orthogonal_.colsPermutation() * x;
}

}  // namespace kinegraph::numeric
