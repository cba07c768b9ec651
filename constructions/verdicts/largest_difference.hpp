// The largest difference of many rows of results from the numeric check, relative to the largest value of its kind.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/sentences/column.hpp"

namespace kinegraph {

class LargestDifference {
public:
    /// Adds a value and that of the check, of one column, in the row at `coordinate`.
    void hold(std::size_t column, const Column& of, double value, double numeric, double coordinate);

    struct Found {
        double share = 0;
        int column = -1;  ///< none if there was no value
        double coordinate = 0;
    };
    /// `size`: of the drawing, m. Kinds of one motion share their scale across it: v = ωl.
    Found found(std::span<const Column> columns, double size) const;

private:
    struct Off {
        bool held = false;
        double most = 0, coordinate = 0, largest = 0;
    };
    double measure(const Column& column, double size) const;

    std::vector<Off> off_;         // by column
    std::vector<double> largest_;  // by unit, efforts apart
};

}  // namespace kinegraph
