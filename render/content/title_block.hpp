// The title block: title, what the sheet is, file, scale, paper, sheet, units, accuracy.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/content/sheet_parts.hpp"
#include "render/figures/figure.hpp"

namespace kinegraph::render {

/// The mechanism's title, or that it has none.
std::string title_of(const Solution& solution, Language language);
/// On one line, cut in the middle where it is too wide: the end of a name from a list is the student’s number.
ShapedLine shaped_with_its_end(const std::string& words, double size, const Fonts& fonts, double width);

/// Who drew it and when, as given; empty: not said.
struct Signature {
    std::string author, date;
    std::string subtitle{};  ///< what the sheet is; empty: by what the solution holds
};

/// Drawn into the format's corner, on page `index` of `count`; the scale (m per mm) is that of the page's first drawing
/// of the mechanism, where it has one.
void draw_title_block(std::vector<Mark>& marks, const DrawingContext& context, const SheetFormat& format,
                      std::optional<double> scale_of_mechanism, const Signature& signature, std::size_t index,
                      std::size_t count);

constexpr double strip_height = 5;  ///< mm, of the line that pages carry which go on

/// A page with its frame, its title block and what is on it; without `whole_block` a strip of one line stands for that.
Page framed_page(const DrawingContext& context, const SheetFormat& format, const Signature& signature,
                 std::vector<Mark> marks, std::optional<double> scale_of_mechanism, std::size_t index,
                 std::size_t count, bool whole_block = true);

}  // namespace kinegraph::render
