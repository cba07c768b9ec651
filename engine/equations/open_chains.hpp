// Open chains: their ends as sums of vectors, and the motion of every body, propagated from pair to pair.
#pragma once

#include <vector>

#include "engine/equations/letters.hpp"

namespace kinegraph::vector_loops {

class OpenChains {
public:
    OpenChains(const AsDrawn& drawn, VectorGraph& graph, Letters& letters, Equations& found)
        : drawn_(drawn), graph_(graph), letters_(letters), found_(found) {}

    /// The ends of open chains: bodies on no loop that carry no further body, with their farthest point.
    void write_reaches();
    void find_motions();

private:
    /// By body: the edge through which it is reached from the frame.
    std::vector<int> reached_by() const;
    void write_reach(BodyIndex body, PointIndex tip, const std::vector<int>& by);
    void turn_of_body(BodyIndex body);
    void carry_over(Edge& edge, BodyIndex from, BodyIndex to);

    const AsDrawn& drawn_;
    VectorGraph& graph_;
    Letters& letters_;
    Equations& found_;
};

}  // namespace kinegraph::vector_loops
