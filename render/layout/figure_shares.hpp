// Figure shares: how the figures of a band share one room, beside or under each other. Owns at which of its scales each
// figure stands in it; knows no text and no page.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "render/ink/spot.hpp"

namespace kinegraph::render {

/// What a figure takes at a scale, its caption included, and what that is worth.
struct FigureSize {
    double x = 0, y = 0, worth = 0, scale = 0;
    double wider = 0;  ///< for its equations in a corner
    bool operator==(const FigureSize&) const = default;
};

/// Each figure begins as large as the room is wide enough for; that which loses least for what it gives becomes smaller
/// until all have room beside each other. Which one gives way next does not hang on how long the room is. A plan asks
/// thousands of times: so these steps are gone once, as far as some room was short, and a room is answered by the first
/// that it is long enough for.
class FigureShares {
public:
    /// Figures stand one under the other, or side by side; they have their equations in a corner.
    struct Order {
        bool stacked = false, cornered = false;
    };
    struct Share {
        double worth = 0, length = 0;
        double across = 0;  ///< what it takes the other way
        int shown = 0;      ///< figures that are not left out
    };

    /// `sizes`: of each figure, the largest first.
    explicit FigureShares(std::vector<std::vector<FigureSize>> sizes = {});

    const std::vector<std::vector<FigureSize>>& sizes() const { return sizes_; }
    /// No share of a room, or of a part of it, is worth more: each figure as it would be worth most had it the room to
    /// itself. Less than any worth where the room is too small for one of them.
    double most_worth_in(Spot room) const;
    /// Nothing where the room is too small.
    std::optional<Share> in(Spot room, Order order) const;
    /// Which size each figure has then; the way there is gone again, for few are asked for.
    std::vector<std::size_t> taken_in(Spot room, Order order) const;

    static double along(const FigureSize& size, Order order);

private:
    std::optional<Share> of_one(Spot room, Order order) const;
    /// Shares in rooms that are wide enough for the same sizes, each shorter than all before.
    struct Way {
        bool begun = false, ended = false;
        std::vector<std::size_t> now;  // which sizes, where it has come to
        std::vector<Share> shares;
    };
    static double across(const FigureSize& size, Order order);
    /// The largest size from one on that has room; a coarser scale may take more across, for letters crowd.
    std::size_t fitting_from(std::size_t figure, std::size_t first, double wide, Order order) const;
    void begin(Way& way, double wide, Order order) const;
    /// Until a share is no longer than `whole`, or there is none.
    void go_until(Way& way, double whole, double wide, Order order) const;
    void go_on(Way& way, double wide, Order order) const;
    void note(Way& way, Order order) const;

    std::vector<std::vector<FigureSize>> sizes_;
    std::array<std::vector<double>, 2> widths_;     // that some size has across, ascending: side by side, stacked
    mutable std::array<std::vector<Way>, 4> ways_;  // by order; by how many of the widths have room
};

}  // namespace kinegraph::render
