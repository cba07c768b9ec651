// Figure shares: how the figures of a band share one room, side by side or stacked. Chooses one of the possible scales
// for each figure; depends on neither text nor pages.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "render/ink/spot.hpp"

namespace kinegraph::render {

/// Space that a figure needs at a scale, its caption included (mm), and the score of that scale.
struct FigureSize {
    double x = 0, y = 0, score = 0;
    double scale = 0;         ///< units per mm; of a figure that fills its room: that of its strokes
    double caption = 0;       ///< the part of y that its caption takes
    double wider = 0;         ///< additional width for equations in a corner
    std::size_t drawing = 0;  ///< index of the drawing among those of the figure
    bool estimated = false;   ///< not drawn yet: the space that its strokes need at least
    bool operator==(const FigureSize&) const = default;
};

/// A greedy search: each figure begins with the largest size that the room is wide enough for; then the figure that
/// loses the least score for the length it frees is made smaller, until all fit. This sequence does not depend on the
/// length of the room. It is therefore memoised for each width, extended only as far as needed, and searched by length.
class FigureShares {
public:
    /// How the figures stand, and whether they have equations in a corner.
    struct Order {
        bool stacked = false, cornered = false;
    };
    struct Share {
        double score = 0, length = 0;
        double across = 0;  ///< extent in the other direction
        int shown = 0;      ///< number of figures that are not left out
    };

    /// `sizes`: for each figure, the largest first.
    explicit FigureShares(std::vector<std::vector<FigureSize>> sizes = {});

    const std::vector<std::vector<FigureSize>>& sizes() const { return sizes_; }
    /// Upper bound of the score of any share of the room or of a part of it: the sum of the best scores of each figure
    /// alone. Below any score if the room is too small for one of them.
    double best_score_in(Spot room) const;
    /// Empty if the room is too small.
    std::optional<Share> in(Spot room, Order order) const;
    /// The index of the size of each figure in that share. It repeats the search, because few calls need it.
    std::vector<std::size_t> taken_in(Spot room, Order order) const;

    static double along(const FigureSize& size, Order order);

private:
    std::optional<Share> of_one(Spot room, Order order) const;
    /// The memoised sequence for rooms that are wide enough for the same sizes. Each share is shorter than those before
    /// it.
    struct Way {
        bool begun = false, ended = false;
        std::vector<std::size_t> now;  // current index of the size of each figure
        std::vector<Share> shares;
    };
    static double across(const FigureSize& size, Order order);
    /// Index of the largest size from `first` on that is not wider than `wide`. A coarser scale may be wider, since its
    /// labels are crowded.
    std::size_t fitting_from(std::size_t figure, std::size_t first, double wide, Order order) const;
    void begin(Way& way, double wide, Order order) const;
    /// Extends the sequence until a share is no longer than `whole` or no figure can be made smaller.
    void go_until(Way& way, double whole, double wide, Order order) const;
    void go_on(Way& way, double wide, Order order) const;
    void note(Way& way, Order order) const;

    std::vector<std::vector<FigureSize>> sizes_;
    std::array<std::vector<double>, 2> widths_;     // extents across, ascending; side by side, stacked
    mutable std::array<std::vector<Way>, 4> ways_;  // by order; by number of widths that have room
};

}  // namespace kinegraph::render
