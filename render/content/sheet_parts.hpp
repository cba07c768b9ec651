// Common parts of all sheets: papers with their frames, columns and title blocks. Lengths in mm. Depends on no figure
// and no sentence.
#pragma once

#include "render/ink/spot.hpp"

namespace kinegraph::render {

/// The slide is a page of 16:9 for a projector, without frame and title block.
enum class Paper { a4, a3, letter, slide };
enum class Orientation { landscape, portrait };
/// Detail of a solution: all of it, or what a lecturer would write on the board.
enum class SolutionDetail { full, brief };
/// How a superposition is drawn: one polygon a body, its sides grouped by load; or the figures of each load by itself.
enum class SuperposedLoads { joined, each };
/// Kinds of sheet made from one file: the worked solution, the exercise, the key.
enum class SheetKind { solution, question, answers };

constexpr double gap = 7;           ///< between cells and between columns
constexpr double text_gap = 4;      ///< between figures and the text below
constexpr double above_block = 4;   ///< kept free above the title block
constexpr double caption_line = 7;  ///< height of a caption of one line

/// A paper with its frame, content area, title block and text columns.
struct SheetFormat {
    const char* name = "";
    double width = 0, height = 0;
    bool large = false;  ///< larger type in the title block
    bool is_slide = false;
    Box inner;    ///< the frame
    Box content;  ///< the area within the frame; the title block covers a part of it
    Box block;
    int columns = 3;
    double measure = 80;         ///< width of a column
    double text_size = 1;        ///< size of text relative to the theme: smaller on small paper
    double price_of_a_page = 5;  ///< to the plan: as much as a figure gains from 16 mm to 70
    /// The width of `k` of `n` columns.
    double span(int k, int n) const { return (content.width() + gap) * k / n - gap; }
};
SheetFormat format_of(Paper paper, Orientation orientation);

}  // namespace kinegraph::render
