// A page as pixels in memory, equal to those of its PNG but without encoding and decoding.
#pragma once

#include "render/backends/picture_difference.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// The pixels of to_png's picture.
Picture to_picture(const Page& page, const Glyphs& glyphs, double dpi);

}  // namespace kinegraph::render
