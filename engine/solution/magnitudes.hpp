// Magnitudes: how large the quantities of each kind get in one solution, by construction and by check. What difference
// counts and what is rounding is told by them. Computes no mechanics.
#pragma once

#include <optional>
#include <vector>

#include "engine/solution/solution.hpp"

namespace kinegraph {

/// The lengths of a record's drawn velocities and accelerations, SI, by Protocol::vectors; none of a force.
std::vector<std::optional<double>> moduli_of_motion(const Protocol& protocol);

/// The largest of each kind, SI units, what the file gives for drivers and loads included. Kinds that one motion ties
/// together share their measure across the size L of the drawing: where the points move at v a body that turns at v/L
/// turns at all, where bodies turn at ω a velocity of ω·L is one, and so on to ω²·L; where a force F acts, F·L is a
/// couple. So what vanishes altogether (no body turns) is measured, too.
class Magnitudes {
public:
    explicit Magnitudes(const Solution& solution) : Magnitudes(solution, moduli_of_motion(solution.protocol)) {}
    /// With the moduli of the solution's record, where they are at hand.
    Magnitudes(const Solution& solution, const std::vector<std::optional<double>>& moduli);

    double of(const Quantity& quantity) const;

    /// The check's equations are solved to some 1e-13 of the largest of their kind, and lose a few digits more near a
    /// dead point; no table prints more than six. What lies below this share of the largest is the check's rounding.
    static constexpr double noise = 1e-9;
    bool is_noise(const Quantity& quantity, double value) const;

private:
    void take(const Quantity& quantity, double value);
    void take_what_is_given();
    void tie_together(double size);

    double velocity_ = 0, acceleration_ = 0, omega_ = 0, alpha_ = 0, place_ = 0, force_ = 0, couple_ = 0, power_ = 0;
    const Mechanism& mechanism_;
    const Pose& pose_;
};

}  // namespace kinegraph
