// What a page's glyphs look like: all that a backend has to know of a font. Shaping is render/text/text.hpp's.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "render/ink/path.hpp"

namespace kinegraph::render {

/// One command of a glyph's outline, in units of the em (y upwards).
struct Outline {
    std::vector<Segment> segments;
};

/// The faces that the glyphs of a page belong to. Only virtual functions, so that a backend needs nothing of shaping.
class Glyphs {
public:
    virtual ~Glyphs() = default;
    /// The outline of a glyph, em units, y upwards; cached.
    virtual const Outline& outline(std::uint8_t face, std::uint32_t index) const = 0;
    /// The bytes of a face's file; they live as long as the Glyphs.
    virtual std::string_view file(std::uint8_t face) const = 0;

protected:
    Glyphs() = default;
    Glyphs(const Glyphs&) = default;
    Glyphs& operator=(const Glyphs&) = default;
};

}  // namespace kinegraph::render
