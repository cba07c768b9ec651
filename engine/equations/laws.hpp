// Equations besides the loops: rolling and meshing, counted from the drawn position, and drivers of coordinates that
// exist already.
#pragma once

#include <utility>
#include <vector>

#include "engine/equations/letters.hpp"

namespace kinegraph::vector_loops {

class Laws {
public:
    Laws(const AsDrawn& drawn, const VectorGraph& graph, Letters& letters, Equations& found)
        : drawn_(drawn), graph_(graph), letters_(letters), found_(found) {}

    /// The letters of drivers without a coordinate of their own.
    const std::vector<std::pair<LetterIndex, int>>& apart() const { return apart_; }

    void write_laws();

private:
    /// ± the turn of a body: the letters that add up to it.
    void add_turn(Law::Part& part, int sign, BodyIndex body) const;
    /// κ s + x (θ_i − θ_j) is constant, x along n = z×t, s the displacement of the centre along t (κ = ±1).
    void write_rolling_on_line(Law& law, const Rolling& rolling);
    /// x_i (θ_i − φ) − x_j (θ_j − φ) is constant, φ the direction of the line of centres, or of the arm that carries
    /// it.
    void write_rolling_round(Law& law, const Rolling& rolling);
    /// A driver whose coordinate is already driven or fixed.
    void write_driver(int index);

    const AsDrawn& drawn_;
    const VectorGraph& graph_;
    Letters& letters_;
    Equations& found_;
    std::vector<std::pair<LetterIndex, int>> apart_;
};

}  // namespace kinegraph::vector_loops
