// Table of papers with their frames, columns and title blocks.
#include "render/content/sheet_parts.hpp"

#include "engine/number/assert.hpp"

namespace kinegraph::render {
namespace {

constexpr double frame_left = 20, frame_other = 10;  // mm; ISO 5457: the left one is for binding

SheetFormat format(const char* name, double width, double height, Spot block, double padding, int columns, bool large) {
    SheetFormat f;
    f.name = name;
    f.width = width;
    f.height = height;
    f.large = large;
    f.inner = rectangle(frame_left, frame_other, width - frame_other, height - frame_other);
    f.content = rectangle(f.inner.min.x + padding, f.inner.min.y + padding - 1, f.inner.max.x - padding,
                          f.inner.max.y - padding + 1);
    f.block = rectangle(f.inner.max.x - block.x, f.inner.max.y - block.y, f.inner.max.x, f.inner.max.y);
    f.columns = columns;
    f.measure = f.span(1, columns);
    f.text_size = large ? 1 : 8.0 / 9;
    return f;
}

/// 8 in × 4.5 in: with 160 and 240 dots per inch a slide has 1280 × 720 and 1920 × 1080 pixels. The figures keep their
/// own type, which is a third larger on this page than on a sheet; sentences are set larger still.
SheetFormat slide() {
    constexpr double width = 203.2, height = 114.3, margin = 6, foot = 3;
    SheetFormat f;
    f.name = "16:9";
    f.width = width;
    f.height = height;
    f.is_slide = true;
    f.inner = f.content = rectangle(margin, margin, width - margin, height - margin);
    // An empty block: the room for the number of the page.
    f.block = rectangle(f.content.max.x, f.content.max.y - foot + above_block, f.content.max.x, f.content.max.y);
    f.columns = 3;
    f.measure = f.span(1, f.columns);
    f.text_size = 1.3;
    return f;
}

}  // namespace

SheetFormat format_of(Paper paper, Orientation orientation) {
    // On portrait paper the block is as wide as the frame or as whole columns, so that it cuts no column.
    const bool upright = orientation == Orientation::portrait;
    switch (paper) {
        case Paper::a4:
            return upright ? format("A4", 210, 297, {180, 18}, 6, 2, false)
                           : format("A4", 297, 210, {112, 18}, 6, 3, false);
        case Paper::a3:
            return upright ? format("A3", 297, 420, {172, 22}, 7, 3, true)
                           : format("A3", 420, 297, {190, 22}, 7, 4, true);
        case Paper::letter:
            return upright ? format("letter", 215.9, 279.4, {185.9, 18}, 6, 2, false)
                           : format("letter", 279.4, 215.9, {112, 18}, 6, 3, false);
        case Paper::slide: return slide();
    }
    KG_ASSERT(false, "a paper has a format");
}

}  // namespace kinegraph::render
