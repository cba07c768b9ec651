// A face of the font as setting needs it: which characters it has, how a run of them is shaped, what its glyphs look
// like. HarfBuzz, which does it, is known to typeface.cpp alone.
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

#include "engine/file/words.hpp"

#include "render/text/glyphs.hpp"

namespace kinegraph::render {

/// A box around ink; nothing inked when right < left. y upwards.
struct Ink {
    double left = 1, bottom = 0, right = 0, top = 0;
    bool blank() const { return right < left; }
};

/// What a glyph looks like, em.
struct Drawn {
    Outline outline;
    Ink ink;
};

/// Only virtual functions, so that the program may open HarfBuzz late.
class Typeface {
public:
    /// A glyph in its place in a run, in units of the font: its offset from the pen, and how far it moves the pen.
    /// `from` counts the characters of the run that stand before it.
    struct Placed {
        std::uint32_t glyph = 0;
        int x = 0, y = 0, advance = 0;
        std::uint32_t from = 0;
    };

    virtual ~Typeface() = default;
    virtual double unit() const = 0;  ///< em for each unit of the font
    virtual std::size_t glyphs() const = 0;
    virtual bool has(char32_t character) const = 0;
    /// A letter and an accent written apart as Unicode's one character for both; none: 0.
    virtual char32_t composed(char32_t letter, char32_t accent) const = 0;
    /// Characters that the face has, from left to right always.
    virtual void shape(std::span<const char32_t> run, std::vector<Placed>& placed) const = 0;
    virtual Drawn draw(std::uint32_t glyph) const = 0;
    /// The bytes of its file; they live as long as the face.
    virtual std::string_view file() const = 0;

protected:
    Typeface() = default;
    Typeface(const Typeface&) = default;
    Typeface& operator=(const Typeface&) = default;
};

/// Regular, italic, bold, bold italic, as Face counts them.
using Typefaces = std::array<std::unique_ptr<Typeface>, 4>;

/// Opens the four faces of STIX General, from $KINEGRAPH_FONT_DIR or where Debian has them. Error: names the missing
/// file and the Debian package (`fonts-stix`).
tl::expected<Typefaces, Words> open_typefaces();

}  // namespace kinegraph::render
