// Worked arithmetic of forces: F_i = −m·a_G, springs, resultants, offsets d = M/F, cuts by Ritter, superposition,
// virtual work.
#pragma once

#include <optional>

#include "constructions/verdicts/worked_arithmetic/formulas.hpp"

namespace kinegraph::worked_arithmetic {

class OfForces {
public:
    explicit OfForces(Telling& telling)
        : telling_(telling),
          solution_(telling.solution()),
          protocol_(solution_.protocol),
          units_(solution_.mechanism.units),
          magnitudes_(telling.magnitudes()) {}

    /// `in_all`: under all loads.
    void force_found(StatementIndex statement, const FreeBody& body, const AppliedForce& applied, bool in_all);
    /// An input couple with nothing to balance: M = 0. It is not drawn, so it is on no free body.
    void nothing_to_balance(StatementIndex statement, int effort);
    /// F_i = −m a_G, M_i = −J α.
    void inertia(StatementIndex statement);
    /// F = k · (l − l_0), M = −k · φ.
    void stretched(StatementIndex statement);
    /// F = mean intensity · length, and the distance of its line from the first end.
    void distributed(StatementIndex statement);
    /// A force by its magnitude, a couple with its sign.
    void left_over(const Resultant& resultant);
    /// For a cut: the moment of the forces on one side as ΣF·b, and F = M/b; across parallel bars F = component / sine.
    void by_ritter(const Truss::Cut& cut);
    /// Resultants, and the offset of an inertia force: d = M/F.
    void added_up(const FreeBody& body);
    void added_up(const TakenTogether& together);
    /// Each part, then the sums: F by its magnitude, M = M_2 + M_3.
    void superposed(const Superposition& superposition);
    /// The works in a virtual motion, and the ratios of its angular velocities.
    void by_virtual_work(const VirtualMotion& motion);

private:
    Factors force_times_arm(StatementIndex statement, const FreeBody& body, double couple) const;
    void by_moments_of_parallels(StatementIndex statement, const FreeBody& body, const AppliedForce& found);
    void moved_aside(StatementIndex statement, const FreeBody& body, const AppliedForce& applied);
    std::optional<Unit> unit_of_arm() const;
    void tell_aside(StatementIndex statement, double arm, double force);
    std::vector<Telling::Product> moments_on_side(const Truss::Cut& cut) const;
    bool is_by_virtual_work(StatementIndex statement);
    void product(StatementIndex statement, const Symbol& of, Factors factors, const Exact& made, double value,
                 const Unit& unit);
    void resultant_found(const AppliedForce& sum);
    bool moves(StatementIndex statement, const Symbol& force) const;
    void by_moments(const VirtualMotion& motion);

    Telling& telling_;
    const Solution& solution_;
    const Protocol& protocol_;
    const Units& units_;
    const Magnitudes& magnitudes_;
};

}  // namespace kinegraph::worked_arithmetic
