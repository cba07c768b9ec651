#include "engine/number/elimination.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kinegraph {

void Elimination::resize(std::size_t rows, std::size_t columns) {
    rows_ = rows;
    columns_ = columns;
    matrix_.assign(rows * columns, 0);
    row_at_.resize(rows);
    column_at_.resize(columns);
}

void Elimination::clear() { std::fill(matrix_.begin(), matrix_.end(), 0.0); }

/// Rows and columns are not swapped; row_at_ and column_at_ store their order. L is stored below the pivots.
void Elimination::factor() {
    for (std::size_t i = 0; i < rows_; ++i) row_at_[i] = i;
    for (std::size_t j = 0; j < columns_; ++j) column_at_[j] = j;
    const std::size_t most = std::min(rows_, columns_);
    double first = 0;
    sign_ = 1;
    for (rank_ = 0; rank_ < most; ++rank_) {
        const std::size_t k = rank_;
        double largest = 0;
        std::size_t best_row = k, best_column = k;
        for (std::size_t i = k; i < rows_; ++i) {
            const double* line = row(row_at_[i]);
            for (std::size_t j = k; j < columns_; ++j) {
                const double size = std::abs(line[column_at_[j]]);
                if (size > largest) {
                    largest = size;
                    best_row = i;
                    best_column = j;
                }
            }
        }
        if (k == 0) first = largest;
        if (!(largest > vanishing * first)) break;
        if (best_row != k) sign_ = -sign_;
        if (best_column != k) sign_ = -sign_;
        std::swap(row_at_[k], row_at_[best_row]);
        std::swap(column_at_[k], column_at_[best_column]);
        const double* pivot_row = row(row_at_[k]);
        const double pivot = pivot_row[column_at_[k]];
        if (pivot < 0) sign_ = -sign_;
        for (std::size_t i = k + 1; i < rows_; ++i) {
            double* line = row(row_at_[i]);
            double& head = line[column_at_[k]];
            if (head == 0) continue;
            head /= pivot;
            for (std::size_t j = k + 1; j < columns_; ++j) line[column_at_[j]] -= head * pivot_row[column_at_[j]];
        }
    }
}

double Elimination::pivot_share(std::size_t k) const {
    if (k >= rank_) return 0;
    const auto pivot = [&](std::size_t i) { return std::abs(matrix_[row_at_[i] * columns_ + column_at_[i]]); };
    return pivot(k) / pivot(0);
}

void Elimination::solve(std::vector<double>& b, std::vector<double>& x) const {
    std::fill(x.begin(), x.end(), 0.0);
    for (std::size_t i = 1; i < rank_; ++i) {
        const double* line = matrix_.data() + row_at_[i] * columns_;
        for (std::size_t k = 0; k < i; ++k) b[row_at_[i]] -= line[column_at_[k]] * b[row_at_[k]];
    }
    for (std::size_t i = rank_; i-- > 0;) {
        const double* line = matrix_.data() + row_at_[i] * columns_;
        double sum = b[row_at_[i]];
        for (std::size_t j = i + 1; j < rank_; ++j) sum -= line[column_at_[j]] * x[column_at_[j]];
        x[column_at_[i]] = sum / line[column_at_[i]];
    }
}

}  // namespace kinegraph
