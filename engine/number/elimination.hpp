// Elimination: Gauss with complete pivoting on a small dense matrix of doubles, which says its rank as it goes. Storage
// is made once; equations may be more than unknowns and repeat each other.
#pragma once

#include <cstddef>
#include <vector>

namespace kinegraph {

class Elimination {
public:
    void resize(std::size_t rows, std::size_t columns);
    std::size_t rows() const { return rows_; }
    std::size_t columns() const { return columns_; }
    /// Row i, to be written before factor().
    double* row(std::size_t i) { return matrix_.data() + i * columns_; }
    void clear();

    void factor();
    /// |pivot k| over the first; pivots fall off, and what lies below `vanishing` was rounding.
    double pivot_share(std::size_t k) const;
    std::size_t rank() const { return rank_; }
    /// Of the determinant of a square matrix.
    int sign() const { return sign_; }
    std::size_t row_of_pivot(std::size_t k) const { return row_at_[k]; }
    std::size_t column_of_pivot(std::size_t k) const { return column_at_[k]; }
    /// x with A x = b in the rows of the pivots; unknowns without a pivot are zero. b is used up.
    void solve(std::vector<double>& b, std::vector<double>& x) const;

    /// What is this much smaller than the largest pivot is the rounding of a row that repeats others.
    static constexpr double vanishing = 1e-11;

private:
    std::size_t rows_ = 0, columns_ = 0, rank_ = 0;
    int sign_ = 1;
    std::vector<double> matrix_;
    std::vector<std::size_t> row_at_, column_at_;
};

}  // namespace kinegraph
