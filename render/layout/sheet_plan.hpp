// Sheet plan: the bands of a solution on pages, with one common scale for all force polygons. Divides bands that no
// page can hold. Owns what drawings have shown about the space of each band; draws nothing.
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

    /// Makes a plan with the current data of the figures. The text of a band that no page can hold is divided over
    /// pages; if that is not enough, its figures are shown smaller.
    void make();
    /// Makes another plan with the current data, for every common scale of forces. False if it needs more pages: the
    /// old plan is restored then. The next make() returns it.
    bool makes_another();
    /// Forces a new plan even if only the force scale changed.
    void look_again() { looks_again_ = true; }

    const std::vector<PlannedPage>& pages() const { return pages_; }
    BandLayout layout_of(const PlacedBand& placed) const {
        return layouts_[placed.band].in(placed.width, placed.room.height(), placed.notch);
    }
    const BandLayouts& layouts(std::size_t band) const { return layouts_[band]; }
    BandTexts& texts() { return texts_; }
    /// Calls look(placed, layout) for each band in order.
    template <class Look>
    void for_each_band(Look look) const {
        for (const PlannedPage& page : pages_)
            for (const PlannedRow& row : page)
                for (const PlannedCell& cell : row)
                    for (const PlacedBand& placed : cell) look(placed, layout_of(placed));
    }

    // Results of the drawing, for the next plan.
    /// The figure of a band has no free corner for its equations.
    void has_no_corner(const std::string& question) { cornerless_.insert(question); }
    /// Tables of a band are too wide for narrow columns. False if that was recorded before.
    bool has_wide_tables(const std::string& question) { return wide_.insert(question).second; }
    /// Sets the finest scale at which force polygons may be drawn.
    void draw_forces_at(double scale);
    /// Stops the search for a finer scale of forces. False if it was stopped before.
    bool give_up_finest_force_scale() { return std::exchange(seeks_finest_force_scale_, false); }
    /// Resumes it; call it if stopping saved no page.
    void seek_finest_force_scale() { seeks_finest_force_scale_ = true; }

private:
    bool plans_at_same_force_scale();
    void plan_all();
    void give_each_a_page();
    double score_of(std::size_t index, std::size_t end_row);
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
    std::set<std::string> crowded_;     // bands whose figures may be hard to read
    std::set<std::string> cornerless_;  // bands whose figure has no free corner for equations
    std::set<std::string> wide_;        // bands whose tables are too wide for narrow columns
    std::vector<BandLayouts> layouts_;
    std::vector<PlannedPage> pages_;
    double score_ = BandLayout::impossible;  // score of the pages
    bool seeks_finest_force_scale_ = true;
    int times_divided_ = 0;                    // number of calls of give_each_a_page()
    bool is_made_ = false;                     // the current plan is the one that make() would return
    bool looks_again_ = false;                 // for another force scale
    std::optional<double> least_force_scale_;  // the finest scale at which all drawn force polygons had room
};

}  // namespace kinegraph::render
