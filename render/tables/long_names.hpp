// Long names in table cells: broken, set smaller and finally shortened, so that columns do not overlap.
#pragma once

#include <vector>

#include "render/text/text.hpp"

namespace kinegraph::render {

/// One line no wider than `room` mm: first smaller, down to a readable size, then with an ellipsis.
ShapedLine line_in_cell(const RichText& text, double size, const Fonts& fonts, double room);
/// The same on as many lines as necessary.
std::vector<ShapedLine> lines_in_cell(const RichText& text, double size, const Fonts& fonts, double room);

}  // namespace kinegraph::render
