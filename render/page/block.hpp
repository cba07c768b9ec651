// Blocks: content that is already set and measured, ready to be moved to its place. Independent of sheets and figures.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

/// Marks with their size, mm. The top left corner is at the origin.
struct Block {
    std::vector<Mark> marks;
    double width = 0, height = 0;
};
/// Appends the block's marks with its top left corner at `at`.
void set(std::vector<Mark>& marks, Block block, Spot at);
/// Scales a block of text. Figures are never scaled.
Block scaled(Block block, double factor);

/// A block that is tried in many places before it is placed once; copies share its content. The size is known from the
/// start; the marks may be computed only when the block is placed.
class SharedBlock {
public:
    using Set = std::function<std::vector<Mark>()>;

    /// An empty block: no marks, size 0.
    SharedBlock() = default;
    SharedBlock(Block block);  // NOLINT(google-explicit-constructor)
    SharedBlock(double width, double height, Set set);

    double width() const { return kept_ ? kept_->width : 0; }
    double height() const { return kept_ ? kept_->height : 0; }
    /// Right edge of its marks, mm; 0 without marks.
    double right() const;
    /// A copy of the block, to be placed.
    Block set() const;

private:
    struct Kept {
        double width, height;
        std::vector<Mark> marks;
        Set set;  // empty: the marks are computed already
        std::optional<double> right{};
    };
    std::shared_ptr<Kept> kept_;
};
SharedBlock scaled(const SharedBlock& block, double factor);

}  // namespace kinegraph::render
