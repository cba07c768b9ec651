// Typeface: one face of the font, as typesetting needs it: its characters, shaping of a run, glyph outlines. Only
// typeface.cpp depends on HarfBuzz.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "lang/words.hpp"

#include "render/text/glyphs.hpp"

namespace kinegraph::render {

/// Bounding box of ink, y upwards. Blank if right < left.
struct Ink {
    double left = 1, bottom = 0, right = 0, top = 0;
    bool blank() const { return right < left; }
};

/// Outline and ink of a glyph, em.
struct Drawn {
    Outline outline;
    Ink ink;
};

/// Purely virtual, so that the program can load HarfBuzz on demand.
class Typeface {
public:
    /// A glyph in a shaped run, in font units: its offset from the pen, and its advance. `from` is the index of its
    /// first character in the run.
    struct Placed {
        std::uint32_t glyph = 0;
        int x = 0, y = 0, advance = 0;
        std::uint32_t from = 0;
    };

    virtual ~Typeface() = default;
    virtual double unit() const = 0;  ///< em per font unit
    virtual std::size_t glyphs() const = 0;
    virtual bool has(char32_t character) const = 0;
    /// The precomposed character of a letter and a combining accent; 0 if Unicode has none.
    virtual char32_t composed(char32_t letter, char32_t accent) const = 0;
    /// Shapes characters that the face has, always from left to right.
    virtual void shape(std::span<const char32_t> run, std::vector<Placed>& placed) const = 0;
    virtual Drawn draw(std::uint32_t glyph) const = 0;
    /// The bytes of its file; valid as long as the face.
    virtual std::string_view file() const = 0;

protected:
    Typeface() = default;
    Typeface(const Typeface&) = default;
    Typeface& operator=(const Typeface&) = default;
};

/// Regular, italic, bold, bold italic, in the order of Face.
using Typefaces = std::array<std::unique_ptr<Typeface>, 4>;

/// The typeface of an OpenType file's bytes, which live as long as their owner; none if they are no font.
std::unique_ptr<Typeface> typeface_of(std::string_view file, std::shared_ptr<const void> owner);

/// Opens the four faces of STIX General from $KINEGRAPH_FONT_DIR, or from Debian's location. Error: names the missing
/// file and the Debian package (`fonts-stix`).
tl::expected<Typefaces, Words> open_typefaces();

}  // namespace kinegraph::render
