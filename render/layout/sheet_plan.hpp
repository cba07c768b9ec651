// Sheet plan: the bands of a solution on pages, divided where no page holds one, with one scale for all force polygons.
// Owns what the drawing has taught so far about each band's place; draws nothing.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "render/layout/page_plan.hpp"

namespace kinegraph::render {

class SheetPlan {
public:
    SheetPlan(WantedFigures& wanted, Bands& bands, const SheetFormat& format)
        : wanted_(wanted), bands_(bands), format_(format), texts_(bands, bands.results(), format) {}

    /// Anew, by what is known of the figures by now. The text of what no page holds goes on over pages; where that
    /// alone does not help the figures are shown smaller.
    void make();
    /// Another plan by what is known now, at every scale of the force polygons; false where it took more pages: then
    /// all is as it was. The next make() takes it.
    bool makes_another();
    /// All is planned anew the next time, were it only for another scale of the force polygons.
    void look_again() { looks_again_ = true; }

    const std::vector<PlannedPage>& pages() const { return pages_; }
    BandLayout layout_of(const PlacedBand& placed) const {
        return layouts_[placed.band].in(placed.width, placed.room.height(), placed.notch);
    }
    const BandLayouts& layouts(std::size_t band) const { return layouts_[band]; }
    BandTexts& texts() { return texts_; }
    /// Each band in its place, in their order: look(placed, layout).
    template <class Look>
    void for_each_band(Look look) const {
        for (const PlannedPage& page : pages_)
            for (const PlannedRow& row : page)
                for (const PlannedCell& cell : row)
                    for (const PlacedBand& placed : cell) look(placed, layout_of(placed));
    }

    // What the drawing taught, for the next plan.
    /// The figure of a band leaves its equations no corner.
    void has_no_corner(const std::string& question) { cornerless_.insert(question); }
    /// Tables of a band are too wide for narrow columns; false where that was known.
    bool has_wide_tables(const std::string& question) { return wide_.insert(question).second; }
    /// No force polygon can be drawn larger.
    void draw_forces_at(double scale);
    /// A finer scale of the force polygons is no longer looked for; false where it was not.
    bool give_up_finest_force_scale() { return std::exchange(seeks_finest_force_scale_, false); }
    /// … or is again: without it there are as many pages.
    void seek_finest_force_scale() { seeks_finest_force_scale_ = true; }

private:
    bool plans_at_same_force_scale();
    void plan_all();
    void give_each_a_page();
    double worth_of(std::size_t index, std::size_t end_row);
    std::size_t rows_for_a_page(std::size_t index);
    BandLayouts layouts_of(const Band& band);
    void divide(std::size_t index, std::size_t rows);
    void rejoin();
    void part_figures(std::size_t index);
    void share_force_scale(double least);
    double coarsest_of_forces() const;

    WantedFigures& wanted_;
    Bands& bands_;
    const SheetFormat& format_;
    BandTexts texts_;
    std::set<std::string> crowded_;     // bands whose figures may be smaller than is well readable
    std::set<std::string> cornerless_;  // … whose figure leaves their equations no corner
    std::set<std::string> wide_;        // … whose tables are too wide for narrow columns
    std::vector<BandLayouts> layouts_;
    std::vector<PlannedPage> pages_;
    double worth_ = BandLayout::impossible;  // of the pages
    bool seeks_finest_force_scale_ = true;
    int times_divided_ = 0;                    // the bands
    bool is_made_ = false;                     // the plan that make() would make
    bool looks_again_ = false;                 // for another force scale
    std::optional<double> least_force_scale_;  // at which all force polygons that were drawn had room
};

}  // namespace kinegraph::render
