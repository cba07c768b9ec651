// FollowedColumns: the columns of a cycle as functions over its whole travel, stretch by stretch: poles, zeros,
// extremes, means, and where a quantity is negative.
#pragma once

#include <utility>
#include <vector>

#include "constructions/positions/followed_curve.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph {

class FollowedColumns {
public:
    /// The stretches in order, each with the same functions.
    explicit FollowedColumns(std::vector<FollowedCurve> curves) : curves_(std::move(curves)) {}

    /// Function `i`. Unless `whole`, only its poles.
    FollowedColumn column(std::size_t i, bool whole) const;
    /// Where function `i` grows without limit at a limit; nothing else of it.
    FollowedColumn at_limits(std::size_t i) const;
    /// Where function `i` is negative, in order.
    std::vector<std::pair<double, double>> negative(std::size_t i) const;

private:
    std::vector<FollowedCurve> curves_;
};

}  // namespace kinegraph
