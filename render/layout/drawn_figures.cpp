// Implementation of drawn_figures.hpp.
#include "render/layout/drawn_figures.hpp"

#include <algorithm>

#include "engine/number/assert.hpp"
#include "render/figures/caption.hpp"
#include "render/figures/polygon_parts.hpp"
#include "render/layout/free_corner.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {

void DrawnFigures::take(const SheetPlan& plan) {
    by_band_.clear();
    int number = 0;
    std::size_t details = 0;
    plan.for_each_band([&](const PlacedBand& placed, const BandLayout& layout) {
        const Band& band = bands_.list[placed.band];
        Spot corner{0, 0};
        for (std::size_t f = 0; f < layout.rooms.size(); ++f) {
            const Spot size = layout.rooms[f];
            if (!(size.x > 0)) continue;
            DrawnFigure drawn;
            drawn.wanted = band.figures[f];
            drawn.number = ++number;
            drawn.room = rectangle(corner.x, corner.y, corner.x + size.x, corner.y + size.y);
            drawn.figure = measured_.drawing(drawn.wanted, layout.sizes[f]);
            std::vector<Mark> words;
            drawn.caption = set_caption(words, context_, drawn.figure, drawn.number, {0, 0}, size.x);
            letter_details_on(drawn.figure, context_, details);
            details += drawn.figure.details.size();
            if (layout.cornered) set_in_corner(drawn, plan.layouts(placed.band).equations());
            by_band_[placed.band].push_back(std::move(drawn));
            (layout.stacked ? corner.y : corner.x) += (layout.stacked ? size.y : size.x) + gap;
        }
    });
}

void DrawnFigures::enrich() {
    for (auto& [band, figures] : by_band_)
        for (DrawnFigure& drawn : figures) {
            Figure more =
                wanted_.enriched(drawn.wanted, drawn.figure, {drawn.room.width(), drawn.room.height() - drawn.caption});
            if (more.scale != any_scale) drawn.figure = std::move(more);
        }
}

/// The room is wide enough for both: the plan measured the free corner.
void DrawnFigures::set_in_corner(DrawnFigure& drawn, const Block& equations) const {
    // The letters of details, which are known only now, may be a little larger than those that were measured.
    const Box room = rectangle(0, 0, std::max(drawn.room.width(), drawn.figure.box.width()),
                               std::max(drawn.room.height() - drawn.caption, drawn.figure.box.height()));
    const bool set = set_beside(drawn.beside, drawn.figure, equations, room);
    KG_ASSERT(set, "equations have room beside the figure that was measured for them");
    drawn.figure.box.include(box_of(drawn.beside));
}

}  // namespace kinegraph::render
