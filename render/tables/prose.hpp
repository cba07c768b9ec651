// Prose: headings and paragraphs set to the width of a column, mm.
#pragma once

#include <string>

#include "render/page/block.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// A heading, and beside it, where there is room, a note in small print.
Block heading_block(const DrawingContext& context, double measure, const std::string& text, const RichText& note = {});
/// A paragraph, hanging by `indent` behind its number.
Block paragraph_block(const DrawingContext& context, double measure, const RichText& text, double indent = 0,
                      const std::string& number = {});

}  // namespace kinegraph::render
