// Magnitudes: the largest quantity of each kind in one solution, by construction and by check. They decide whether a
// difference is significant or rounding.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/file/units.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// The lengths of a record's drawn velocities and accelerations, SI, by Protocol::vectors; none for a force.
std::vector<std::optional<double>> moduli_of_motion(const Protocol& protocol);

/// The largest of each kind, SI units, including given values of drivers and loads. Kinds related by one motion share
/// their scale through the size L of the drawing: where points move at v, the scale of ω is v/L; where bodies rotate at
/// ω, the scale of velocity is ω·L, and so on to ω²·L; where a force F acts, the scale of couples is F·L. So a kind
/// that vanishes altogether (no body rotates) has a scale too.
class Magnitudes {
public:
    explicit Magnitudes(const Solution& solution) : Magnitudes(solution, moduli_of_motion(solution.protocol)) {}
    /// With the moduli of the solution's record, if already computed.
    Magnitudes(const Solution& solution, const std::vector<std::optional<double>>& moduli);

    double of(const Quantity& quantity) const;

    /// The check's equations are accurate to about 1e-13 of the largest value of their kind, and lose a few digits more
    /// near a dead point; tables print at most six. Below this share of the largest, a value is the check's rounding
    /// error.
    static constexpr double noise = 1e-9;
    bool is_noise(const Quantity& quantity, double value) const;

private:
    double& largest(QuantityKind unit) { return largest_[static_cast<std::size_t>(unit)]; }
    void take(const Quantity& quantity, double value);
    void take_what_is_given();
    void tie_together(double size);

    std::array<double, count_of_quantity_kinds> largest_{};
    const Mechanism& mechanism_;
    const Pose& pose_;
};

}  // namespace kinegraph
