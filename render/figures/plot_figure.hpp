// Plots: quantities over the driver's coordinate, in the hand of the other figures; and the mechanism with its way
// behind it.
#pragma once

#include <string>
#include <vector>

#include "engine/sentences/column.hpp"
#include "render/page/figure.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// A column as it is typeset: ω_3, v_Bx, s_C.
RichText typeset(const Column& column, const Mechanism& mechanism, Language language);
/// The file's unit of a column, and its size in SI.
Unit unit_of(QuantityKind kind, const Mechanism& mechanism);

/// What a plot says of its own.
struct PlotNotes {
    RichText caption{};  ///< empty: the names of its columns
    double drawn = 0;    ///< the driver's coordinate in the drawn position, SI; a parameter says its own
};

/// Up to four columns of one unit over the driver's coordinate, in the file's units. Kind "plot"; `number` makes ids
/// unique. Axes are groups of class "axis-x" and "axis-y" with an invisible line from end to end and what these ends
/// mean; curves are groups of class "curve", gaps where there is no row.
Figure plot_figure(const DrawingContext& context, const CycleTable& table, const std::vector<std::size_t>& columns,
                   int number, double room_x, double room_y, const PlotNotes& notes = {});

/// Lines behind a mechanism, m as in the file: its bodies in other positions, the path of a point, a piece of a
/// centrode, or (one place) the pole in which the centrodes touch.
struct Way {
    std::string name;
    bool is_path = false;
    std::vector<VectorOf<double>> places;
    enum class Kind { plain, fixed_centrode, moving_centrode, pole } kind = Kind::plain;
    bool comes_from_infinity = false, goes_to_infinity = false;  ///< centrodes: it is cut there
    BodyIndex outline = none;  ///< of this body: closed, tinted and drawn as the body is
    bool is_thin = false;      ///< a path that only helps
    RichText label{};          ///< beside one of its places; empty: none
    std::size_t label_at = 0;  ///< which place
};
/// The mechanism as drawn, with its ways behind it. Kind and id "mechanism".
Figure mechanism_with_ways(const DrawingContext& context, const std::vector<Way>& ways, double room_x, double room_y);

}  // namespace kinegraph::render
