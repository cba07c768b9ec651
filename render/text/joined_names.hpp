// Names that stand one behind the other, as those of the points that a line joins.
#pragma once

#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// Adds a point to what a line is named by. Names of a letter or two stand together, "O₂A"; where one is a word, a dash
/// parts them, for it would run into the other.
void append_point(RichText& line, const RichText& point);

}  // namespace kinegraph::render
