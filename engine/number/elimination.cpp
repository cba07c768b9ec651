#include "engine/number/elimination.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

namespace {

/// The largest entry of a row: where several are equally large, the first.
struct RowMaximum {
    double size = 0;
    std::size_t column = 0;  ///< of the matrix
};

RowMaximum maximum_of(const double* line, const std::vector<std::size_t>& column_at, std::size_t from) {
    RowMaximum found;
    for (std::size_t j = from; j < column_at.size(); ++j) {
        const double size = std::abs(line[column_at[j]]);
        if (size > found.size) found = {size, column_at[j]};
    }
    return found;
}

}  // namespace

/// Rows and columns are not swapped; row_at_ and column_at_ store their order. L is stored below the pivots. The
/// maximum of each row is kept and computed again only where the row changed, and zeros of the pivot row are skipped:
/// in the sparse equations of a long chain a step then costs little more than the rows that it changes.
void Elimination::factor() {
    for (std::size_t i = 0; i < rows_; ++i) row_at_[i] = i;
    for (std::size_t j = 0; j < columns_; ++j) column_at_[j] = j;
    const std::size_t most = std::min(rows_, columns_);
    std::vector<RowMaximum> maxima(rows_);
    for (std::size_t i = 0; i < rows_; ++i) maxima[i] = maximum_of(row(i), column_at_, 0);
    std::vector<std::size_t> filled;
    double first = 0;
    sign_ = 1;
    for (rank_ = 0; rank_ < most; ++rank_) {
        const std::size_t k = rank_;
        double largest = 0;
        std::size_t best_row = k;
        for (std::size_t i = k; i < rows_; ++i)
            if (maxima[row_at_[i]].size > largest) {
                largest = maxima[row_at_[i]].size;
                best_row = i;
            }
        if (k == 0) first = largest;
        if (!(largest > vanishing * first)) break;
        const std::size_t pivot_column = maxima[row_at_[best_row]].column, moved_column = column_at_[k];
        if (best_row != k) sign_ = -sign_;
        if (pivot_column != moved_column) sign_ = -sign_;
        std::swap(row_at_[k], row_at_[best_row]);
        std::swap(column_at_[k],
                  *std::find(column_at_.begin() + static_cast<std::ptrdiff_t>(k), column_at_.end(), pivot_column));
        const double* pivot_row = row(row_at_[k]);
        const double pivot = pivot_row[pivot_column];
        if (pivot < 0) sign_ = -sign_;
        filled.clear();
        for (std::size_t j = k + 1; j < columns_; ++j)
            if (pivot_row[column_at_[j]] != 0) filled.push_back(column_at_[j]);
        for (std::size_t i = k + 1; i < rows_; ++i) {
            double* line = row(row_at_[i]);
            RowMaximum& maximum = maxima[row_at_[i]];
            double& head = line[pivot_column];
            // The column that was moved back now comes after others of the same size.
            if (head == 0 && maximum.column != moved_column) continue;
            if (head != 0) {
                head /= pivot;
                for (const std::size_t column : filled) line[column] -= head * pivot_row[column];
            }
            maximum = maximum_of(line, column_at_, k + 1);
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
