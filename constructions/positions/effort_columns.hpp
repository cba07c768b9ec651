// The last columns of a cycle: input forces and couples that only virtual work gives, not the reactions.
#pragma once

#include <vector>

#include "constructions/positions/effort_rows.hpp"
#include "engine/sentences/column.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

class EffortColumns {
public:
    /// Keeps references to both.
    EffortColumns(const Mechanism& mechanism, const GivensHere& givens)
        : mechanism_(mechanism), rows_(mechanism, givens) {}

    /// Adds the columns after all others.
    void add(const Solution& solution, std::vector<Column>& columns);
    std::size_t size() const { return by_work_.size(); }
    bool empty() const { return by_work_.empty(); }

    /// Keeps the displacements of a planned position for replay.
    void keep(const Displacements& found) { rows_.keep(found); }
    /// Takes the values of a planned position.
    void take(const Solution& planned) {
        here_ = planned.displacements ? EffortRows::of(*planned.displacements) : EffortRows::Efforts();
    }
    /// Computes the values at `places`, with the accelerations of this row; false if no kept displacements are valid
    /// there.
    bool replay(const Places& places, const Positions& positions, const std::vector<double>& row);
    /// False if a value is not determined in this position.
    bool fill(std::vector<double>& row, std::size_t behind) const;

private:
    void find_columns_of_masses(const Solution& solution, const std::vector<Column>& all);

    const Mechanism& mechanism_;
    EffortRows rows_;
    std::vector<std::size_t> by_work_;  ///< indices of input forces in the mechanism
    /// Columns of a mass's acceleration; beyond the end of a row if it has none, as for a body at rest.
    struct MassColumns {
        std::size_t x = ~std::size_t(0), y = ~std::size_t(0), alpha = ~std::size_t(0);
    };
    std::vector<MassColumns> mass_columns_;  ///< by Mechanism::masses, if inertia forces do work
    EffortRows::Efforts here_;
};

}  // namespace kinegraph
