#include "constructions/verdicts/largest_difference.hpp"

#include <algorithm>
#include <cmath>

#include "engine/sentences/result_catalogue.hpp"

namespace kinegraph {

namespace {

bool is_effort(const Column& column) { return result_kind(column.quantity).subject == ResultKind::Subject::effort; }
/// The place of a column's scale among all: one for each unit; efforts, which may be far below the reactions, have
/// their own behind these.
std::size_t scale_of(const Column& column) {
    return is_effort(column) ? count_of_quantity_kinds : static_cast<std::size_t>(column.unit);
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
        // A quantity without a kind is compared with its own largest value.
        const bool is_named = columns[i].quantity.kind != Quantity::Kind::unnamed;
        const double unit = is_named ? measure(columns[i], size) : off.largest;
        if (!off.held || unit == 0) continue;
        const double share = off.most / unit;
        if (worst.column < 0 || share > worst.share) worst = {share, static_cast<int>(i), off.coordinate};
    }
    return worst;
}

double LargestDifference::measure(const Column& column, double size) const {
    using enum QuantityKind;
    const auto at = [&](std::size_t unit) { return unit < largest_.size() ? largest_[unit] : 0.0; };
    const auto of = [&](QuantityKind unit) { return at(static_cast<std::size_t>(unit)); };
    if (is_effort(column)) return at(scale_of(column));
    const double v = std::max({of(velocity), of(angular_velocity) * size});
    const double a = std::max({of(acceleration), of(angular_acceleration) * size, v * v / size});
    const double f = std::max({of(force), of(moment) / size});
    switch (column.unit) {
        case angular_velocity: return v / size;
        case angular_acceleration: return a / size;
        case velocity: return v;
        case acceleration: return a;
        case force: return f;
        case moment: return f * size;
        default: return of(column.unit);
    }
}

}  // namespace kinegraph
