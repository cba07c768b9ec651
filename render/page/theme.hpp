// Themes: one table of pens, sizes and colours (lengths in mm, type in points). Three themes are built in; a user's
// file may change any entry (docs/themes.md).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/file/error.hpp"
#include "engine/number/index.hpp"
#include "render/ink/path.hpp"

namespace kinegraph::render {

/// The look of one body: its lines, the tint of its plates and blocks, its letters (contrast at least 4.5:1).
struct BodyColour {
    Colour line, tint, letter;
    /// Line kind, for themes whose colours do not distinguish all bodies in grey: dash, gap, dash … (mm); empty: full
    /// line. With a line kind, links are outlines with these dashes inside; blocks and wheels are drawn dashed. Vectors
    /// are solid, because a dashed side is an internal force: there the colours alone tell bodies apart.
    std::vector<double> dashes{};
};

/// The looks `full`, followed by those `dashed` with a line kind: in grey, lightness distinguishes five lines at most.
std::vector<BodyColour> with_line_kinds(std::vector<BodyColour> full, const std::vector<BodyColour>& dashed);

struct Theme {
    Colour paper{0xFF, 0xFF, 0xFF};
    Colour text{0x1B, 0x1B, 0x1F};
    Colour secondary{0x6B, 0x6B, 0x73};  ///< construction, lines of action, remarks
    Colour skeleton{0x9A, 0x9A, 0xA2};   ///< the mechanism under vectors
    Colour faint{0xC4, 0xC4, 0xCA};      ///< auxiliary lines behind all others
    Colour accent{0xA0, 0x12, 0x7C};     ///< additions of the current step; earlier content is then secondary
    bool in_one_ink = false;             ///< a colour that the file gives a body is not drawn
    /// By body (the frame not counted), cyclic. Ten colours that colour-blind readers tell apart; the first five also
    /// in grey, by lightness, and from the sixth body on with dashes.
    std::vector<BodyColour> bodies = with_line_kinds({{{0xC8, 0x40, 0x0F}, {0xF9, 0xE3, 0xDA}, {0xB5, 0x38, 0x0B}},
                                                      {{0xE6, 0xA8, 0x17}, {0xFC, 0xF0, 0xD2}, {0x94, 0x64, 0x00}},
                                                      {{0x0B, 0x44, 0x84}, {0xDC, 0xE8, 0xF4}, {0x0B, 0x44, 0x84}},
                                                      {{0x25, 0x9B, 0x7A}, {0xDC, 0xF1, 0xEA}, {0x15, 0x73, 0x57}},
                                                      {{0x3A, 0x0F, 0x2C}, {0xED, 0xE1, 0xE8}, {0x3A, 0x0F, 0x2C}}},
                                                     {{{0x8A, 0x78, 0xF6}, {0xEC, 0xE9, 0xFE}, {0x5F, 0x4B, 0xCC}},
                                                      {{0xC6, 0x96, 0xD2}, {0xF6, 0xEE, 0xF8}, {0x8A, 0x4F, 0x9A}},
                                                      {{0x66, 0x00, 0xC6}, {0xEC, 0xE0, 0xF8}, {0x66, 0x00, 0xC6}},
                                                      {{0x5A, 0x12, 0x00}, {0xEF, 0xE3, 0xDD}, {0x5A, 0x12, 0x00}},
                                                      {{0xA2, 0x48, 0x36}, {0xF3, 0xE6, 0xE3}, {0x9A, 0x40, 0x2E}}});
    const BodyColour& body(BodyIndex index) const {
        return bodies[index > frame ? (at_index(index) - 1) % bodies.size() : 0];
    }
    /// The look of a body; the frame, pins and `none` look like text.
    BodyColour colour_of(BodyIndex index) const {
        return index > frame ? body(index) : BodyColour{text, paper, text, {}};
    }

    // Line widths, mm.
    double link = 2.0, vector = 0.7, outline = 0.35, thin = 0.18;
    // Type sizes, points.
    double title = 15, equation = 12, label = 11, derived = 9.5, body_text = 9, small = 8.5, block = 7;
};

/// The names of the built-in themes: colour, print, dark.
const std::vector<std::string_view>& theme_names();
/// "colour", "print" (black and one grey; line kinds distinguish bodies) or "dark" (for slides). Empty for other names.
std::optional<Theme> built_in_theme(std::string_view name);
/// Reads a theme from JSON text (docs/themes.md). Errors: every fault of the file, with its JSON pointer.
Result<Theme> read_theme(std::string_view text);

}  // namespace kinegraph::render
