// The look: one readable table of pens, sizes and colours (docs: the measures are in mm, type in points). Decides nothing else.
#pragma once

#include <array>

#include "render/page.hpp"

namespace kinegraph::render {

/// A body's colour: lines, tint of plates and blocks, letters (darker, for contrast ≥ 5:1).
struct BodyColour {
    Colour line, tint, letter;
};

struct Theme {
    Colour text{0x1B, 0x1B, 0x1F};
    Colour secondary{0x6B, 0x6B, 0x73};
    Colour paper{0xFF, 0xFF, 0xFF};
    /// In the order of bodies (the frame not counted), cyclic. Colour-blind safe, lightness apart in grey.
    std::array<BodyColour, 5> bodies{{{{0xC8, 0x40, 0x0F}, {0xF9, 0xE3, 0xDA}, {0xB5, 0x38, 0x0B}},
                                      {{0xE6, 0xA8, 0x17}, {0xFC, 0xF0, 0xD2}, {0x94, 0x64, 0x00}},
                                      {{0x0B, 0x44, 0x84}, {0xDC, 0xE8, 0xF4}, {0x0B, 0x44, 0x84}},
                                      {{0x25, 0x9B, 0x7A}, {0xDC, 0xF1, 0xEA}, {0x15, 0x73, 0x57}},
                                      {{0x3A, 0x0F, 0x2C}, {0xED, 0xE1, 0xE8}, {0x3A, 0x0F, 0x2C}}}};
    const BodyColour& body(int index) const { return bodies[static_cast<std::size_t>(index > 0 ? (index - 1) % 5 : 0)]; }

    // Four weights of line, mm.
    double link = 2.0, vector = 0.7, outline = 0.35, thin = 0.18;
    // Type, points.
    double title = 15, equation = 12, label = 11, derived = 9.5, body_text = 9, small = 8.5, block = 7;
};

}  // namespace kinegraph::render
