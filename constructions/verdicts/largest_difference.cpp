#include "constructions/verdicts/largest_difference.hpp"

#include <algorithm>
#include <cmath>

namespace kinegraph {

using Kind = Quantity::Kind;

void LargestDifference::hold(std::size_t column, const Column& of, double value, double numeric, double coordinate) {
    const auto kind = static_cast<std::size_t>(of.quantity.kind);
    off_.resize(std::max(off_.size(), column + 1));
    largest_.resize(std::max(largest_.size(), kind + 1));
    const double size = std::max(std::abs(value), std::abs(numeric)), off = std::abs(value - numeric);
    largest_[kind] = std::max(largest_[kind], size);
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
        const Kind kind = columns[i].quantity.kind;
        // A quantity without a kind is compared with its own largest value.
        const double unit = kind == Kind::unnamed ? off.largest : measure(kind, size);
        if (!off.held || unit == 0) continue;
        const double share = off.most / unit;
        if (worst.column < 0 || share > worst.share) worst = {share, static_cast<int>(i), off.coordinate};
    }
    return worst;
}

double LargestDifference::measure(Kind kind, double size) const {
    const auto of = [&](Kind each) {
        const auto index = static_cast<std::size_t>(each);
        return index < largest_.size() ? largest_[index] : 0.0;
    };
    const double v = std::max({of(Kind::velocity), of(Kind::sliding_velocity), of(Kind::omega) * size});
    const double a =
        std::max({of(Kind::acceleration), of(Kind::sliding_acceleration), of(Kind::alpha) * size, v * v / size});
    const double f = std::max({of(Kind::force), of(Kind::couple) / size});
    switch (kind) {
        case Kind::omega: return v / size;
        case Kind::alpha: return a / size;
        case Kind::velocity:
        case Kind::sliding_velocity: return v;
        case Kind::acceleration:
        case Kind::sliding_acceleration: return a;
        case Kind::force: return f;
        case Kind::couple: return f * size;
        default: return of(kind);
    }
}

}  // namespace kinegraph
