// What the files of the sheet share: the papers, a sheet in the making with its free runs, and a section of text before it is
// set. Measures in mm; knows no figure and no sentence.
#pragma once

#include <optional>
#include <vector>

#include "render/page/block.hpp"
#include "render/page/free_room.hpp"

namespace kinegraph::render {

enum class Paper { a4, a3, letter };
enum class Orientation { landscape, portrait };

constexpr double gap = 7;  ///< between cells and between columns
constexpr double section_gap = 5.5;

/// A paper with what is fixed on it: the frame, what may be filled, the title block in the frame's corner, the text columns.
struct SheetFormat {
    const char* name = "";
    double width = 0, height = 0;
    bool large = false;  ///< larger type in the title block, more figures on a page
    Box inner;           ///< the frame
    Box content;         ///< inside of it; the title block is not taken off
    Box block;
    int columns = 3;
    double measure = 80;  ///< width of a column
    /// A column's free height, above the title block where it stands there.
    Box column(int k) const;
};
SheetFormat format_of(Paper paper, Orientation orientation);

/// A column that text may flow into.
struct Run {
    Box box;
    double used = 0;
    int home = -1;  ///< the figure in whose cell it lies
    bool under_caption = false;
    double left() const { return box.height() - used; }
};

/// What stands together: a heading and what is below it; split only where it is longer than any column.
struct Section {
    std::vector<Block> rows{};
    std::vector<std::size_t> spare_rows{};  ///< of rows, ascending: those that may be left out
    Block heading_again{};                  ///< stands above what is left of the rows where they go on below something else
    int home = -1;                          ///< the figure it explains; −1: none
    bool continued = false;                 ///< its first rows stand already: the rest comes after them
    bool of_forces = false;                 ///< not before the pages of forces
    bool in_order = false;                  ///< steps that are read after those before them: it stands in no column before theirs
    double height() const {
        double sum = 0;
        for (const Block& row : rows) sum += row.height;
        return sum;
    }
};

/// A page in the making.
struct Sheet {
    std::vector<Mark> marks;
    std::vector<Run> runs;
    std::optional<double> scale_of_mechanism;  ///< m per mm, of the first drawing of it here
};

}  // namespace kinegraph::render
