// Limits of what is laid out: a solution beyond them would take hundreds of pages, which nobody reads, and more memory
// than a machine for many requests has.
#pragma once

#include <optional>

#include "lang/words.hpp"
#include "render/page/page.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

/// Sentences of a solution on one sheet: some 40 pages.
constexpr std::size_t most_sentences = 2000;
/// Polygons of a solution on one sheet.
constexpr std::size_t most_polygons = 80;
/// Freedoms that are displaced separately, each with a figure of the whole mechanism.
constexpr std::size_t most_displacements = 12;
/// Bodies of one figure of the mechanism.
constexpr std::size_t most_drawn_bodies = 250;
/// How many times as far from the origin as a body is large points may lie.
constexpr double most_sizes_from_origin = 1e9;
/// Sentences of a solution that is drawn step by step, on a page each.
constexpr std::size_t most_steps = 240;
/// Sentences and loads, loads alone, and polygons, of a solution whose brief sheet is compared with its full one:
/// planning takes nearly all of the time of a sheet, the places of the names of many loads above all, and a comparison
/// plans three times.
constexpr std::size_t most_compared = 200, most_compared_loads = 40, most_compared_polygons = 24;

/// Whether a brief sheet keeps the scales of the full one: those of dozens of pages are not compared.
bool is_planned_twice(const Solution& solution);
/// Why the points cannot be drawn, with a remedy; none if they can.
std::optional<Words> beyond_doubles(const Solution& solution);
/// Why a page cannot be written as it was laid out, with a remedy; none if it can.
std::optional<Words> beyond_paper(const Page& page);
/// Why a solution is not laid out, with the limit and a remedy; none if it is.
std::optional<Words> beyond_sheet(const Solution& solution);
/// The same of its steps.
std::optional<Words> beyond_steps(const Solution& solution);

}  // namespace kinegraph::render
