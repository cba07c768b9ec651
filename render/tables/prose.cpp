// Headings and paragraphs.
#include "render/tables/prose.hpp"

#include <algorithm>
#include <span>

#include "render/page/shapes.hpp"

namespace kinegraph::render {

Block heading_block(const DrawingContext& context, double measure, const std::string& text, const RichText& note) {
    Block block;
    const ShapedLine shaped = context.fonts.shape(one_piece(text, Face::bold), context.theme.label);
    set_text(block.marks, shaped, {0, 3.6}, context.theme.text, "text");
    if (!note.empty()) {
        const ShapedLine small = context.fonts.shape(note, context.theme.small);
        if (shaped.width + 4 + small.width <= measure)
            set_text(block.marks, small, {shaped.width + 4, 3.6}, context.theme.secondary, "text");
    }
    block.width = measure;
    block.height = 5.6;
    return block;
}

Block paragraph_block(const DrawingContext& context, double measure, const RichText& text, double indent,
                      const std::string& number) {
    Block block;
    double baseline = 3.2;
    if (!number.empty())
        set_text(block.marks, context.fonts.shape(one_piece(number), context.theme.body_text), {0, baseline},
                 context.theme.secondary, "text");
    const double lead = 3.85 / 9 * context.theme.body_text;
    double under = 0;  // the ink of the line before
    for (ShapedLine& each : context.fonts.wrap(text, context.theme.body_text, measure - indent)) {
        const std::size_t first = block.marks.size();
        set_text(block.marks, std::move(each), {indent, 0}, context.theme.text, "text");
        const auto line = std::span(block.marks).subspan(first);
        // What stands over and under letters may ask for more than the lead.
        constexpr double clear = 0.15;
        const Box ink = box_of(line);
        if (block.height > 0) baseline += std::max(lead, under - ink.min.y + clear);
        under = ink.max.y;
        move(line, 0, baseline);
        block.height = baseline;
    }
    block.width = measure;
    block.height = baseline + lead - 3.2 + 0.7;
    return block;
}

}  // namespace kinegraph::render
