// Free room: where a page or a figure is inked, to about a millimetre. Knows marks and boxes only.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

constexpr double clear = 3.5;  ///< round everything that text is set beside

/// Where a page is inked, to a millimetre.
class Occupancy {
public:
    Occupancy(double width, double height);
    void block(const Box& box);
    void block(const std::vector<Spot>& spots);
    /// The longest free run of rows over [left, right], `clear` kept on all sides, within [top, bottom].
    std::pair<double, double> longest_run(double left, double right, double top, double bottom) const;
    /// Whether somewhere so many columns and rows of it, millimetres, are free together.
    bool has_free(int columns, int rows) const;

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

/// Where within a box a block of that size stands clear of the marks: its upper left corner, on the lower edge as far
/// left as there is room, else on the upper; nothing where both are taken.
std::optional<Spot> free_place(const std::vector<Mark>& marks, const Box& within, Spot size);

}  // namespace kinegraph::render
