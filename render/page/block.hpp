// Blocks: what is set and measured, to be moved to its place. They know no sheet and no figure.
#pragma once

#include <functional>
#include <memory>
#include <optional>
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

/// A block that is tried in many places before it stands in one: copies share it. Its size is known; its marks may be
/// set only once it has come to its place.
class SharedBlock {
public:
    using Set = std::function<std::vector<Mark>()>;

    /// None: no marks, no size.
    SharedBlock() = default;
    SharedBlock(Block block);  // NOLINT(google-explicit-constructor)
    SharedBlock(double width, double height, Set set);

    double width() const { return kept_ ? kept_->width : 0; }
    double height() const { return kept_ ? kept_->height : 0; }
    /// Where its marks end on the right; no marks: 0.
    double right() const;
    /// One to put in its place.
    Block set() const;

private:
    struct Kept {
        double width, height;
        std::vector<Mark> marks;
        Set set;  // empty: they are set
        std::optional<double> right{};
    };
    std::shared_ptr<Kept> kept_;
};
SharedBlock scaled(const SharedBlock& block, double factor);

}  // namespace kinegraph::render
