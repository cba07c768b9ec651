// Blocks: see block.hpp.
#include "render/page/block.hpp"

#include "render/page/shapes.hpp"

namespace kinegraph::render {

void set(std::vector<Mark>& marks, const Block& block, Spot at) {
    std::vector<Mark> moved = block.marks;
    move(moved, at.x, at.y);
    marks.insert(marks.end(), moved.begin(), moved.end());
}

namespace {

void scale(Path& path, double factor) {
    const auto at = [factor](Spot& spot) { spot = factor * spot; };
    for (Segment& segment : path.segments)
        std::visit(
            [&](auto& each) {
                if constexpr (requires { each.to.x; }) at(each.to);
                if constexpr (requires { each.control_1; }) at(each.control_1), at(each.control_2);
                if constexpr (requires { each.centre; }) at(each.centre), each.radius *= factor;
            },
            segment);
}

}  // namespace

Block scaled(Block block, double factor) {
    for (Mark& mark : block.marks) {
        if (auto* path = std::get_if<Path>(&mark)) scale(*path, factor);
        auto* text = std::get_if<TextMark>(&mark);
        if (text == nullptr) continue;
        for (Glyph& glyph : text->glyphs) glyph.size *= factor, glyph.origin = factor * glyph.origin;
        for (Path& extra : text->extras) scale(extra, factor), extra.pen.width *= factor;
        text->pivot = factor * text->pivot;
    }
    block.width *= factor;
    block.height *= factor;
    return block;
}

}  // namespace kinegraph::render
