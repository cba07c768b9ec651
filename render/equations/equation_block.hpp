// The closure equations set for a column of the sheet.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "render/equations/equation_text.hpp"
#include "render/page/block.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// Formulas and lines of tables as wide as they like, by item: the same for every measure that holds them.
using NaturalBlocks = std::map<const EquationItem*, std::vector<Block>>;

/// Sentences, formulas and the lines of tables as blocks, none wider than `measure` mm; headings are left to who sets
/// passages. `natural` keeps what is set once, for further measures of the same items.
std::vector<Block> equation_blocks(const DrawingContext& context, std::span<const EquationItem> items, double measure,
                                   NaturalBlocks& natural);

}  // namespace kinegraph::render
