// The sheet: figures, equations, tables and steps on pages, nothing overlapping, nothing cut. Owns the choice between one page
// and several; knows no mechanics, and takes every figure as it comes: it is moved, never scaled.
//
// Method: the figures of a page get cells, chosen among all splits into columns and rows by the size of what they would hold
// (page_split, figure_pages); equations go into the free corner beside their polygon; text flows into the free runs that are
// left, then into the columns of further pages (sections, text_flow).
#include "render/sheet/sheet.hpp"

#include "render/page/shapes.hpp"
#include "render/sheet/figure_pages.hpp"
#include "render/sheet/sections.hpp"
#include "render/sheet/text_flow.hpp"
#include "render/sheet/title_block.hpp"
#include "render/sheet/wanted_figures.hpp"

namespace kinegraph::render {
namespace {

constexpr double one_page_share = 0.5;  // of the page that text may take where all is to stand on one

class Layout {
public:
    Layout(const Solution& solution, const SheetOptions& options, const Fonts& fonts)
        : context_{solution, options.theme, fonts, options.language, options.dimensions},
          format_(format_of(options.paper, options.orientation)),
          signature_{options.author, options.date},
          wanted_(context_, format_.measure, options.joukowsky) {}

    std::vector<Page> pages() {
        if (!on_one_page()) on_several();
        std::vector<Page> pages;
        for (std::size_t i = 0; i < sheets_.size(); ++i)
            pages.push_back(framed_page(context_, format_, signature_, sheets_[i].marks, sheets_[i].scale_of_mechanism, i + 1,
                                        sheets_.size()));
        return pages;
    }

private:
    std::size_t on_first_page() const {
        for (std::size_t i = 1; i < wanted_.list.size(); ++i)
            if (wanted_.list[i].starts_page) return i;
        return wanted_.list.size();
    }

    /// All on the pages of the figures where it can be: they leave as little room as the text needs.
    bool on_one_page() {
        const double text = estimated_text(context_.solution, format_);
        if (on_first_page() > most_on_first_page(format_) || is_mixed(context_.solution) ||
            text / (format_.content.width() * format_.content.height()) >= one_page_share)
            return false;
        const bool forces = has_forces(context_.solution);
        for (const bool equations : {true, false}) {
            for (const double spare : {0.4, 0.5, 0.6, 0.75, 1.0, 0.0}) {
                if (spare == 0 && !forces) continue;
                figures_ = place_figures(context_, format_, wanted_, spare * text);
                std::vector<Section> sections = write_sections(context_, format_, wanted_, figures_);
                set_text(equations ? std::move(sections) : without_spare_rows(std::move(sections)));
                if (sheets_.size() == figures_.sheets.size()) return true;
            }
            if (!forces) break;
        }
        return false;
    }
    void on_several() {
        figures_ = place_figures(context_, format_, wanted_, 0);
        const std::vector<Section> text = write_sections(context_, format_, wanted_, figures_);
        set_text(without_spare_rows(text));
        if (!has_forces(context_.solution)) return;
        // Equations with the steps are not worth a page.
        std::vector<Sheet> without = sheets_;
        set_text(text);
        if (sheets_.size() > without.size()) sheets_ = std::move(without);
    }

    /// The figures where they are, and the text.
    void set_text(std::vector<Section> text) { sheets_ = flow_text(context_, format_, wanted_, figures_, std::move(text)); }

    DrawingContext context_;
    SheetFormat format_;
    Signature signature_;
    WantedFigures wanted_;
    FigurePages figures_;
    std::vector<Sheet> sheets_;
};

}  // namespace

std::vector<Page> lay_out(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    return Layout(solution, options, fonts).pages();
}

}  // namespace kinegraph::render
