// Elimination: Gauss with complete pivoting on a small dense matrix of doubles; it also finds the rank. Storage is
// allocated once. There may be more equations than unknowns, and they may be dependent.
#pragma once

#include <cstddef>
#include <vector>

namespace kinegraph {

class Elimination {
public:
    void resize(std::size_t rows, std::size_t columns);
    std::size_t rows() const { return rows_; }
    std::size_t columns() const { return columns_; }
    /// Row i, to be filled before factor().
    double* row(std::size_t i) { return matrix_.data() + i * columns_; }
    void clear();

    void factor();
    /// |pivot k| divided by the first pivot. Pivots decrease; a share below `vanishing` is rounding.
    double pivot_share(std::size_t k) const;
    std::size_t rank() const { return rank_; }
    /// Sign of the determinant of a square matrix.
    int sign() const { return sign_; }
    std::size_t row_of_pivot(std::size_t k) const { return row_at_[k]; }
    std::size_t column_of_pivot(std::size_t k) const { return column_at_[k]; }
    /// x with A x = b in the rows of the pivots; unknowns without a pivot are zero. Overwrites b.
    void solve(std::vector<double>& b, std::vector<double>& x) const;

    /// A pivot below this share of the largest one is the rounding error of a dependent row.
    static constexpr double vanishing = 1e-11;

private:
    std::size_t rows_ = 0, columns_ = 0, rank_ = 0;
    int sign_ = 1;
    std::vector<double> matrix_;
    std::vector<std::size_t> row_at_, column_at_;
};

}  // namespace kinegraph
