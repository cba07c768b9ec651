// Free room: which parts of a page or a figure are inked, to about a millimetre. Depends on marks and boxes only.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

constexpr double clear = 3.5;  ///< kept free round everything that text is set beside, mm

/// Grid of inked cells of a page, 1 mm each.
class Occupancy {
public:
    Occupancy(double width, double height);
    void block(const Box& box);
    void block(const std::vector<Spot>& spots);
    /// The longest run of free rows over the columns [left, right], within [top, bottom], with `clear` kept on all
    /// sides.
    std::pair<double, double> longest_run(double left, double right, double top, double bottom) const;
    /// Whether a free rectangle of that size (mm) exists anywhere.
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

/// Summed-area table of an Occupancy: tests in constant time whether a box is free.
class FreeBoxes {
public:
    explicit FreeBoxes(const Occupancy& page);
    bool has(const Box& box) const;

private:
    int columns_, rows_;
    std::vector<int> inked_;  // one row and one column more than the page has cells
};

/// Spots that the marks cover, about one per millimetre; text and filled areas count as their boxes.
std::vector<Spot> covered(const std::vector<Mark>& marks);

/// The upper left corner at which a block of that size stands clear of the marks within a box: along the lower edge as
/// far left as possible, else along the upper edge. Empty if neither has room.
std::optional<Spot> free_place(const std::vector<Mark>& marks, const Box& within, Spot size);

}  // namespace kinegraph::render
