// The bars of a truss as a table, and as rows of the results. All numbers come from the Solution and its checks.
#pragma once

#include <vector>

#include "render/tables/tables.hpp"

namespace kinegraph::render {

/// Whether one figure shows the force plan of the truss.
bool has_plan(const Solution& solution);
/// The lines of a table of bars, `width` mm wide, head first: bar, spaces on either side, force, sense.
std::vector<Block> bar_lines(const DrawingContext& context, double width);
/// Rows of the results table for reactions and bars, with lengths measured on `figures`.
std::vector<ResultRow> truss_rows(const DrawingContext& context, const std::vector<Figure>& figures);

}  // namespace kinegraph::render
