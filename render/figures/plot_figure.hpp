// Plots of quantities over the driver's coordinate, in the style of the other figures; and the mechanism with its paths
// behind it.
#pragma once

#include <string>
#include <vector>

#include "engine/motion/positions.hpp"
#include "engine/sentences/column.hpp"
#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// The symbol of a column: ω_3, v_Bx, s_C.
RichText typeset(const Column& column, const Mechanism& mechanism, Language language);
/// The unit of a column in the file, with its size in SI.
Unit unit_of(QuantityKind kind, const Mechanism& mechanism);
Unit unit_of(const Column& column, const Mechanism& mechanism);

/// Data of a single plot.
struct PlotNotes {
    RichText caption{};  ///< empty: the names of its columns
    double drawn = 0;    ///< the driver's coordinate in the drawn position, SI; a parameter has its own
};

/// Up to four columns with one unit over the driver's coordinate, in the units of the file. Kind "plot"; `number` makes
/// ids unique. Axes are groups of class "axis-x" and "axis-y" with an invisible line from end to end and the values at
/// its ends; curves are groups of class "curve", with gaps where there is no row.
Figure plot_figure(const DrawingContext& context, const CycleTable& table, const std::vector<std::size_t>& columns,
                   int number, double room_x, double room_y, const PlotNotes& notes = {});

/// A line behind a mechanism, in m: all its bodies in another position, the path of a point, a piece of a centrode, or
/// (one place) the pole in which the centrodes touch.
struct Way {
    std::string name;
    bool is_path = false;
    std::vector<VectorOf<double>> places;
    enum class Kind { plain, position, fixed_centrode, moving_centrode, pole } kind = Kind::plain;
    bool comes_from_infinity = false, goes_to_infinity = false;  ///< centrode that is cut there
    BodyIndex outline = none;                                    ///< closed outline of this body, in its colours
    bool is_thin = false;                                        ///< an auxiliary path
    RichText label{};                                            ///< at one of its places; empty: none
    std::size_t label_at = 0;                                    ///< index of that place
    std::vector<RigidMotion> bodies{};  ///< kind position: by BodyIndex; `places` is then what they cover
};
/// The mechanism with its paths behind it. Kind and id "mechanism".
Figure mechanism_with_ways(const DrawingContext& context, const std::vector<Way>& ways, double room_x, double room_y);

}  // namespace kinegraph::render
