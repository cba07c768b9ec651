// Drawn figures: draws the figures of a plan, each in its room. Owns a cache of the drawings. Chooses no room; only
// figures of one band share the space that they leave free.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "render/layout/figure_needs.hpp"
#include "render/layout/sheet_plan.hpp"

namespace kinegraph::render {

class DrawnFigures {
public:
    using ByBand = std::map<std::size_t, std::vector<DrawnFigure>>;

    DrawnFigures(const DrawingContext& context, const WantedFigures& wanted, const Bands& bands, FigureNeeds& needs)
        : context_(context), wanted_(wanted), bands_(bands), needs_(needs), known_(wanted.list.size()) {}

    /// Draws all figures of the plan except those that fill their rooms. `refuse`: a figure may refuse a room in which
    /// its scale would be coarser than planned. False if equations found no free corner beside their figure; the plan
    /// records it.
    bool draw(SheetPlan& plan, bool refuse);
    /// Draws the figures that fill their rooms. Call it once the rooms are final: it also letters the details (I, II,
    /// …).
    void draw_what_fills_its_room();
    /// Adds optional content to the figures where their rooms have space for it.
    void enrich();

    /// Whether every figure fits into its room.
    bool keep_to_rooms() const;

    ByBand& by_band() { return by_band_; }
    const ByBand& by_band() const { return by_band_; }

private:
    /// A cached drawing, and the room it was drawn for.
    struct Known {
        Spot room;
        std::optional<double> force_scale;
        bool shrinks = false;
        Figure figure;
        std::optional<double> refused_at;  // the finest scale for which it was found to have no room
    };
    struct InItsRoom {
        DrawnFigure* drawn;
        const Band* band;
        const BandLayouts* layouts;
        bool cornered;
    };
    std::vector<InItsRoom> in_their_rooms(const SheetPlan& plan);
    void draw_each(const std::vector<InItsRoom>& all, bool refuse);
    const Figure& figure_in(std::size_t index, Spot room, double coarsest);
    bool serves(const Known& known, const Wanted& wanted, Spot room, double coarsest) const;
    void draw_into(DrawnFigure& drawn, Spot room, double coarsest);
    void enlarge(DrawnFigure& drawn) const;
    double height_of_caption(const DrawnFigure& drawn, double width) const;
    double width_for_caption(const DrawnFigure& drawn, double most, double low, double high) const;
    void share_room(std::vector<DrawnFigure>& figures) const;
    bool set_in_corner(DrawnFigure& drawn, const Block& equations) const;

    const DrawingContext& context_;
    const WantedFigures& wanted_;
    const Bands& bands_;
    FigureNeeds& needs_;
    std::vector<std::vector<Known>> known_;  // by figure
    ByBand by_band_;
};

}  // namespace kinegraph::render
