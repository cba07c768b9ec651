// The ink map: which parts of a figure are inked already, as bits. Owns their size and the questions put to them; knows
// no label and no price. A box of any turn is asked row by row, a word of 64 bits at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

/// A turned box: `half` extents along `axis` (a unit vector) and its normal.
struct InkBox {
    Spot centre, half, axis{1, 0};
    /// The spot as seen from the box: along its axis and across it.
    Spot local(Spot spot) const;
    /// Half extents of the upright box round it.
    Spot reach() const;
    InkBox grown(double margin) const { return {centre, {half.x + margin, half.y + margin}, axis}; }
};

/// Where the letters of a text have their ink, in the box that its turn carries along; nothing where it has no letters.
std::optional<InkBox> ink_of(const TextMark& text, const Fonts& fonts);
/// The corners of a path, its curves cut into chords that are 0.05 mm off at most for arcs.
std::vector<Spot> outline_of(const Path& path);
/// A disc no larger than a pin's, a balloon's or a dot's: the map has all of it as ink, whatever it is filled with.
bool is_dot(const Path& path);

class InkMap {
public:
    static constexpr double pitch = 0.2;  ///< mm, of a bit; coarser for drawings larger than half a metre

    /// A blank map of the area; what is drawn outside of it is not seen.
    explicit InkMap(const Box& area);

    /// Ink within `half` of the segment.
    void stroke(Spot from, Spot to, double half);
    void fill(const InkBox& box);
    /// What a path inks: its stroke, and its fill unless that is a tint. A tint's edge is ink.
    void ink(const Path& path);
    /// Takes all ink away that may lie in an upright box.
    void clear(const Box& box);
    /// The inside of a polygon, by the even-odd rule.
    void fill(const std::vector<Spot>& corners);

    static constexpr int all = 1 << 30;  ///< more than is ever counted

    /// Inked area within the box, mm². 0: all clear (to half a bit). Of more than `most` it is only said that it is
    /// more.
    double inked(const InkBox& box, double most = 1e300) const;
    /// inked(box) > 0, found sooner.
    bool touches(const InkBox& box) const;
    /// How often a thin line from a spot to another meets ink, counted up to `most`, a broad stroke several times; the
    /// ink that it starts in is not counted.
    int crossings(Spot from, Spot to, int most = all) const;

private:
    /// Shows look() the words of a box, until it says no.
    template <class Look>
    void rows_of(const InkBox& box, Look look) const;
    template <class Turned, class Look>
    void rows_of_turned(const Turned& runs, Look look) const;
    /// The words that hold the bits from x to x of the row whose first word is `base`, until look() says no; whether it
    /// never did.
    template <class Look>
    bool words_of(std::size_t base, double from, double to, Look look) const;
    void ink_row(int row, double from, double to);

    Spot origin_;
    double pitch_ = pitch;
    int columns_ = 0, rows_ = 0;
    std::size_t words_ = 0;  // of a row
    std::vector<std::uint64_t> bits_;
};

}  // namespace kinegraph::render
