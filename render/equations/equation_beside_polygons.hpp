// What the equations give, beside what the polygons give of the same.
#pragma once

#include <optional>

#include "engine/solution/solution.hpp"
#include "render/equations/equation_list.hpp"
#include "render/equations/equation_pen.hpp"

namespace kinegraph::render::closure {

class DrawnRates {
public:
    DrawnRates(const Solution& solution, const EquationPen& pen, EquationList& list)
        : solution_(solution), e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_values();

private:
    struct Drawn {
        std::optional<double> rate, acceleration;
    };
    /// What the polygons say of a letter: turns of bodies, and slides along their guides.
    Drawn drawn(LetterIndex index) const;
    std::optional<double> direction_of_slide(LetterIndex index) const;

    const Solution& solution_;
    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

}  // namespace kinegraph::render::closure
