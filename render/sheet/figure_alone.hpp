// A figure alone, for a book: the page is the figure with a narrow margin, without frame, title block or caption.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// What may be asked for: mechanism, centres, the ids of the polygons, lines-of-action, forces, body-NAME … in the
/// sheet's order.
std::vector<std::string> figure_names(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

/// The figure, at the scale of the file's or the largest that two columns of the paper hold. Nothing where no figure
/// has that name.
std::optional<Page> lay_out_alone(const Solution& solution, const SheetOptions& options, const std::string& name,
                                  const Fonts& fonts);

/// Any figure, the page cut to it.
Page page_of_figure(const DrawingContext& context, Figure figure);
/// A figure alone with what it is told by, for whoever moves it.
struct AloneFigure {
    Page page;
    std::string name;         ///< by which it may be asked for alone
    RichText caption;         ///< without number and scale
    RichText scale_in_words;  ///< empty where it has none
    Spot origin;              ///< where the origin of its coordinates lies on the page, mm
    double places = 0;        ///< as Figure's
};
/// Those of the sheet, in its order, each as lay_out_alone() has it. Of a problem in place of joints: without origin.
std::vector<AloneFigure> lay_out_each_alone(const Solution& solution, const SheetOptions& options, const Fonts& fonts);

}  // namespace kinegraph::render
