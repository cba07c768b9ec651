// Names that are joined to one, such as those of the points on a line.
#pragma once

#include "render/text/rich_text.hpp"

namespace kinegraph::render {

/// Appends a point to the name of a line. Names of one or two letters are concatenated, "O₂A"; a longer name is
/// separated by a dash, so that it remains recognisable.
void append_point(RichText& line, const RichText& point);

}  // namespace kinegraph::render
