// The closure equations set for a column of the sheet.
#pragma once

#include <cstddef>
#include <vector>

#include "render/page/block.hpp"
#include "render/scene/drawing_context.hpp"
#include "render/tables/equation_text.hpp"

namespace kinegraph::render {

/// Sentences, formulas and the lines of tables as blocks, none wider than `measure` mm; headings are left to who sets passages.
std::vector<Block> equation_blocks(const DrawingContext& context, const std::vector<EquationItem>& items, double measure);

}  // namespace kinegraph::render
