// Free room: where a page or a figure is inked, to about a millimetre, and where a block may stand beside a figure. Knows marks
// and boxes only.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "render/page/sheet_parts.hpp"

namespace kinegraph::render {

/// Where a page is inked, to a millimetre.
class Occupancy {
public:
    Occupancy(double width, double height);
    void block(const Box& box);
    void block(const std::vector<Spot>& spots);
    /// The longest free run of rows over [left, right], `clear` kept on all sides, within [top, bottom].
    std::pair<double, double> longest_run(double left, double right, double top, double bottom) const;

private:
    bool is_free(int row, int from, int to) const;
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }
    friend class FreeBoxes;
    int columns_, rows_;
    std::vector<char> cells_;
};

/// Asked for many boxes of a page whether they are free: counts what is inked above and left of every place once.
class FreeBoxes {
public:
    explicit FreeBoxes(const Occupancy& page);
    bool has(const Box& box) const;

private:
    int columns_, rows_;
    std::vector<int> inked_;  // a row and a column more than the page has cells
};

/// Places that marks cover, about one each millimetre; text and filled areas as their boxes.
std::vector<Spot> covered(const std::vector<Mark>& marks);

/// Blocks one under the other, or side by side.
Block arranged(const std::vector<Block>& blocks, bool in_a_row);
/// A figure into the middle of a room across, and under its caption: what is left stays in one piece.
void centre(Figure& figure, const Box& room);
/// The first of the blocks that finds a corner of the room which the figure leaves free: the figure is moved, the block set.
bool set_beside(std::vector<Mark>& marks, Figure& figure, const std::array<Block, 2>& blocks, const Box& room);

}  // namespace kinegraph::render
