// The data of the live page as JSON: what moves, and by which names the figures know it (shapes: render/live/types.js).
#pragma once

#include <string>
#include <vector>

#include "engine/solution/moving.hpp"
#include "engine/solution/solution.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

/// In a page's script element: no "<" stands in it.
std::string moving_json(const Moving& moving, const Solution& solution);
/// What the figures' ids and labels name.
std::string names_json(const Solution& solution);
/// Of a figure: where it stands, to which scale, and the names that its labels carry, in the order of the drawing.
std::string figure_json(const AloneFigure& figure);
/// The words of the page in both languages.
std::string words_json();
/// The columns' unit for readers: symbol and size in SI.
Unit unit_of_column(const Column& column, const Units& units);

}  // namespace kinegraph::render
