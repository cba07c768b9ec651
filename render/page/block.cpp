// Blocks: see block.hpp.
#include "render/page/block.hpp"

#include <iterator>

#include "render/page/shapes.hpp"

namespace kinegraph::render {

void set(std::vector<Mark>& marks, Block block, Spot at) {
    move(block.marks, at.x, at.y);
    marks.insert(marks.end(), std::make_move_iterator(block.marks.begin()), std::make_move_iterator(block.marks.end()));
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
    if (factor == 1) return block;
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
SharedBlock scaled(const SharedBlock& block, double factor) {
    return factor == 1 ? block : SharedBlock(scaled(Block(*block), factor));
}

const Block& SharedBlock::none() {
    static const Block nothing;
    return nothing;
}

}  // namespace kinegraph::render
