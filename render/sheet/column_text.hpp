// Column text: passages set in columns side by side, as even as their rows let them. Knows rows and headings, no sentence.
#pragma once

#include <functional>
#include <vector>

#include "render/sheet/bands.hpp"

namespace kinegraph::render {

class ColumnText {
public:
    /// Rows as they are set, then scaled; `measure`: width of a column, mm.
    ColumnText(std::vector<Passage> passages, double measure, double scale);

    bool empty() const { return passages_.empty(); }
    double measure() const { return measure_; }
    /// Whether a table is wider than its column.
    bool is_too_wide() const;
    /// The least height at which it stands in so many columns.
    double height(int columns) const;
    void set(std::vector<Mark>& marks, Spot at, int columns, double between) const;

private:
    bool flow(int columns, double height, const std::function<void(const Block&, int column, double y)>& place) const;

    std::vector<Passage> passages_;
    double measure_;
    mutable std::vector<double> heights_;  // by columns, once asked
};

}  // namespace kinegraph::render
