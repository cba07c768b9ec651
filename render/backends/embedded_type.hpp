// Embedded fonts of an SVG: subsets of the faces as a style sheet. Independent of the rest of the SVG.
#pragma once

#include <span>
#include <string>

#include "render/page/page.hpp"
#include "render/text/glyphs.hpp"

namespace kinegraph::render {

/// Font rules to be embedded in a file.
struct EmbeddedType {
    std::string family;  ///< unique per set of faces, so that sheets combined into one HTML page keep their own fonts
    std::string rules;   ///< CSS: @font-face for each face that is used, with its subset in a data URI
};

/// The faces needed for the words of a page.
EmbeddedType embedded_type(std::span<const Mark> marks, const Glyphs& glyphs);

}  // namespace kinegraph::render
