// Free room: which parts of a page or a figure are inked, to about a millimetre. Depends on marks and boxes only.
#pragma once

#include <optional>
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
    int inked_in(int left, int right, int top, int bottom) const;

    Spot origin_;
    int columns_, rows_;
    std::vector<int> inked_;  // above and left of each corner of a cell
};

/// Spots that the marks cover, about one per millimetre; text and filled areas count as their boxes.
std::vector<Spot> covered(const std::vector<Mark>& marks);

/// The upper left corner at which a block of that size stands clear of the marks within a box: along the lower edge as
/// far left as possible, else along the upper edge. Empty if neither has room.
std::optional<Spot> free_place(const std::vector<Mark>& marks, const Box& within, Spot size);

}  // namespace kinegraph::render
