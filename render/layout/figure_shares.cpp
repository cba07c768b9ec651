// Implementation of figure_shares.hpp.
#include "render/layout/figure_shares.hpp"

#include <algorithm>

#include "render/content/sheet_parts.hpp"

namespace kinegraph::render {

FigureShares::FigureShares(std::vector<std::vector<FigureSize>> sizes) : sizes_(std::move(sizes)) {
    for (const std::vector<FigureSize>& figure : sizes_)
        for (const FigureSize& size : figure)
            for (const bool stacked : {false, true}) widths_[stacked ? 1 : 0].push_back(across(size, {stacked, false}));
    for (std::vector<double>& widths : widths_) {
        std::sort(widths.begin(), widths.end());
        widths.erase(std::unique(widths.begin(), widths.end()), widths.end());
    }
    for (std::size_t order = 0; order < ways_.size(); ++order) ways_[order].resize(widths_[order / 2].size() + 1);
}

double FigureShares::best_score_in(Spot room) const {
    constexpr double less_than_any = -1e300;
    double sum = 0;
    for (const std::vector<FigureSize>& figure : sizes_) {
        double most = less_than_any;
        for (const FigureSize& size : figure)
            if (size.x <= room.x && size.y <= room.y) most = std::max(most, size.score);
        sum += most;
    }
    return sum;
}

double FigureShares::along(const FigureSize& size, Order order) {
    return order.stacked ? size.y : size.x + (order.cornered ? size.wider : 0);
}
double FigureShares::across(const FigureSize& size, Order order) { return order.stacked ? size.x : size.y; }

std::size_t FigureShares::fitting_from(std::size_t figure, std::size_t first, double wide, Order order) const {
    const std::vector<FigureSize>& sizes = sizes_[figure];
    while (first < sizes.size() && across(sizes[first], order) > wide) ++first;
    return first;
}

/// For a single figure the sequence ends at its largest size that fits.
std::optional<FigureShares::Share> FigureShares::of_one(Spot room, Order order) const {
    const double whole = order.stacked ? room.y : room.x, wide = order.stacked ? room.x : room.y;
    for (const FigureSize& size : sizes_.front()) {
        const double own = along(size, order);
        if (own > whole || across(size, order) > wide) continue;
        return Share{size.score, std::max(own, 0.0), std::max(across(size, order), 0.0), own > 0 ? 1 : 0};
    }
    return std::nullopt;
}

std::optional<FigureShares::Share> FigureShares::in(Spot room, Order order) const {
    if (sizes_.size() == 1) return of_one(room, order);
    const double whole = order.stacked ? room.y : room.x, wide = order.stacked ? room.x : room.y;
    const std::vector<double>& widths = widths_[order.stacked ? 1 : 0];
    // There are few widths: a linear count is faster than a binary search.
    std::size_t reached = 0;
    for (const double each : widths) reached += each <= wide ? 1 : 0;
    Way& way = ways_[(order.stacked ? 2 : 0) + (order.cornered ? 1 : 0)][reached];
    go_until(way, whole, wide, order);
    if (way.shares.empty() || way.shares.back().length > whole) return std::nullopt;
    const auto found = std::partition_point(way.shares.begin(), way.shares.end(),
                                            [&](const Share& share) { return share.length > whole; });
    return *found;
}

std::vector<std::size_t> FigureShares::taken_in(Spot room, Order order) const {
    Way way;
    go_until(way, order.stacked ? room.y : room.x, order.stacked ? room.x : room.y, order);
    return std::move(way.now);
}

void FigureShares::go_until(Way& way, double whole, double wide, Order order) const {
    if (!way.begun) begin(way, wide, order);
    while (!way.ended && way.shares.back().length > whole) go_on(way, wide, order);
}

void FigureShares::begin(Way& way, double wide, Order order) const {
    way.begun = true;
    for (std::size_t f = 0; f < sizes_.size(); ++f) {
        way.now.push_back(fitting_from(f, 0, wide, order));
        way.ended = way.ended || way.now.back() == sizes_[f].size();
    }
    if (!way.ended) note(way, order);
}

void FigureShares::go_on(Way& way, double wide, Order order) const {
    std::optional<std::size_t> smaller;
    std::size_t size = 0;
    double least = 0;
    for (std::size_t f = 0; f < sizes_.size(); ++f) {
        const std::size_t coarser = fitting_from(f, way.now[f] + 1, wide, order);
        if (coarser == sizes_[f].size()) continue;
        const FigureSize &now = sizes_[f][way.now[f]], &next = sizes_[f][coarser];
        const double given = along(now, order) - along(next, order);
        const double price = (now.score - next.score) / std::max(given, 0.1);
        if (!smaller || price < least) smaller = f, size = coarser, least = price;
    }
    if (!smaller) {
        way.ended = true;
        return;
    }
    way.now[*smaller] = size;
    note(way, order);
}

/// Appends the current sizes unless an earlier share was as short.
void FigureShares::note(Way& way, Order order) const {
    Share share;
    for (std::size_t f = 0; f < sizes_.size(); ++f) {
        const FigureSize& size = sizes_[f][way.now[f]];
        const double own = along(size, order);
        if (own > 0) {
            share.length += own + (share.length > 0 ? gap : 0);
            ++share.shown;
        }
        share.across = std::max(share.across, across(size, order));
        share.score += size.score;
    }
    if (!way.shares.empty() && share.length >= way.shares.back().length) return;
    way.shares.push_back(share);
}

}  // namespace kinegraph::render
