// Velocities and accelerations: the loops derived, the Jacobian block by block with its determinant, in symbols and in
// numbers.
#pragma once

#include <cstddef>
#include <optional>

#include "engine/solution/solution.hpp"
#include "render/equations/equation_list.hpp"
#include "render/equations/equation_pen.hpp"

namespace kinegraph::render::closure {

class RateText {
public:
    RateText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_velocities();
    void write_accelerations();

private:
    Formula derived(const Equations::Loop& loop, bool twice) const;
    /// A sum's terms with one rate more.
    static Sum times_rate(Sum sum, LetterIndex rate, int dots);
    std::size_t column_of(LetterIndex unknown) const;
    bool is_in(const Equations::Block& block, LetterIndex unknown) const;
    /// What a row's known terms make, sent to the right.
    Sum known_terms(const Equations::Block& block, std::size_t row, int dots) const;
    double length_unit() const { return mechanism_.units.length.si.to_double(); }
    bool is_of_turns(std::size_t row) const;
    double in_units(std::size_t row, LetterIndex unknown, double entry) const;
    Formula unknowns_column(const Equations::Block& block, int dots) const;
    Formula matrix(const Equations::Block& block, bool symbols) const;
    /// Without the dust that sines of right angles leave.
    double rounded(double entry) const;
    Formula right_side(const Equations::Block& block, int dots, bool symbols) const;
    /// Of a square block, by elimination in doubles.
    std::optional<double> determinant(const Equations::Block& block) const;
    bool rates_known(const Equations::Block& block, int dots) const;
    void write_block(const Equations::Block& block, int dots);
    std::size_t longest_right_side(const Equations::Block& block, int dots) const;
    /// Characters of the longest row.
    std::size_t widest_right_side(const Equations::Block& block, int dots) const;
    void write_long_right_side(const Equations::Block& block, int dots, Formula left);
    /// J = [J_1 J_2 …], a few columns each.
    void write_in_parts(const Equations::Block& block);
    void write_determinant(const Equations::Block& block);
    /// b c sin(γ − β), b cos(β − γ), s: of a dyad's two rows, up to the sign, which the number tells.
    std::optional<Formula> closed_determinant(const Equations::Block& block, double found) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

}  // namespace kinegraph::render::closure
