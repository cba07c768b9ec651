// Sheet choice: of several layouts of one solution the one that a reader would rather have. Owns what pages and the
// size of figures are worth against each other; lays nothing out.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/layout/drawn_sheet.hpp"

namespace kinegraph::render {

/// The share (0 to 1) of squares of 10 mm within a frame on which a page has anything, tints included; 1: a frame of
/// less than a square.
double fill_of(const Page& page, const Box& frame);

class SheetChoice {
public:
    /// `frame`: of each page.
    explicit SheetChoice(const Box& frame) : frame_(frame) {}

    /// The first one is what the others are held against: they are not taken where they show its figures much smaller,
    /// nor where figures leave their rooms or tables of equations were left out.
    void offer(DrawnSheet sheet);
    /// Whether all pages of the best one are full, but for the last, which ends where the solution does; or figures
    /// leave the rooms of the first one, as they would those of another.
    bool is_settled() const { return is_settled_; }
    /// Of those offered, one at least.
    DrawnSheet best() && { return std::move(*best_); }

private:
    struct Size {
        double size;   ///< mm, of the longer side
        bool is_read;  ///< vectors are measured on it
    };
    using Sizes = std::map<std::pair<std::string, int>, Size>;  // by the figure's id, and which of those that have it
    bool is_much_smaller(const Sizes& sizes) const;

    const Box frame_;
    std::optional<DrawnSheet> best_;
    Sizes first_;
    std::size_t told_by_first_ = 0;  // in its tables of what is known and what is not
    double worth_ = 0;               // of the best
    bool is_settled_ = false;
};

}  // namespace kinegraph::render
