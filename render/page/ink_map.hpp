// Ink map: a bitmap of the inked parts of a figure, and the queries on it. Independent of labels and their prices. A
// box is tested row by row, 64 bits at a time, whatever its rotation.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

/// A turned box: `half` extents along `axis` (a unit vector) and its normal.
struct InkBox {
    Spot centre, half, axis{1, 0};
    /// The spot in coordinates of the box: along its axis and across it.
    Spot local(Spot spot) const;
    /// Half extents of the axis-aligned bounding box.
    Spot reach() const;
    InkBox grown(double margin) const { return {centre, {half.x + margin, half.y + margin}, axis}; }
};

/// The inked box of a text, rotated as the text is. Empty if the text has no letters.
std::optional<InkBox> ink_of(const TextMark& text, const Fonts& fonts);
/// The corners of a path. Curves become chords; for arcs these deviate by at most 0.05 mm.
std::vector<Spot> outline_of(const Path& path);
/// Whether the path is a disc of at most the size of a pin, a balloon or a dot. The map counts all of it as ink,
/// whatever its fill.
bool is_dot(const Path& path);

class InkMap {
public:
    static constexpr double pitch = 0.2;  ///< size of a bit, mm; coarser for drawings larger than half a metre

    /// A blank map of the area. Ink outside the area is ignored.
    explicit InkMap(const Box& area);

    /// Marks everything within `half` of the segment as inked.
    void stroke(Spot from, Spot to, double half);
    void fill(const InkBox& box);
    /// Adds the ink of a path: its stroke, and its fill unless that is a tint. The edge of a tint counts as ink.
    void ink(const Path& path);
    /// Removes all ink that may lie in an axis-aligned box.
    void clear(const Box& box);
    /// Fills a polygon by the even-odd rule.
    void fill(const std::vector<Spot>& corners);

    static constexpr int all = 1 << 30;  ///< larger than any count

    /// Inked area within the box, mm². 0: free of ink (to half a bit). Above `most` the result is only a lower bound.
    double inked(const InkBox& box, double most = 1e300) const;
    /// Same as inked(box) > 0, but faster.
    bool touches(const InkBox& box) const;
    /// How far an upright box must be moved right or down, at least, until it has left all ink that it touches now, if
    /// it touches any.
    std::optional<double> way_right(const InkBox& box) const;
    std::optional<double> way_down(const InkBox& box) const;
    /// How often a thin line between two spots meets ink, counted up to `most`. A broad stroke counts several times;
    /// the ink in which the line starts does not count.
    int crossings(Spot from, Spot to, int most = all) const;

private:
    /// The bits whose centres an upright box covers: columns `left` to `right`, rows `top` to `bottom`.
    struct Bits {
        std::size_t left, right, top, bottom;
        std::uint64_t mask(std::size_t word) const;  ///< of the columns, in that word of a row
    };
    std::optional<Bits> bits_of(const InkBox& upright) const;
    /// Calls look() with the words (64 bits) that cover a box, but for some without ink, until it returns false.
    template <class Look>
    void rows_of(const InkBox& box, Look look) const;
    template <class Turned, class Look>
    void rows_of_turned(const Turned& runs, Look look) const;
    /// Calls look() with the words that contain the bits `from` to `to` of the row whose first word is `base`, until it
    /// returns false. Returns whether it never did.
    template <class Look>
    bool words_of(std::size_t base, double from, double to, Look look) const;
    void ink_row(int row, double from, double to);
    void set(std::size_t row, std::size_t word, std::uint64_t mask) {
        bits_[row * words_ + word] |= mask;
        any_[row / rows_at_once * words_ + word] |= mask;
    }

    static constexpr std::size_t rows_at_once = 8;

    Spot origin_;
    double pitch_ = pitch;
    int columns_ = 0, rows_ = 0;
    std::size_t words_ = 0;  // words per row
    std::vector<std::uint64_t> bits_;
    std::vector<std::uint64_t> any_;  // of each rows_at_once rows: the bits that at least one has, and maybe more
};

}  // namespace kinegraph::render
