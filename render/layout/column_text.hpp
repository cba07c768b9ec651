// Column text: passages in columns side by side, balanced as far as their rows allow. Works on rows and headings only.
#pragma once

#include <vector>

#include "render/content/bands.hpp"

namespace kinegraph::render {

/// A column for text: its position and top, and by how much its end is above the end of the others, mm.
struct TextColumn {
    double x = 0, top = 0, lift = 0;
};
using TextColumns = std::vector<TextColumn>;

/// A table of as many rows may be divided anywhere: kept whole, it would leave most of a page white.
constexpr std::size_t long_table = 25;

/// Whether a table or a heading is wider than a column of `measure` mm. `scale`: that of the rows.
bool is_wider(const Passage& passage, double scale, double measure);

class ColumnText {
public:
    /// Rows are typeset at scale 1 and scaled when they are placed; `measure`: width of a column, mm; `whole_tables`:
    /// no table is divided but a long one.
    ColumnText(std::vector<Passage> passages, double measure, double scale, bool whole_tables);

    bool empty() const { return passages_.empty(); }
    double measure() const { return measure_; }
    /// Whether a table or a heading is wider than its column.
    bool is_too_wide() const { return too_wide_; }
    /// The number of rows of tables in which a cell takes several lines.
    int broken_rows() const { return broken_rows_; }
    /// The least height for this number of columns, mm.
    double height(int columns) const {
        const auto index = static_cast<std::size_t>(columns);
        return index < heights_.size() && heights_[index] >= 0 ? heights_[index] : height_found(index);
    }
    /// `loose`: the greatest additional space between rows, as a fraction of their height; `room`: the height that its
    /// columns may take, some of which spaces its passages.
    void set(std::vector<Mark>& marks, Spot at, int columns, double between, double loose, double room) const;

    /// The same for columns of different tops and ends, from the first to the last.
    bool fits(const TextColumns& columns, double height) const;
    double height(const TextColumns& columns) const;
    void set(std::vector<Mark>& marks, Spot at, const TextColumns& columns, double loose, double room) const;
    /// The height in a single column.
    double whole_height() const;
    /// A lower bound of the sum of the heights of `columns` columns: the space between two passages may vanish at the
    /// end of a column.
    double least_height(int columns) const;

private:
    /// Rows that stay in one column. Their height includes what stands above them: the heading of a passage above its
    /// first rows, the head of a table there and at the top of a column.
    struct Group {
        std::size_t passage, first, end;
        double on, anew;  ///< height when the column goes on, and at the top of a column
    };
    /// Calls place() with each group, its position, and whether it begins a column. False if the text does not fit.
    template <class Place>
    bool flow(const TextColumns& columns, double height, Place place) const;

    double height_found(std::size_t columns) const;
    double height_of(const SharedBlock& block) const { return block.height() * scale_; }

    std::vector<Passage> passages_;
    double scale_;
    std::vector<Group> groups_;
    double measure_;
    bool too_wide_ = false;
    int broken_rows_ = 0;
    mutable std::vector<double> heights_;  // by number of columns; negative: not computed
    mutable double whole_ = -1;            // height in a single column; negative: not computed
};

}  // namespace kinegraph::render
