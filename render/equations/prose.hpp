// Headings and paragraphs set to the width of a column, mm.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/page/block.hpp"
#include "render/scene/drawing_context.hpp"

namespace kinegraph::render {

/// A heading, with a note in small print beside it if there is room.
Block heading_block(const DrawingContext& context, double measure, const std::string& text, const RichText& note = {});
/// Height of heading_block(), mm.
constexpr double heading_height = 5.6;

/// A paragraph whose words are measured once, so that several widths can be tried. The context must outlive it.
class Paragraph {
public:
    /// With a hanging indent of `indent` mm behind its number.
    Paragraph(const DrawingContext& context, RichText text, double indent = 0, std::string number = {});
    double height(double measure) const;
    Block set(double measure) const;

    /// Consecutive lines, which may stand apart from the others. `most`: mm, the height that a part of more than one
    /// line does not exceed.
    struct Part {
        std::size_t first, end;  ///< lines
        double height;           ///< mm
    };
    std::vector<Part> parts(double measure, double most) const;
    Block set(double measure, const Part& part) const;

private:
    struct Line {
        MeasuredText::Line words;
        double baseline;
    };
    std::vector<Line> lines(double measure) const;
    double lead() const { return 3.85 / 9 * context_.theme.body_text; }
    double height_of(const std::vector<Line>& lines) const;
    Block set(const std::vector<Line>& all, double measure, const Part& part) const;

    const DrawingContext& context_;
    MeasuredText text_;
    double indent_;
    std::string number_;
};
/// A paragraph with a hanging indent of `indent` mm behind its number.
Block paragraph_block(const DrawingContext& context, double measure, const RichText& text, double indent = 0,
                      const std::string& number = {});

}  // namespace kinegraph::render
