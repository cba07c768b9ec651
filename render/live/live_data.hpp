// The data of the live page as JSON: the moving parts and their names in the figures (types: render/live/types.js).
#pragma once

#include <string>
#include <vector>

#include "engine/solution/moving.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/text/words.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

/// Safe in a script element: contains no "<".
std::string moving_json(const Moving& moving, const Solution& solution);
/// Meaning of the ids and labels in figures.
std::string names_json(const Solution& solution);
/// Data of a figure: position, scale, and the names in its labels, in drawing order.
std::string figure_json(const AloneFigure& figure);
/// The words of the page in its languages.
std::string words_json(Language asked);
/// The languages between which the reader of a page changes: the one asked for, and English; with English, Italian.
std::vector<Language> languages_of_page(Language asked);
/// The display unit of a column: symbol and size in SI.
Unit unit_of_column(const Column& column, const Units& units);

}  // namespace kinegraph::render
