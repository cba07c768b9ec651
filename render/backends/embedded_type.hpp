// The type that an SVG brings along for its words: subsets of the faces, as a style sheet. Knows no SVG beyond that.
#pragma once

#include <span>
#include <string>

#include "render/page/page.hpp"
#include "render/text/glyphs.hpp"

namespace kinegraph::render {

/// Faces to be named in a file.
struct EmbeddedType {
    std::string
        family;  ///< of its own for each set of faces, so that sheets put into one HTML page do not mix theirs up
    std::string rules;  ///< CSS: @font-face for each face that is used, its subset in a data URI
};

/// The faces that the words of a page need.
EmbeddedType embedded_type(std::span<const Mark> marks, const Glyphs& glyphs);

}  // namespace kinegraph::render
