// Column text: passages set in columns side by side, as even as their rows let them. Knows rows and headings, no
// sentence.
#pragma once

#include <vector>

#include "render/content/bands.hpp"

namespace kinegraph::render {

/// A column that text flows through: where it stands, where it begins, and how far above the others it ends.
struct TextColumn {
    double x = 0, top = 0, lift = 0;
};
using TextColumns = std::vector<TextColumn>;

/// Whether a table or a heading is wider than a column of `measure` mm, rows scaled.
bool is_wider(const Passage& passage, double scale, double measure);

class ColumnText {
public:
    /// Rows as they are set, scaled where they come to stand; `measure`: width of a column, mm.
    ColumnText(std::vector<Passage> passages, double measure, double scale);

    bool empty() const { return passages_.empty(); }
    double measure() const { return measure_; }
    /// Whether a table or a heading is wider than its column.
    bool is_too_wide() const { return too_wide_; }
    /// The least height at which it stands in so many columns.
    double height(int columns) const {
        const auto index = static_cast<std::size_t>(columns);
        return index < heights_.size() && heights_[index] >= 0 ? heights_[index] : height_found(index);
    }
    /// `loose`: rows stand by so much of their height, at most, farther apart.
    void set(std::vector<Mark>& marks, Spot at, int columns, double between, double loose) const;

    /// The same in columns of different heights, from the first to the last.
    bool fits(const TextColumns& columns, double height) const;
    double height(const TextColumns& columns) const;
    void set(std::vector<Mark>& marks, Spot at, const TextColumns& columns, double loose) const;
    /// One column under the other.
    double whole_height() const;
    /// What so many columns together must have at least: where one ends, what is between two passages may fall away.
    double least_height(int columns) const;

private:
    /// Rows that no column parts, and how high they are with what stands over them: the heading over the first ones of
    /// a passage, the head over these and where a column begins.
    struct Group {
        std::size_t passage, first, end;
        double on, anew;  ///< going on in a column, beginning one
    };
    /// Shows place() each group, whether it begins a column, and where; false where it does not fit.
    template <class Place>
    bool flow(const TextColumns& columns, double height, Place place) const;

    double height_found(std::size_t columns) const;
    double height_of(const SharedBlock& block) const { return block.height() * scale_; }

    std::vector<Passage> passages_;
    double scale_;
    std::vector<Group> groups_;
    double measure_;
    bool too_wide_ = false;
    mutable std::vector<double> heights_;  // by columns, once asked
    mutable double whole_ = -1;            // … of all in one
};

}  // namespace kinegraph::render
