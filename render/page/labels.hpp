// Labels: the names that a figure asks for, placed where they cover nothing.
#pragma once

#include <optional>

#include "render/page/figure.hpp"

namespace kinegraph::render {

/// On a page of any size nobody reads more: the richest example has 41.
constexpr std::size_t most_names = 80;

enum class Labelling {
    free,        ///< labels leave the room where nothing in it is free
    strict,      ///< rather than leave the room, a label goes into the key
    if_it_fits,  ///< none is set where figure and labels do not fit into the room
    if_all_free  ///< none is set where one of them finds no free place
};

/// Gives every request a place where it covers no stroke, no arrowhead and no other label, near its object;
/// deterministic. Appends the TextMarks (class "label") and grows the box. Obstacles are the figure's own marks.
/// `room`: the width and height (mm) that figure and labels should not exceed; a label wider than half of it ends in an
/// ellipsis (its aria-label says it all). What finds no place is listed in a key below the figure, by a number at its
/// object where that finds one; labels that must stay in the room go there rather than leave it. Of more than
/// `most_names` the first are set and the rest are the figure's `unnamed`. False: none was set.
bool place_labels(Figure& figure, const Fonts& fonts, std::optional<Spot> room = std::nullopt,
                  Labelling labelling = Labelling::free);
/// The same with leaders in this colour, else in that of the usual theme's secondary strokes. They are thin and end in
/// a dot at what they name, so that none is taken for a vector; a leader's stroke and its dot stand right before its
/// label.
bool place_labels(Figure& figure, const Fonts& fonts, std::optional<Spot> room, Labelling labelling, Colour leaders);
/// Takes the leader off marks that end with one of this colour.
void drop_leader(std::vector<Mark>& marks, Colour leaders);

/// What the names that a figure asks for will take with the air about them, mm²: places or none.
double room_of_names(const Figure& figure, const Fonts& fonts);

}  // namespace kinegraph::render
