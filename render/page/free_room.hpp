// Free room: which parts of a page or a figure are inked, to about a millimetre. Depends on marks and boxes only.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

constexpr double clear = 3.5;  ///< kept free round everything that text is set beside, mm

/// Which cells of an area are inked, 1 mm each, as a summed-area table: what is free is told in constant time.
class Occupancy {
public:
    /// `inked`: spots, of which those outside the area are ignored.
    Occupancy(Spot origin, Spot size, const std::vector<Spot>& inked);
    /// Whether no cell that the box touches is inked.
    bool is_free(const Box& box) const;
    /// Whether a free rectangle of that size (mm) exists anywhere.
    bool has_free(int columns, int rows) const;

private:
    struct Cell {
        int x = 0, y = 0;
    };
    int inked_in(int left, int right, int top, int bottom) const;
    std::size_t corners_in_a_row() const { return static_cast<std::size_t>(end_.x - first_.x) + 1; }

    Spot origin_;
    int columns_, rows_;
    Cell first_, end_;        // of the cells that are inked; the rest needs no table
    std::vector<int> inked_;  // above and left of each corner of these
};

/// Spots that the marks cover, about one per millimetre; text and filled areas count as their boxes.
std::vector<Spot> covered(std::span<const Mark> marks);

/// The upper left corner at which a block of that size stands clear of the marks within a box: along the lower edge as
/// far left as possible, else along the upper edge. Empty if neither has room.
std::optional<Spot> free_place(const std::vector<Mark>& marks, const Box& within, Spot size);

}  // namespace kinegraph::render
