// Sheet pages: the bands of a plan with their drawn figures and their text, set on pages with frame and title block.
// Owns what is set where; plans nothing.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render/content/title_block.hpp"
#include "render/layout/drawn_figures.hpp"
#include "render/page/page.hpp"

namespace kinegraph::render {

/// The text of bands with the lengths that are measured on the figures as drawn.
class DrawnText {
public:
    DrawnText(const Bands& bands, const DrawnFigures& figures, const SheetFormat& format, BandTexts& planned);
    DrawnText(const DrawnText&) = delete;  // its texts refer to its results
    DrawnText& operator=(const DrawnText&) = delete;

    const ColumnText& of(const Band& band, const BandLayout& layout) {
        return texts_.of(band, layout.divided, layout.cornered);
    }

private:
    std::vector<ResultRow> results_;
    BandTexts texts_;
};

/// What stands on the pages.
struct SheetContents {
    const SheetPlan& plan;
    const Bands& bands;
    DrawnFigures& figures;
    DrawnText& text;
};

class SheetPages {
public:
    SheetPages(const DrawingContext& context, const SheetFormat& format, const Signature& signature,
               SheetContents contents)
        : context_(context), format_(format), signature_(signature), contents_(contents) {}

    /// Figures are moved to where they stand. `after`: how many pages are bound behind these.
    std::vector<Page> set(std::size_t after);
    /// Of figure 1: its upper left corner, and the room it has.
    Spot first_caption() const { return first_caption_; }
    double first_caption_width() const { return first_caption_width_; }

private:
    /// A band with what it takes of its room once it is drawn.
    struct Standing {
        const PlacedBand* placed;
        BandLayout layout;
        double figures = 0;  ///< their height, with what the title block takes under them
        double above = 0;    ///< where the first column of its text begins
        double words = 0;    ///< how high the text is from there on
        double below = 0;    ///< what the title block takes under it
        double height(double loose) const;
    };
    using StandingCell = std::vector<Standing>;
    using StandingRow = std::vector<StandingCell>;
    static double height_of(const StandingCell& cell, double loose);
    static double height_of(const StandingRow& row, double loose);
    static double height_of(const std::vector<StandingRow>& rows, double loose);
    static double looseness_of(const std::vector<StandingRow>& rows, double height);

    Standing standing(const PlacedBand& placed) const;
    std::vector<Mark> marks_on(std::size_t page, std::optional<double>& scale_of_mechanism);
    void set_band(std::vector<Mark>& marks, std::optional<double>& scale_of_mechanism, const Standing& band, Spot at,
                  double loose);
    double set_figures(std::vector<Mark>& marks, std::optional<double>& scale_of_mechanism,
                       std::vector<DrawnFigure>& figures, bool stacked, Spot at);
    void set_text(std::vector<Mark>& marks, const Standing& band, Spot at, double below, double loose);

    const DrawingContext& context_;
    const SheetFormat& format_;
    const Signature& signature_;
    SheetContents contents_;
    std::set<std::string> names_on_page_;
    Spot first_caption_{};
    double first_caption_width_ = 0;
};

}  // namespace kinegraph::render
