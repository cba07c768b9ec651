// The columns of a table that are expressions of its other columns (engine/results/result_expression.hpp). They come
// last, and one may be made of an earlier one.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/results/result_expression.hpp"

namespace kinegraph {

class ExpressionColumns {
public:
    std::size_t size() const { return all_.size(); }
    /// Adds the column of an expression of `columns` behind them; its index.
    std::size_t add(const ResultExpression& expression, std::vector<Column>& columns);
    /// Sets their values in a row, and by how much they may be off, from those of the columns before. A value that is
    /// not determined there is 0.
    void fill(std::vector<double>& row, std::vector<double>& noise);
    /// Whether the last row has no value in this column; false for a column that is no expression.
    bool is_undetermined(std::size_t column) const;
    /// Whether a column that has no value leaves an expression without one.
    bool lacks_part(std::size_t column, const std::vector<bool>& empty) const;

private:
    struct Each {
        ResultExpression expression;
        std::size_t column;
        std::vector<std::size_t> parts;  ///< columns
        bool is_determined = true;
    };
    const Each* of_column(std::size_t column) const;

    std::vector<Each> all_;
};

}  // namespace kinegraph
