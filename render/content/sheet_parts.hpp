// What the files of the sheet share: the papers with their frames, columns and title blocks. Measures in mm; knows no
// figure and no sentence.
#pragma once

#include "render/ink/spot.hpp"

namespace kinegraph::render {

enum class Paper { a4, a3, letter };
enum class Orientation { landscape, portrait };
/// How much of a solution is told: all of it, or what a lecturer chalks up.
enum class SolutionDetail { full, brief };
/// Of one file: the worked solution, the exercise as it is handed out, the key.
enum class SheetKind { solution, question, answers };

constexpr double gap = 7;           ///< between cells and between columns
constexpr double text_gap = 4;      ///< between figures and the text under them
constexpr double caption_line = 7;  ///< what a figure's caption takes on one line

/// A paper with what is fixed on it: the frame, what may be filled, the title block in the frame's corner, the text
/// columns.
struct SheetFormat {
    const char* name = "";
    double width = 0, height = 0;
    bool large = false;  ///< larger type in the title block
    Box inner;           ///< the frame
    Box content;         ///< inside of it; the title block is not taken off
    Box block;
    int columns = 3;
    double measure = 80;   ///< width of a column
    double text_size = 1;  ///< small paper carries smaller type: the text's size against the theme's
    /// The width of `k` of `n` columns.
    double span(int k, int n) const { return (content.width() + gap) * k / n - gap; }
};
SheetFormat format_of(Paper paper, Orientation orientation);

}  // namespace kinegraph::render
