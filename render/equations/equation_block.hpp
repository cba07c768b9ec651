// Closure equations as blocks for a column of the sheet.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "render/equations/equation_text.hpp"
#include "render/page/block.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// Formulas and table lines at their natural width, by item. They serve every column that is wide enough.
using NaturalBlocks = std::map<const EquationItem*, std::vector<Block>>;

/// Sentences, formulas and table lines as blocks, none wider than `measure` mm. Headings are left to the caller.
/// `natural` caches blocks for further widths of the same items.
std::vector<Block> equation_blocks(const DrawingContext& context, std::span<const EquationItem> items, double measure,
                                   NaturalBlocks& natural);

}  // namespace kinegraph::render
