// A plot of one quantity over another in the style of the other figures: up to four curves, with marked points.
#pragma once

#include <string>
#include <vector>

#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

struct XyCurve {
    RichText name;
    std::string id;            ///< for `data-name`
    std::vector<Spot> values;  ///< in the units of the axes
};
struct XyMark {
    std::size_t curve = 0;
    Spot at;  ///< in the units of the axes
    RichText words;
};
struct XyPlot {
    std::string id;
    RichText caption, x_name, y_name;
    std::string x_unit, y_unit;
    std::vector<XyCurve> curves;
    std::vector<XyMark> marks;
    bool square = false;  ///< both axes have the same scale
};
/// Dash patterns for up to four curves, so that they differ without colour.
std::vector<double> line_kind(std::size_t curve);
/// Kind "plot"; groups as in plot_figure().
Figure xy_plot_figure(const DrawingContext& context, const XyPlot& plot, double room_x, double room_y);

}  // namespace kinegraph::render
