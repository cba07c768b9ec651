// Long names in tables: what a cell has no room for is broken, set smaller, and in the end cut short, so that columns
// keep to themselves.
#pragma once

#include <vector>

#include "render/text/text.hpp"

namespace kinegraph::render {

/// One line no wider than `room` mm: smaller as far as it can be read, then with an ellipsis.
ShapedLine line_in_cell(const RichText& text, double size, const Fonts& fonts, double room);
/// The same on as many lines as it takes.
std::vector<ShapedLine> lines_in_cell(const RichText& text, double size, const Fonts& fonts, double room);

}  // namespace kinegraph::render
