// The table of the letters: what is given, driven and sought, what each is and measures.
#pragma once

#include <string>

#include "engine/solution/solution.hpp"
#include "render/equations/equation_list.hpp"
#include "render/equations/equation_pen.hpp"

namespace kinegraph::render::closure {

class LettersTable {
public:
    LettersTable(const Solution& solution, const EquationPen& pen, EquationList& list)
        : solution_(solution), e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_letters();

private:
    Formula what_is(LetterIndex index) const;
    bool is_written(LetterIndex index) const;
    /// "OA" where both ends have names.
    Formula ends_of(LetterIndex length) const;
    /// "O_2", as figures have it.
    static Formula point_name(const std::string& name);
    std::string point_at(const Vector& place) const;

    const Solution& solution_;
    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

}  // namespace kinegraph::render::closure
