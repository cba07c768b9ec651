// Headings and paragraphs.
#include "render/equations/prose.hpp"

#include <algorithm>
#include <utility>

#include "render/page/shapes.hpp"

namespace kinegraph::render {

Block heading_block(const DrawingContext& context, double measure, const std::string& text, const RichText& note) {
    Block block;
    ShapedLine shaped = context.fonts.shape(one_piece(text, Face::bold), context.theme.label);
    const double width = shaped.width;
    set_text(block.marks, std::move(shaped), {0, 3.6}, context.theme.text, "text");
    if (!note.empty()) {
        ShapedLine small = context.fonts.shape(note, context.theme.small);
        if (width + 4 + small.width <= measure)
            set_text(block.marks, std::move(small), {width + 4, 3.6}, context.theme.secondary, "text");
    }
    block.width = measure;
    block.height = heading_height;
    return block;
}

namespace {

constexpr double first_baseline = 3.2;

}  // namespace

Paragraph::Paragraph(const DrawingContext& context, RichText text, double indent, std::string number)
    : context_(context),
      text_(context.fonts.measured(std::move(text), context.theme.body_text)),
      indent_(indent),
      number_(std::move(number)) {}

std::vector<Paragraph::Line> Paragraph::lines(double measure) const {
    std::vector<Line> lines;
    for (const MeasuredText::Line& words : text_.lines(measure - indent_)) {
        // Scripts above and below letters may need more than the line spacing.
        constexpr double clear = 0.15;
        const double baseline =
            lines.empty() ? first_baseline
                          : lines.back().baseline + std::max(lead(), lines.back().words.under + words.over + clear);
        lines.push_back({words, baseline});
    }
    return lines;
}

double Paragraph::height_of(const std::vector<Line>& lines) const {
    return (lines.empty() ? first_baseline : lines.back().baseline) + lead() - first_baseline + 0.7;
}
double Paragraph::height(double measure) const { return height_of(lines(measure)); }

Block Paragraph::set(double measure) const {
    const std::vector<Line> all = lines(measure);
    return set(all, measure, {0, all.size(), height_of(all)});
}

std::vector<Paragraph::Part> Paragraph::parts(double measure, double most) const {
    const std::vector<Line> all = lines(measure);
    const double below = height_of(all) - (all.empty() ? 0 : all.back().baseline);  // under the last baseline
    std::vector<Part> parts;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double above = parts.empty() ? 0 : all[parts.back().first].baseline - first_baseline;
        const double height = all[i].baseline - above + below;
        if (parts.empty() || height > most)
            parts.push_back({i, i + 1, first_baseline + below});
        else
            parts.back() = {parts.back().first, i + 1, height};
    }
    return parts;
}

Block Paragraph::set(double measure, const Part& part) const { return set(lines(measure), measure, part); }

Block Paragraph::set(const std::vector<Line>& all, double measure, const Part& part) const {
    const Theme& theme = context_.theme;
    Block block;
    if (!number_.empty() && part.first == 0)
        set_text(block.marks, context_.fonts.shape(one_piece(number_), theme.body_text), {0, first_baseline},
                 theme.secondary, "text");
    const double above = all.empty() ? 0 : all[part.first].baseline - first_baseline;
    for (std::size_t i = part.first; i < part.end; ++i)
        set_text(block.marks, context_.fonts.set(text_, all[i].words), {indent_, all[i].baseline - above}, theme.text,
                 "text");
    block.width = measure;
    block.height = part.height;
    return block;
}

Block paragraph_block(const DrawingContext& context, double measure, const RichText& text, double indent,
                      const std::string& number) {
    return Paragraph(context, text, indent, number).set(measure);
}

}  // namespace kinegraph::render
