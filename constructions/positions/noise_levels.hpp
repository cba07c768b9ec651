// Noise levels: below which a value of a row is rounding of the arithmetic. They follow from the data (size, rates,
// loads), since in a row that balances all values may be noise.
#pragma once

#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph {

class NoiseLevels {
public:
    NoiseLevels(const Mechanism& mechanism, const Pose& pose);

    /// By column, SI; zero where a column is exact. In a row near a limit or a pole the largest value of a kind counts,
    /// where it is larger than what the data can give.
    std::vector<double> of_row(const std::vector<Column>& columns, const std::vector<double>& row) const;
    /// Of a force in such a row.
    double of_forces(const std::vector<Column>& columns, const std::vector<double>& row) const;

private:
    /// What a kind of values can be: as they follow from the data, or in a row.
    struct Sizes {
        double velocity = 0;      ///< m/s
        double acceleration = 0;  ///< m/s²
        double force = 0;         ///< N

        /// By Tolerance::scale; null for other kinds.
        static double Sizes::*of(QuantityKind scale);
    };
    Sizes sizes_in(const std::vector<Column>& columns, const std::vector<double>& row) const;
    double level(const Column& column, const Sizes& sizes) const;
    void add_load(const Load& load);

    double size_ = 1;  ///< m
    Sizes usual_;      ///< as they follow from the data
};

}  // namespace kinegraph
