// The data of the live page as JSON: the moving parts and their names in the figures (types: render/live/types.js).
#pragma once

#include <string>
#include <vector>

#include "engine/file/json_writer.hpp"
#include "engine/solution/moving.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/text/words.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

/// The member "moving".
void write_moving(const Moving& moving, const Solution& solution, JsonWriter& json);
/// The member "names": meaning of the ids and labels in figures.
void write_names(const Solution& solution, JsonWriter& json);
/// Data of a figure: what it is in the page, position, scale, and the names in its labels, in drawing order.
void write_figure(const AloneFigure& figure, const Solution& solution, JsonWriter& json);
/// The member "words": those of the page in its languages.
void write_words(Language asked, JsonWriter& json);
/// The languages between which the reader of a page changes: the one asked for, and English; with English, Italian.
std::vector<Language> languages_of_page(Language asked);
/// The display unit of a column: symbol and size in SI.
Unit unit_of_column(const Column& column, const Units& units);

}  // namespace kinegraph::render
