// The last columns of a cycle's rows: efforts that virtual work gives, and reactions do not.
#pragma once

#include <vector>

#include "constructions/positions/effort_rows.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph {

class EffortColumns {
public:
    /// Both are kept by reference.
    EffortColumns(const Mechanism& mechanism, const GivensHere& givens)
        : mechanism_(mechanism), rows_(mechanism, givens) {}

    /// Behind all others.
    void add(const Solution& solution, std::vector<Column>& columns);
    std::size_t size() const { return by_work_.size(); }
    bool empty() const { return by_work_.empty(); }

    /// The displacements of a position that was planned serve for those like it.
    void keep(const Displacements& found) { rows_.keep(found); }
    /// The efforts of a position that was planned, from here on.
    void take(const Solution& planned) {
        here_ = planned.displacements ? EffortRows::of(*planned.displacements) : EffortRows::Efforts();
    }
    /// Those of the position of `places`, with the accelerations of this row; false: no displacements kept hold there.
    bool replay(const Places& places, const Positions& positions, const std::vector<double>& row);
    /// False: the position leaves one of them open.
    bool fill(std::vector<double>& row) const;

private:
    void find_columns_of_masses(const Solution& solution, const std::vector<Column>& all);

    const Mechanism& mechanism_;
    EffortRows rows_;
    std::vector<std::size_t> by_work_;  ///< efforts, by index in the mechanism
    /// Where the acceleration of a mass stands in a row; beyond its end: it has none, as of a body at rest.
    struct MassColumns {
        std::size_t x = ~std::size_t(0), y = ~std::size_t(0), alpha = ~std::size_t(0);
    };
    std::vector<MassColumns> mass_columns_;  ///< by Mechanism::masses, where their inertia does work
    EffortRows::Efforts here_;
};

}  // namespace kinegraph
