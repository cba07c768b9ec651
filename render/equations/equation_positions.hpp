// Positions: each loop with its two parts, and the closed form of its unknowns where there is one; laws of rolling and
// gears.
#pragma once

#include <functional>
#include <vector>

#include "engine/solution/solution.hpp"
#include "render/equations/equation_list.hpp"
#include "render/equations/equation_pen.hpp"

namespace kinegraph::render::closure {

class PositionText {
public:
    PositionText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_positions();

private:
    /// Left = right; terms that vanish are left out.
    Formula both_sides(const Equations::Loop& loop, const std::function<Signed(const Side&)>& of) const;
    void write_law(const Equations::Law& law);
    void write_solved(const Equations::Loop& loop, std::size_t index);
    /// p e^{iσ} = …, with its numbers.
    void write_resultant(const Equations::Loop& loop, std::size_t index);
    void write_two_turns(const Equations::Loop& loop, std::size_t index);
    void write_turn_and_slide(const Equations::Loop& loop);
    /// sin β = −λ sin α + h/b, λ = a/b, where one crank and offsets are known; else all over b.
    void write_sine(const Side& first, const std::vector<Side>& known,
                    const std::function<Difference(const Side&)>& against);
    void write_turn_with_slide(const Equations::Loop& loop, std::size_t index);
    void write_turn_with_offset_slide(const Equations::Loop& loop, std::size_t index);
    /// No loop that is solved together with it: it is a block of its own.
    bool stands_alone(std::size_t index) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

}  // namespace kinegraph::render::closure
