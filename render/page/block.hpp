// Blocks: what is set and measured, to be moved to its place. They know no sheet and no figure.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

/// Something set and measured, mm, its top left at the origin.
struct Block {
    std::vector<Mark> marks;
    double width = 0, height = 0;
};
/// A block with its top left at a place.
void set(std::vector<Mark>& marks, Block block, Spot at);
/// The same text smaller or larger; figures are never scaled.
Block scaled(Block block, double factor);

/// A block that stays as it was set, for text that is tried in many places before it stands in one: copies share it.
class SharedBlock {
public:
    /// None: no marks, no size.
    SharedBlock() = default;
    SharedBlock(Block block) : block_(std::make_shared<const Block>(std::move(block))) {}  // NOLINT(google-explicit-constructor)
    const Block& operator*() const { return block_ ? *block_ : none(); }
    const Block* operator->() const { return &**this; }

private:
    static const Block& none();

    std::shared_ptr<const Block> block_;
};
SharedBlock scaled(const SharedBlock& block, double factor);

}  // namespace kinegraph::render
