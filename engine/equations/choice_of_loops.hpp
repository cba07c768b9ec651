// Chooses which loops are written, in which order, from which body and in which sense. Greedy: the loop with the fewest
// unknowns comes next, so that the equations can be solved by hand.
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
    /// Coordinates before they have letters: the turn of a class, the slide or direction of an edge, the free
    /// coordinates of an edge.
    int key_of_class(int index) const { return index; }
    int key_of_edge(int edge, int which) const { return static_cast<int>(graph_.classes.size()) + 2 * edge + which; }
    void add_turn_keys(std::set<int>& keys, BodyIndex body) const;
    std::set<int> keys_of(const ClosedWalk& cycle);
    std::set<int> keys_of(const Rolling& rolling) const;
    /// Adds what a rolling contact determines from known coordinates.
    void roll_on(std::set<int>& known) const;
    /// The walk starts at the frame, or else at a known body. Its first side leads to a known body, or to the one that
    /// comes first in the file.
    ClosedWalk begun(const ClosedWalk& cycle, const std::set<int>& known) const;
    /// Sets where the slides of a loop end on their bodies: at the other joint there; between two slides at the
    /// intersection of their lines.
    void set_ends(const ClosedWalk& cycle);
    void write_loop(const ClosedWalk& cycle);
    void pass(Edge& edge, bool forth, std::vector<Side>& left, std::vector<Side>& right);

    const AsDrawn& drawn_;
    VectorGraph& graph_;
    Letters& letters_;
    Equations& found_;
};

}  // namespace kinegraph::vector_loops
