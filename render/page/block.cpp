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
    if (factor == 1) return block;
    return {block.width() * factor, block.height() * factor,
            [block, factor] { return scaled(block.set(), factor).marks; }};
}

SharedBlock::SharedBlock(Block block)
    : kept_(std::make_shared<Kept>(Kept{block.width, block.height, std::move(block.marks), nullptr})) {}
SharedBlock::SharedBlock(double width, double height, Set set)
    : kept_(std::make_shared<Kept>(Kept{width, height, {}, std::move(set)})) {}

double SharedBlock::right() const {
    if (!kept_) return 0;
    if (!kept_->right) kept_->right = box_of(set().marks).max.x;
    return *kept_->right;
}

Block SharedBlock::set() const {
    if (!kept_) return {};
    return {kept_->set ? kept_->set() : kept_->marks, kept_->width, kept_->height};
}

}  // namespace kinegraph::render
