// Velocity ratios and their derivatives, in the units of the file; the closed form that the slider-crank has.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>

#include "engine/solution/solution.hpp"
#include "render/equations/equation_list.hpp"
#include "render/equations/equation_pen.hpp"

namespace kinegraph::render::closure {

class RatioText {
public:
    RatioText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_ratios();
    /// Of two drivers the mixed ones too.
    void write_second_ratios();

private:
    /// d of/d by; of several drivers' coordinates ∂ of/∂ by.
    Formula derivative(LetterIndex of, LetterIndex by) const;
    Formula second_derivative(LetterIndex of, LetterIndex first, LetterIndex second) const;
    /// The index of Λ: the coordinate, and of several drivers' which of them.
    std::string index_of(LetterIndex of, std::initializer_list<LetterIndex> by) const;
    std::string plain_sub(LetterIndex of) const { return unicode_letter(pen_.letter(of).symbol) + pen_.letter(of).sub; }
    /// What rad or m of `of` is for each of the others, in the file's unit of length.
    std::string ratio_unit(LetterIndex of, std::initializer_list<LetterIndex> by) const;
    double ratio_in_units(LetterIndex of, std::initializer_list<LetterIndex> by, double si) const;
    Formula ratio_value(LetterIndex of, std::initializer_list<LetterIndex> by, double si) const;
    /// Of the slider-crank a e^{iα} + b e^{iβ} = c: dc/dα = −a (sin α − cos α tan β).
    std::optional<Formula> closed_ratio(LetterIndex of, LetterIndex by) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

}  // namespace kinegraph::render::closure
