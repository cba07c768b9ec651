// The columns of a table that are expressions of its other columns (engine/results/result_expression.hpp). They come
// last, and one may be made of an earlier one.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/results/result_expression.hpp"

namespace kinegraph {

class ExpressionColumns {
public:
    std::size_t size() const { return all_.size(); }
    /// Adds the column of an expression of `columns` behind them; its index.
    /// Its parameters are in the order of `parameters`.
    std::size_t add(const ResultExpression& expression, std::vector<Column>& columns,
                    const std::vector<NamedParameter>& parameters);
    /// Sets their values in a row, and by how much they may be off, from those of the columns before. A value that is
    /// not determined there is 0. `lacking`: by column, whether the row has no value. `parameters`: those of the file.
    void fill(std::vector<double>& row, std::vector<double>& noise, const std::vector<bool>& lacking,
              const std::vector<NamedParameter>& parameters);
    /// Whether the last row has no value in this column; false for a column that is no expression.
    bool is_undetermined(std::size_t column) const;
    /// Whether a column that has no value leaves an expression without one.
    bool lacks_part(std::size_t column, const std::vector<bool>& empty) const;

private:
    struct Each {
        ResultExpression expression;
        std::size_t column;
        struct Part {
            bool is_parameter = false;
            std::size_t index = 0;  ///< of a column, or of a parameter
        };
        std::vector<Part> parts;
        bool is_determined = true;
    };
    const Each* of_column(std::size_t column) const;

    std::vector<Each> all_;
};

}  // namespace kinegraph
