// Renders an SVG by librsvg's program rsvg-convert. A separate process adds nothing to the start of the other commands,
// and isolates the effects of a hostile file.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "app/files/messages.hpp"

namespace kinegraph::app {

struct NotDrawn {
    Status status = Status::bad_input;  ///< `output` if the program is missing
    Words why;
};
/// A PNG of the SVG at `dpi` dots per inch. Files that the SVG refers to are not read.
tl::expected<std::string, NotDrawn> svg_to_png(const std::string& svg, double dpi);

}  // namespace kinegraph::app
