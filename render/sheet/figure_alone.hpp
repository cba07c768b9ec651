// A single figure for a book: the page is the figure with a narrow margin, without frame, title block or caption.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/figures/figure_kinds.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// The names of all figures in the order of the sheet: mechanism, centres, the ids of the polygons, lines-of-action,
/// forces, body-NAME …
std::vector<std::string> figure_names(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

/// The figure at the scale in the file, or at the finest for which two columns of the paper have room. Empty if no
/// figure has that name.
std::optional<Page> lay_out_alone(const Solution& solution, const SheetOptions& options, const std::string& name,
                                  const Fonts& fonts);

/// A page of the size of the figure.
Page page_of_figure(const DrawingContext& context, Figure figure);
/// A figure with the data that describe it, for the live page.
struct AloneFigure {
    Page page;
    std::string name;                              ///< as in figure_names()
    RichText caption;                              ///< without number and scale
    RichText scale_in_words;                       ///< empty: no scale
    Spot origin;                                   ///< the origin of its coordinates on the page, mm
    double places = 0;                             ///< as in Figure
    std::optional<FigureId> id = std::nullopt;     ///< none: of a problem
    std::optional<double> by_load = std::nullopt;  ///< as in Figure
    JointIndex loaded = none;                      ///< of a contact at a joint
};
/// All figures of the sheet in its order, each as from lay_out_alone(). Figures of problems have no origin.
std::vector<AloneFigure> lay_out_each_alone(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
