// The largest difference of many rows of results from the numeric check, as a share of the largest of its kind. Knows
// neither how rows are found nor how they are checked.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/sentences/column.hpp"

namespace kinegraph {

class LargestDifference {
public:
    /// A value and the check's, of a column, in the row at `coordinate`.
    void hold(std::size_t column, const Column& of, double value, double numeric, double coordinate);

    struct Found {
        double share = 0;
        int column = -1;  ///< none was held
        double coordinate = 0;
    };
    /// `size`: of the drawing, m. Kinds that one motion ties together share their measure across it: v = ωl.
    Found found(std::span<const Column> columns, double size) const;

private:
    struct Off {
        bool held = false;
        double most = 0, coordinate = 0, largest = 0;
    };
    double measure(Quantity::Kind kind, double size) const;

    std::vector<Off> off_;         // by column
    std::vector<double> largest_;  // by kind
};

}  // namespace kinegraph
