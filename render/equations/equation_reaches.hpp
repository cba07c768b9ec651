// Open chains: place, velocity and acceleration of the point they reach, and the same as an observer on the last body
// but one has them.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "engine/solution/solution.hpp"
#include "render/equations/equation_list.hpp"
#include "render/equations/equation_pen.hpp"

namespace kinegraph::render::closure {

class ReachText {
public:
    ReachText(const Solution& solution, const EquationPen& pen, EquationList& list)
        : e_(*solution.equations), mechanism_(solution.mechanism), pen_(pen), list_(list) {}

    void write_reaches();

private:
    struct Group {
        std::vector<Signed> terms{};
        std::array<double, 2> value{0, 0};
        void add(Signed term) { terms.push_back(std::move(term)); }
    };
    /// A complex number of metres a second, or a second squared, as the file has them.
    Formula complex(const std::array<double, 2>& of, QuantityKind kind) const;
    /// Where the last bodies turn against each other: what an observer on the one before sees, and what he adds.
    bool write_groups(const Equations::Reach& reach);
    /// (radial + i across) z.
    static void add(std::array<double, 2>& to, const std::array<double, 2>& z, double radial, double across);
    double rate(const std::vector<LetterIndex>& letters, int dots) const;

    const Equations& e_;
    const Mechanism& mechanism_;
    const EquationPen& pen_;
    EquationList& list_;
};

}  // namespace kinegraph::render::closure
