#include "constructions/verdicts/largest_difference.hpp"

#include <algorithm>
#include <cmath>

#include "engine/sentences/result_catalogue.hpp"

namespace kinegraph {

namespace {

using Scale = ResultKind::Scale;

/// The place of a column's scale among all: one for each unit, that of efforts behind these.
std::size_t scale_of(const Column& column) {
    return result_kind(column.quantity).scale == Scale::efforts ? count_of_quantity_kinds
                                                                : static_cast<std::size_t>(column.unit);
}

}  // namespace

void LargestDifference::hold(std::size_t column, const Column& of, double value, double numeric, double coordinate) {
    const std::size_t unit = scale_of(of);
    off_.resize(std::max(off_.size(), column + 1));
    largest_.resize(std::max(largest_.size(), unit + 1));
    const double size = std::max(std::abs(value), std::abs(numeric)), off = std::abs(value - numeric);
    largest_[unit] = std::max(largest_[unit], size);
    Off& most = off_[column];
    most.largest = std::max(most.largest, size);
    if (!most.held || off > most.most) {
        most.most = off;
        most.coordinate = coordinate;
    }
    most.held = true;
}

LargestDifference::Found LargestDifference::found(std::span<const Column> columns, double size) const {
    Found worst;
    for (std::size_t i = 0; i < std::min(columns.size(), off_.size()); ++i) {
        const Off& off = off_[i];
        const bool by_itself = result_kind(columns[i].quantity).scale == Scale::own;
        const double unit = by_itself ? off.largest : measure(columns[i], size);
        if (!off.held || unit == 0) continue;
        const double share = off.most / unit;
        if (worst.column < 0 || share > worst.share) worst = {share, static_cast<int>(i), off.coordinate};
    }
    return worst;
}

double LargestDifference::measure(const Column& column, double size) const {
    const auto at = [&](std::size_t scale) { return scale < largest_.size() ? largest_[scale] : 0.0; };
    if (scale_of(column) == count_of_quantity_kinds) return at(count_of_quantity_kinds);
    const auto most = [&](QuantityKind scale) {
        double largest = 0;
        for (std::size_t i = 0; i < count_of_quantity_kinds; ++i)
            if (const Tolerance& of = tolerance_of(static_cast<QuantityKind>(i)); of.scale == scale)
                largest = std::max(largest, of.back(at(i), size));
        return largest;
    };
    const Tolerance& tolerance = tolerance_of(column.unit);
    double largest = most(tolerance.scale);
    if (tolerance.scale == QuantityKind::acceleration) {
        const double v = most(QuantityKind::velocity);
        largest = std::max(largest, v * v / size);
    }
    return tolerance.across(largest, size);
}

}  // namespace kinegraph
