// The title block: title, kind of sheet, file, scale, paper, sheet number, units, accuracy.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/content/sheet_parts.hpp"
#include "render/figures/figure.hpp"

namespace kinegraph::render {

/// The title of the mechanism, or words that it has none.
std::string title_of(const Solution& solution, Language language);
/// On one line. A text that is too wide is cut in the middle, because a name from a list ends with the student’s
/// number.
ShapedLine shaped_with_its_end(const std::string& words, double size, const Fonts& fonts, double width);

/// Author and date as in the options; empty: none.
struct Signature {
    std::string author, date;
    std::string subtitle{};  ///< kind of sheet; empty: derived from the solution
};

/// Draws it into the corner of the frame, for page `index` of `count`. `scale_of_mechanism` (m per mm): that of the
/// first mechanism figure on the page.
void draw_title_block(std::vector<Mark>& marks, const DrawingContext& context, const SheetFormat& format,
                      std::optional<double> scale_of_mechanism, const Signature& signature, std::size_t index,
                      std::size_t count);

constexpr double strip_height = 5;  ///< mm; the strip on pages that follow the first

/// A page with its frame, title block and marks. If not `whole_block`, a strip of one line replaces the title block.
Page framed_page(const DrawingContext& context, const SheetFormat& format, const Signature& signature,
                 std::vector<Mark> marks, std::optional<double> scale_of_mechanism, std::size_t index,
                 std::size_t count, bool whole_block = true);

}  // namespace kinegraph::render
