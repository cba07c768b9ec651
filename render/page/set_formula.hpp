// Typesetting of formulas: boxes with a baseline, composed from the inside out. Independent of equations.
#pragma once

#include "render/page/block.hpp"
#include "render/text/math.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// A formula at `size` points. If it is wider than `measure` mm, it is broken before its signs. What cannot be broken
/// (a matrix) is set smaller, down to three fifths of the size.
Block formula_block(const Formula& formula, const Fonts& fonts, double size, double measure, Colour colour);

/// A formula on one line, of any width, with the distance of its baseline below its top (mm), to be aligned with
/// others.
struct SetLine {
    Block block;
    double baseline = 0;
};
SetLine formula_line(const Formula& formula, const Fonts& fonts, double size, Colour colour);

}  // namespace kinegraph::render
