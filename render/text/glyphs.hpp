// Glyph outlines: all that a backend needs of a font. Shaping is in render/text/text.hpp.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "render/ink/path.hpp"

namespace kinegraph::render {

/// The outline of a glyph, in units of the em (y upwards).
struct Outline {
    std::vector<Segment> segments;
};

/// The font faces of a page's glyphs. Purely virtual, so that a backend does not depend on the shaping library.
class Glyphs {
public:
    virtual ~Glyphs() = default;
    /// The outline of a glyph, in units of the em, y upwards; cached.
    virtual const Outline& outline(std::uint8_t face, std::uint32_t index) const = 0;
    /// The bytes of a face's file; valid as long as the Glyphs.
    virtual std::string_view file(std::uint8_t face) const = 0;

protected:
    Glyphs() = default;
    Glyphs(const Glyphs&) = default;
    Glyphs& operator=(const Glyphs&) = default;
};

}  // namespace kinegraph::render
