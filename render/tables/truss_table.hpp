// The bars of a truss as a table, and as rows of the results. Numbers come from the Solution and its checks.
#pragma once

#include <vector>

#include "render/tables/tables.hpp"

namespace kinegraph::render {

/// Whether the forces of a truss have a plan in one figure.
bool has_plan(const Solution& solution);
/// The bars as lines of a table `width` mm wide, its head first: bar, spaces on either side, force, sense.
std::vector<Block> bar_lines(const DrawingContext& context, double width);
/// Rows of the results for the reactions and the bars; lengths as measured on figures.
std::vector<ResultRow> truss_rows(const DrawingContext& context, const std::vector<Figure>& figures);

}  // namespace kinegraph::render
