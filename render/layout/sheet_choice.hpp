// Sheet choice: selects the best of several layouts of one solution. Owns the score, which weighs the number and the
// fill of pages against the size of figures; lays out nothing.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/layout/drawn_sheet.hpp"

namespace kinegraph::render {

/// The share (0 to 1) of squares of 10 mm within a frame on which the page has ink or a tint. 1 if the frame is smaller
/// than a square.
double fill_of(const Page& page, const Box& frame);

class SheetChoice {
public:
    /// `frame`: that of every page.
    explicit SheetChoice(const Box& frame) : frame_(frame) {}

    /// The first layout is the reference. Later ones are rejected if they show its figures much smaller, if a figure
    /// leaves its room, or if tables of equations are missing.
    void offer(DrawnSheet sheet);
    /// Whether no further layout is needed: all pages of the best one but the last are well filled, or figures leave
    /// their rooms in the first one, as they would in others.
    bool is_settled() const { return is_settled_; }
    /// Requires that at least one was offered.
    DrawnSheet best() && { return std::move(*best_); }

private:
    struct Size {
        double size;   ///< mm, of the longer side
        bool is_read;  ///< vectors are measured on the figure
    };
    using Sizes = std::map<std::pair<std::string, int>, Size>;  // by id and its count among equal ids
    bool is_much_smaller(const Sizes& sizes) const;

    const Box frame_;
    std::optional<DrawnSheet> best_;
    Sizes first_;
    std::size_t told_by_first_ = 0;  // marks ✓ and ? in its tables of known and unknown quantities
    double score_ = 0;               // score of the best
    bool is_settled_ = false;
};

}  // namespace kinegraph::render
