// The look: one readable table of pens, sizes and colours (measures in mm, type in points), three of which are built in
// and which a file of the user's may change (docs/themes.md). Decides nothing else.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/file/error.hpp"
#include "engine/number/index.hpp"
#include "render/ink/path.hpp"

namespace kinegraph::render {

/// How one body is told from the others: its lines, the tint of its plates and blocks, its letters (contrast 4.5:1 at
/// least).
struct BodyColour {
    Colour line, tint, letter;
    /// Its line kind where colours do not tell enough: dash, gap, dash … (mm); empty: a full line. Links then are
    /// outlined, with these dashes inside; vectors, blocks and wheels are drawn in them.
    std::vector<double> dashes{};
};

/// The looks of `bodies`, then the same colours again in a line kind: lightness tells no more than five lines apart in
/// grey.
std::vector<BodyColour> with_line_kinds(std::vector<BodyColour> bodies);

struct Theme {
    Colour paper{0xFF, 0xFF, 0xFF};
    Colour text{0x1B, 0x1B, 0x1F};
    Colour secondary{0x6B, 0x6B, 0x73};  ///< construction, lines of action, what is said in passing
    Colour skeleton{0x9A, 0x9A, 0xA2};   ///< of the mechanism where vectors are drawn on it
    Colour faint{0xC4, 0xC4, 0xCA};      ///< helping lines behind all others
    Colour accent{0xA0, 0x12, 0x7C};     ///< what a step adds; what was there is secondary then
    /// In the order of bodies (the frame not counted), cyclic. Five colours, colour-blind safe, lightness apart in
    /// grey; from the sixth body on with dashes.
    std::vector<BodyColour> bodies = with_line_kinds({{{0xC8, 0x40, 0x0F}, {0xF9, 0xE3, 0xDA}, {0xB5, 0x38, 0x0B}},
                                                      {{0xE6, 0xA8, 0x17}, {0xFC, 0xF0, 0xD2}, {0x94, 0x64, 0x00}},
                                                      {{0x0B, 0x44, 0x84}, {0xDC, 0xE8, 0xF4}, {0x0B, 0x44, 0x84}},
                                                      {{0x25, 0x9B, 0x7A}, {0xDC, 0xF1, 0xEA}, {0x15, 0x73, 0x57}},
                                                      {{0x3A, 0x0F, 0x2C}, {0xED, 0xE1, 0xE8}, {0x3A, 0x0F, 0x2C}}});
    const BodyColour& body(BodyIndex index) const {
        return bodies[index > frame ? (at_index(index) - 1) % bodies.size() : 0];
    }
    /// The same; what is the frame's, a pin's or no body's looks like text.
    BodyColour colour_of(BodyIndex index) const {
        return index > frame ? body(index) : BodyColour{text, paper, text, {}};
    }

    // Four weights of line, mm.
    double link = 2.0, vector = 0.7, outline = 0.35, thin = 0.18;
    // Type, points.
    double title = 15, equation = 12, label = 11, derived = 9.5, body_text = 9, small = 8.5, block = 7;
};

/// The names of the built-in themes: colour, print, dark.
const std::vector<std::string_view>& theme_names();
/// "colour", "print" (black and one grey: line kinds tell bodies apart) or "dark" (for slides).
std::optional<Theme> built_in_theme(std::string_view name);
/// A theme from the text of a JSON file, as docs/themes.md describes it. Errors: every fault of the file, with its
/// place.
Result<Theme> read_theme(std::string_view text);

}  // namespace kinegraph::render
