// An SVG as pixels, by librsvg's program rsvg-convert. As a program of its own it costs solve nothing, and what a
// hostile file does to it stays there.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "app/files/messages.hpp"

namespace kinegraph::app {

struct NotDrawn {
    Status status = Status::bad_input;  ///< output where the program is missing
    Words why;
};
/// The bytes of a PNG of the SVG at `dpi` dots per inch. Files that the SVG refers to are not read.
tl::expected<std::string, NotDrawn> svg_to_png(const std::string& svg, double dpi);

}  // namespace kinegraph::app
