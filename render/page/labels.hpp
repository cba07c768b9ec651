// Placement of the labels that a figure requests, so that they cover nothing.
#pragma once

#include <optional>

#include "render/page/figure.hpp"

namespace kinegraph::render {

/// Upper limit of labels in one figure, of any size: more cannot be read. The richest example has 41.
constexpr std::size_t most_names = 80;

enum class Labelling {
    free,        ///< labels may leave the room if nothing in it is free
    strict,      ///< a label goes into the key rather than leave the room
    if_it_fits,  ///< place nothing unless figure and labels fit into the room
    if_all_free  ///< place nothing unless every label finds a free place
};

/// Places every requested label near its object, where it covers no stroke, no arrowhead and no other label;
/// deterministic. The obstacles are the figure's own marks. Appends TextMarks (class "label") and grows the figure's
/// box.
/// `room`: width and height (mm) that figure and labels should not exceed. A label wider than half of it ends in an
/// ellipsis; its aria-label stays complete. A label without a place goes into a key below the figure, with a number at
/// its object if the number finds a place; labels that must stay in the room go there rather than leave it. Beyond
/// `most_names` labels, the rest become the figure's `unnamed`.
/// False: nothing was placed.
bool place_labels(Figure& figure, const Fonts& fonts, std::optional<Spot> room = std::nullopt,
                  Labelling labelling = Labelling::free);
/// The same with leaders in `leaders`; the default is the secondary colour of the default theme. Leaders are thin and
/// end in a dot at the named object, so that they are not mistaken for vectors. A leader's stroke and dot directly
/// precede its label.
bool place_labels(Figure& figure, const Fonts& fonts, std::optional<Spot> room, Labelling labelling, Colour leaders);
/// Removes a trailing leader of this colour from the marks.
void drop_leader(std::vector<Mark>& marks, Colour leaders);

/// Estimated area of all requested names with their clearance, mm², whether or not they find places.
double room_of_names(const Figure& figure, const Fonts& fonts);

}  // namespace kinegraph::render
