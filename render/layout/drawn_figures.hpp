// Drawn figures: those of a plan, each in the room that is its own. Owns what was drawn before, so that nothing is
// drawn twice; chooses no room, but that figures of one band share out what they leave.
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

    /// All that the plan shows, but for what fills whatever room is left. `refuse`: figures may refuse a room that is
    /// less than their plan promised. False where equations found no corner beside their figure; the plan is told.
    bool draw(SheetPlan& plan, bool refuse);
    /// Those that fill their rooms, once the rooms are those that all others are content with; then the letters of
    /// details are known.
    void draw_what_fills_its_room();
    /// With what else has room in the rooms that they have.
    void enrich();

    /// Whether none takes more than its room.
    bool keep_to_rooms() const;

    ByBand& by_band() { return by_band_; }
    const ByBand& by_band() const { return by_band_; }

private:
    /// A drawing that was tried, and for which room.
    struct Known {
        Spot room;
        std::optional<double> force_scale;
        bool shrinks = false;
        Figure figure;
        std::optional<double> refused_at;  // the scale that it had no room for
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
