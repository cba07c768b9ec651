// Which loops are written, in which order, from where and in which sense: one after the other that with fewest
// unknowns, so that a hand can solve it.
#pragma once

#include <set>
#include <vector>

#include "engine/equations/letters.hpp"
#include "engine/equations/loops.hpp"

namespace kinegraph::vector_loops {

class ChoiceOfLoops {
public:
    ChoiceOfLoops(const AsDrawn& drawn, VectorGraph& graph, Letters& letters, Equations& found)
        : drawn_(drawn), graph_(graph), letters_(letters), found_(found) {}

    void choose_loops();

private:
    /// Coordinates before they have letters: a class's turn, an edge's slide or direction, what is loose of it.
    int key_of_class(int index) const { return index; }
    int key_of_edge(int edge, int which) const { return static_cast<int>(graph_.classes.size()) + 2 * edge + which; }
    void add_turn_keys(std::set<int>& keys, BodyIndex body) const;
    std::set<int> keys_of(const ClosedWalk& cycle);
    std::set<int> keys_of(const Rolling& rolling) const;
    /// What rolls on what is known is known.
    void roll_on(std::set<int>& known) const;
    /// From the frame, or else a body that is known; the way out leads to what is known, or comes first in the file.
    ClosedWalk begun(const ClosedWalk& cycle, const std::set<int>& known) const;
    /// Where the slides of a loop end on their bodies: at the other joint there; between two slides where their lines
    /// cross.
    void set_ends(const ClosedWalk& cycle);
    void write_loop(const ClosedWalk& cycle);
    void pass(Edge& edge, bool forth, std::vector<Side>& left, std::vector<Side>& right);

    const AsDrawn& drawn_;
    VectorGraph& graph_;
    Letters& letters_;
    Equations& found_;
};

}  // namespace kinegraph::vector_loops
