// Sheet pages: places the drawn figures and the text of a plan on pages with frame and title block. Plans nothing.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render/content/title_block.hpp"
#include "render/layout/drawn_figures.hpp"
#include "render/layout/spread_figures.hpp"
#include "render/page/page.hpp"

namespace kinegraph::render {

/// The text of bands, with the lengths measured on the drawn figures.
class DrawnText {
public:
    DrawnText(const Bands& bands, const DrawnFigures& figures, BandTexts& planned);
    DrawnText(const DrawnText&) = delete;  // its texts refer to its results
    DrawnText& operator=(const DrawnText&) = delete;

    const ColumnText& of(const Band& band, const BandLayout& layout) {
        return texts_.of(band, layout.divided, layout.cornered);
    }

private:
    std::vector<ResultRow> results_;
    BandTexts texts_;
};

/// The content of the pages.
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

    /// Makes the pages and moves the figures to their positions. `after`: number of pages bound behind these.
    std::vector<Page> set(std::size_t after);
    /// Of the caption of figure 1: its upper left corner and its width, mm.
    Spot first_caption() const { return first_caption_; }
    double first_caption_width() const { return first_caption_width_; }

private:
    /// A drawn band and the heights that it takes of its room, mm.
    struct Standing {
        const PlacedBand* placed;
        BandLayout layout;
        double figures = 0;  ///< height of the figures
        double block = 0;    ///< what the title block takes below them
        double above = 0;    ///< top of the first column of text
        double words = 0;    ///< height of the text from there on
        double below = 0;    ///< what the title block takes below it
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
                  double loose, double spare);
    double spare_above_text(const Standing& band, double most, double loose, double spare) const;
    void set_figures(std::vector<Mark>& marks, std::optional<double>& scale_of_mechanism,
                     std::vector<DrawnFigure>& figures, bool stacked, Spot at, double height);
    void set_text(std::vector<Mark>& marks, const Standing& band, Spot at, double below, double loose, double height);

    const DrawingContext& context_;
    const SheetFormat& format_;
    const Signature& signature_;
    SheetContents contents_;
    std::set<std::string> names_on_page_;
    std::vector<Figure*> figures_on_page_;
    std::vector<MovableFigure> movable_;  // those on the page, with their marks
    Spot first_caption_{};
    double first_caption_width_ = 0;
};

}  // namespace kinegraph::render
