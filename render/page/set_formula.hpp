// Formulas set in type: boxes with a baseline, put together from the inside out. Knows no equation.
#pragma once

#include "render/page/block.hpp"
#include "render/text/math.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// A formula at `size` points, broken before its signs where it is wider than `measure` mm; what cannot be broken (a
/// matrix) is set smaller, at most to three fifths, so that it stands within.
Block formula_block(const Formula& formula, const Fonts& fonts, double size, double measure, Colour colour);

/// On one line, however wide, with how far its baseline lies below its top (mm): for what stands beside others.
struct SetLine {
    Block block;
    double baseline = 0;
};
SetLine formula_line(const Formula& formula, const Fonts& fonts, double size, Colour colour);

}  // namespace kinegraph::render
