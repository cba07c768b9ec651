// Where the driver cannot drive: letters that rest in the drawn position, and the dead points of each loop along the
// driver's travel.
#pragma once

#include <string>
#include <vector>

#include "engine/solution/solution.hpp"
#include "render/equations/equation_list.hpp"
#include "render/equations/equation_pen.hpp"

namespace kinegraph::render::closure {

class DeadPointText {
public:
    DeadPointText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), pen_(pen), list_(list) {}

    void write_dead_points();

private:
    /// Of several loops each speaks for itself alone: another may stop the driver.
    void write_dead_points_of(const Equations::Loop& loop, std::size_t index);
    Words no_dead_point(bool is_only_loop) const;
    /// They stop no driver.
    Words change_points_of(const Equations::Solved& solved, bool is_only_loop) const;
    std::string list_of(const std::vector<double>& values, LetterIndex of) const;

    const Equations& e_;
    const EquationPen& pen_;
    EquationList& list_;
};

}  // namespace kinegraph::render::closure
