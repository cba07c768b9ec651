// Loops: the cycles of a graph of bodies and pairs. Contains only indices of nodes and edges; the caller supplies the
// cost of a cycle.
#pragma once

#include <array>
#include <compare>
#include <functional>
#include <vector>

namespace kinegraph {

/// A simple cycle: nodes[k] —edges[k]— nodes[k+1], the last edge leading back to nodes[0].
struct ClosedWalk {
    std::vector<int> nodes, edges;

    bool has_node(int node) const;
    /// The same cycle started at another of its nodes.
    ClosedWalk from(int node) const;
    ClosedWalk reversed() const;
};

using GraphEdges = std::vector<std::array<int, 2>>;

/// Candidate cycles for a basis: all of them where the graph has few independent ones, else the shortest through every
/// node and edge (Horton), which contain a minimum cycle basis.
std::vector<ClosedWalk> cycles_of(int nodes, const GraphEdges& edges);

/// A cycle basis (number of edges − nodes + connected components), chosen greedily: each cycle is the cheapest that is
/// independent of the earlier ones. `taken` is called with each before the next is chosen.
std::vector<ClosedWalk> independent_cycles(int nodes, const GraphEdges& edges,
                                           const std::function<std::array<int, 4>(const ClosedWalk&)>& cost,
                                           const std::function<void(const ClosedWalk&)>& taken);

}  // namespace kinegraph
