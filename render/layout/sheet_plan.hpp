// Sheet plan: the bands of a solution on pages, with one common scale for all force polygons. Divides bands that no
// page can hold. Draws nothing.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render/layout/page_plan.hpp"

namespace kinegraph::render {

class SheetPlan {
public:
    SheetPlan(const WantedFigures& wanted, MeasuredFigures& measured, Bands& bands, const SheetFormat& format)
        : wanted_(wanted), measured_(measured), bands_(bands), format_(format), now_{texts_of(format.text_size)} {}

    /// Finds the plan with the highest score; a page has a price. The text of a band that no
    /// page can hold is divided over pages; if that is not enough, its figures are shown smaller. Then the text takes
    /// the largest size that costs neither a page nor a scale.
    void make();

    const std::vector<PlannedPage>& pages() const { return now_.pages; }
    const BandLayout& layout_of(const PlacedBand& placed) const;
    /// Of the figures shown, and of the force polygons.
    KeptScales scales() const;
    const BandLayouts& layouts(std::size_t band) const { return now_.layouts[band]; }
    BandTexts& texts() { return *now_.texts; }
    /// Calls look(placed, layout) for each band in order.
    template <class Look>
    void for_each_band(Look look) const {
        for (const PlannedPage& page : now_.pages)
            for (const PlannedRow& row : page)
                for (const PlannedCell& cell : row)
                    for (const PlacedBand& placed : cell) look(placed, layout_of(placed));
    }

    /// For the next plan: tables of a band are too wide for columns of a page that is divided into `divided`. False if
    /// that was recorded before.
    bool has_wide_tables(const std::string& question, int divided);

private:
    struct Planned {
        std::shared_ptr<BandTexts> texts{};
        std::vector<BandLayouts> layouts{};
        std::vector<PlannedPage> pages{};
        mutable std::vector<std::optional<BandLayout>> taken{};  ///< by band, when it was first asked for
        double score = BandLayout::impossible;
    };
    void find_pages();
    bool finds_pages(double least);
    bool may_be_small();
    std::shared_ptr<BandTexts> texts_of(double size) const;
    bool improves(std::shared_ptr<BandTexts> texts);
    void try_finer_force_scales();
    void enlarge_figures();
    bool is_white(const PlacedBand& placed, const BandLayout& layout) const;
    void fill_rooms();
    bool fills_rooms_with_forces(double scale);
    std::optional<BandLayout> filled(const PlacedBand& placed, std::vector<std::vector<FigureSize>> sizes) const;
    bool enlarge_text(double size);
    bool may_hold_text(double larger) const;
    bool plan_all(const std::function<bool(const Planned&)>& may_do);
    void plan_once();
    bool draws_what_is_chosen();
    void give_each_a_page();
    double score_of(std::size_t index, std::size_t end_row);
    std::size_t rows_for_a_page(std::size_t index);
    std::size_t rows_for_a_filled_rest(std::size_t index, const std::vector<BandTexts::RowsOfPassage>& passages,
                                       std::size_t rows, std::size_t fewest);
    BandLayouts layouts_of(const Band& band);
    void divide(std::size_t index, std::size_t rows);
    void rejoin();
    void part_figures(std::size_t index);

    const WantedFigures& wanted_;
    MeasuredFigures& measured_;
    Bands& bands_;
    const SheetFormat& format_;
    bool may_enlarge_text_ = true;
    bool draws_all_ = false;                 // whether sizes are those of drawings, not estimated
    bool small_ = false;                     // whether figures may be small
    int columns_more_ = 1;                   // by which bands may share a page
    std::set<std::string> large_;            // bands whose figures may be as large as a page
    std::optional<KeptScales> not_coarser_;  // the scales that figures have at least
    std::set<std::string> crowded_;          // bands whose figures may be hard to read
    std::set<std::string> wide_;             // bands whose tables are too wide for narrow columns
    std::optional<double> force_scale_;
    Planned now_;
};

}  // namespace kinegraph::render
