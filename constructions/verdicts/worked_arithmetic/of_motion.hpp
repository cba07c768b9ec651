// Worked arithmetic of motion: v = ω·r, a^n = ω²·r, a_cor = 2·ω·v_rel, ω = v/r, sliding velocities, ratios by instant
// centres, Euler–Savary.
#pragma once

#include <optional>

#include "constructions/verdicts/worked_arithmetic/formulas.hpp"

namespace kinegraph::worked_arithmetic {

class OfMotion {
public:
    explicit OfMotion(Telling& telling)
        : telling_(telling),
          solution_(telling.solution()),
          protocol_(solution_.protocol),
          units_(solution_.mechanism.units),
          magnitudes_(telling.magnitudes()) {}

    /// Sliding velocities; their sentences are in the order of the slidings.
    void add_slidings();
    /// The length of a drawn vector, for the statement that draws it.
    void drawn(const DrawnVector& vector);
    /// ω = v/r, α = a^t/r of two points of the body.
    void turning_found(StatementIndex statement, const Quantity& quantity, Symbol::Letter letter);
    /// ω_4 = ω_2 · P_12 P_24 / P_14 P_24.
    void carried_over(const SecondWay& way);
    /// δ is measured; ρ_C = PC²/CW (Euler–Savary).
    void of_curvature(const Curvature& curvature);

private:
    void slides(StatementIndex statement, const Recorded<Vector>& found, const Unit& unit);
    void tell_direction(const DrawnVector& coriolis);
    void tell_place(const DrawnVector& of_auxiliary);
    std::optional<Vector> auxiliary_named(const std::string& name) const;
    bool is_known(const DrawnVector& vector) const;
    Factors factors_of(const DrawnVector& vector, double si);
    std::optional<double> speed_in_slot(const DrawnVector& normal) const;
    double lever_of(const DrawnVector& vector) const;
    std::optional<double> segment_length(const Segment& segment) const;
    std::optional<Vector> centre_of(BodyIndex first, BodyIndex second) const;
    const Unit& unit_of(const DrawnVector& vector) const;

    Telling& telling_;
    const Solution& solution_;
    const Protocol& protocol_;
    const Units& units_;
    const Magnitudes& magnitudes_;
};

}  // namespace kinegraph::worked_arithmetic
