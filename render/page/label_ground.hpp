// Label ground: all that is drawn before the labels are, as far as they care. Owns the map of the ink, the tints and
// the texts covered, and says what a place costs on them; knows no label and does not choose.
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
    /// No ink under it, however near. Grown so far that a corner which reaches into a slanting stroke does not slip
    /// between bits.
    bool is_bare(const InkBox& box) const { return !map_.touches(box.grown(0.7 * InkMap::pitch)); }
    /// Whether a leader there would run over letters that are drawn already.
    bool covers_text(const InkBox& thread) const;
    /// What a label there costs: ink within the margin is forbidden, ink within breathing distance and a tint are a
    /// pity.
    double price(const InkBox& box, bool free) const;
    /// Strokes that a leader would cross, counted no further than `most` of them.
    int crossed(Spot from, Spot to, int most = InkMap::all) const { return map_.crossings(from, to, most); }

    /// The tint that a spot is seen on, if it is on one.
    std::optional<Colour> tint_at(Spot spot) const;

private:
    /// A tinted area: a label may stand in it, but rather not.
    struct Area {
        std::vector<Spot> corners;
        Box box;
        Colour tint;
        bool holds(Spot spot) const;
    };
    void add(const Path& path);
    void add(const TextMark& text, const Fonts& fonts);

    InkMap map_;
    std::vector<Area> areas_;
    std::vector<InkBox> texts_;
};

}  // namespace kinegraph::render::lettering
