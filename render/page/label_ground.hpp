// Obstacles for labels: ink, tints and covered text. Computes the price of a place on them; independent of the labels
// and of the choice among places.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "render/page/ink_map.hpp"
#include "render/page/label_boxes.hpp"
#include "render/page/label_prices.hpp"

namespace kinegraph::render::lettering {

class Ground {
public:
    Ground(const std::vector<Mark>& marks, const Fonts& fonts);

    bool is_free(const InkBox& box) const { return !map_.touches(box.grown(ink_margin)); }
    /// The map of all ink, where a box with this margin stands clear of it.
    const InkMap& map() const { return map_; }
    /// Whether no ink lies under the box itself, however near. The box is grown a little, so that a corner which
    /// reaches into a slanting stroke does not slip between bits.
    bool is_bare(const InkBox& box) const { return !map_.touches(box.grown(0.7 * InkMap::pitch)); }
    /// Whether a leader there would cross existing text.
    bool covers_text(const InkBox& thread) const;
    /// Price of a label there: prohibitive for ink within the margin, small for ink within breathing distance and for a
    /// tint.
    double price(const InkBox& box, bool free) const;
    /// Number of strokes that a leader would cross, counted up to `most`.
    int crossed(Spot from, Spot to, int most = InkMap::all) const { return map_.crossings(from, to, most); }

    /// A colour, and the body whose tint it is, if it is one's.
    struct Tint {
        Colour colour;
        BodyIndex body = none;
    };
    /// The tint at a spot, if any.
    std::optional<Tint> tint_at(Spot spot) const;

private:
    /// A tinted area. A label may stand in it, at a small price.
    struct Area {
        std::vector<Spot> corners;
        Box box;
        Tint tint;
        bool holds(Spot spot) const;
    };
    void add(const Path& path);
    void add(const TextMark& text, const Fonts& fonts);

    InkMap map_;
    std::vector<Area> areas_;
    std::vector<InkBox> texts_;
};

}  // namespace kinegraph::render::lettering
