// Elimination: the pivots are those of complete pivoting, rule by rule, and solutions satisfy their equations.
#include "engine/number/elimination.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace kinegraph::elimination_test {
namespace {

using Matrix = std::vector<std::vector<double>>;

/// Complete pivoting as in the books: the largest entry of what is left, the first where several are as large.
struct Plain {
    std::vector<std::size_t> rows, columns;
    std::size_t rank = 0;

    explicit Plain(Matrix a) {
        for (std::size_t i = 0; i < a.size(); ++i) rows.push_back(i);
        for (std::size_t j = 0; j < a[0].size(); ++j) columns.push_back(j);
        double first = 0;
        for (; rank < std::min(rows.size(), columns.size()); ++rank) {
            double largest = 0;
            std::size_t r = rank, c = rank;
            for (std::size_t i = rank; i < rows.size(); ++i)
                for (std::size_t j = rank; j < columns.size(); ++j)
                    if (std::abs(a[rows[i]][columns[j]]) > largest)
                        largest = std::abs(a[rows[i]][columns[j]]), r = i, c = j;
            if (rank == 0) first = largest;
            if (!(largest > Elimination::vanishing * first)) return;
            std::swap(rows[rank], rows[r]);
            std::swap(columns[rank], columns[c]);
            const std::vector<double> pivot = a[rows[rank]];
            for (std::size_t i = rank + 1; i < rows.size(); ++i) {
                const double factor = a[rows[i]][columns[rank]] / pivot[columns[rank]];
                for (std::size_t j = rank + 1; j < columns.size(); ++j)
                    a[rows[i]][columns[j]] -= factor * pivot[columns[j]];
            }
        }
    }
};

TEST(Elimination, ChoosesThePivotsOfCompletePivoting) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 2000; ++trial) {
        const std::size_t height = 1 + random() % 12, width = 1 + random() % 12;
        const unsigned density = 1 + random() % 4;
        Matrix a(height, std::vector<double>(width));
        Elimination elimination;
        elimination.resize(height, width);
        for (std::size_t i = 0; i < height; ++i)
            for (std::size_t j = 0; j < width; ++j) {
                // Small integers make many ties.
                if (random() % 4 < density) a[i][j] = static_cast<double>(random() % 7) - 3;
                elimination.row(i)[j] = a[i][j];
            }
        elimination.factor();
        const Plain plain(a);
        ASSERT_EQ(elimination.rank(), plain.rank);
        for (std::size_t k = 0; k < plain.rank; ++k) {
            EXPECT_EQ(elimination.row_of_pivot(k), plain.rows[k]);
            EXPECT_EQ(elimination.column_of_pivot(k), plain.columns[k]);
        }
    }
}

TEST(Elimination, SolvesALongChain) {
    constexpr std::size_t size = 600;
    Elimination elimination;
    elimination.resize(size, size);
    const auto entry = [](std::size_t i, std::size_t j) {
        return i == j ? 3.0 : i + 1 == j || j + 1 == i ? -1.0 : 0.0;
    };
    std::vector<double> b(size, 1), x(size);
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j) elimination.row(i)[j] = entry(i, j);
    elimination.factor();
    ASSERT_EQ(elimination.rank(), size);
    elimination.solve(b, x);
    for (std::size_t i = 0; i < size; ++i) {
        double sum = 0;
        for (std::size_t j = i == 0 ? 0 : i - 1; j < std::min(size, i + 2); ++j) sum += entry(i, j) * x[j];
        EXPECT_NEAR(sum, 1, 1e-12);
    }
}

}  // namespace
}  // namespace kinegraph::elimination_test
