// Loops: the closed walks of a graph of bodies and pairs. Knows numbers of nodes and edges alone; what a loop costs and
// what it teaches is told by who asks.
#pragma once

#include <array>
#include <compare>
#include <functional>
#include <vector>

namespace kinegraph {

/// A closed walk that meets no node twice: nodes[k] —edges[k]— nodes[k+1], the last edge leading back to nodes[0].
struct ClosedWalk {
    std::vector<int> nodes, edges;

    bool has_node(int node) const;
    /// The same walk begun at another of its nodes.
    ClosedWalk from(int node) const;
    ClosedWalk reversed() const;
};

using GraphEdges = std::vector<std::array<int, 2>>;

/// Walks enough to choose a basis from: all of them where the graph has few independent ones, else the shortest through
/// every node and edge (Horton), among which there is always a shortest basis.
std::vector<ClosedWalk> cycles_of(int nodes, const GraphEdges& edges);

/// As many independent walks as the graph has (its edges less its nodes, and one for each connected part), one after
/// the other: each the cheapest of those that are independent of the ones before; `taken` hears of it before the next
/// is chosen.
std::vector<ClosedWalk> independent_cycles(int nodes, const GraphEdges& edges,
                                           const std::function<std::array<int, 4>(const ClosedWalk&)>& cost,
                                           const std::function<void(const ClosedWalk&)>& taken);

}  // namespace kinegraph
