#include "engine/equations/loops.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>

#include "engine/number/index.hpp"

namespace kinegraph {
namespace {

using Bits = std::vector<bool>;

Bits bits_of(const ClosedWalk& cycle, std::size_t edges) {
    Bits bits(edges, false);
    for (const int edge : cycle.edges) bits[at_index(edge)] = true;
    return bits;
}
void add(Bits& to, const Bits& more) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = to[i] != more[i];
}

/// A spanning forest of the graph, with each node's path to its root.
struct Forest {
    std::vector<int> parent, edge, depth;

    Forest(int nodes, const GraphEdges& edges, int first)
        : parent(at_index(nodes), -1), edge(at_index(nodes), -1), depth(at_index(nodes), -1) {
        std::vector<std::vector<int>> touching(at_index(nodes));
        for (std::size_t e = 0; e < edges.size(); ++e)
            for (const int node : edges[e]) touching[at_index(node)].push_back(static_cast<int>(e));
        for (int k = 0; k < nodes; ++k) {
            const int root = (first + k) % nodes;
            if (depth[at_index(root)] >= 0) continue;
            depth[at_index(root)] = 0;
            std::vector<int> queue{root};
            for (std::size_t i = 0; i < queue.size(); ++i) {
                const int node = queue[i];
                for (const int each : touching[at_index(node)]) {
                    const int other =
                        edges[at_index(each)][0] == node ? edges[at_index(each)][1] : edges[at_index(each)][0];
                    if (depth[at_index(other)] >= 0) continue;
                    depth[at_index(other)] = depth[at_index(node)] + 1;
                    parent[at_index(other)] = node;
                    edge[at_index(other)] = each;
                    queue.push_back(other);
                }
            }
        }
    }
    /// The fundamental cycle of an edge outside the forest.
    Bits closed_by(int closing, const GraphEdges& edges) const {
        Bits bits(edges.size(), false);
        bits[at_index(closing)] = true;
        int a = edges[at_index(closing)][0], b = edges[at_index(closing)][1];
        while (a != b) {
            int& lower = depth[at_index(a)] >= depth[at_index(b)] ? a : b;
            bits[at_index(edge[at_index(lower)])] = true;
            lower = parent[at_index(lower)];
        }
        return bits;
    }
};

/// The simple cycle made of these edges, if they form one.
std::optional<ClosedWalk> walk_of(const Bits& bits, int nodes, const GraphEdges& edges) {
    std::vector<std::vector<int>> touching(at_index(nodes));
    std::size_t count = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (!bits[e]) continue;
        ++count;
        for (const int node : edges[e]) {
            touching[at_index(node)].push_back(static_cast<int>(e));
            if (touching[at_index(node)].size() > 2) return std::nullopt;
        }
    }
    if (count < 2) return std::nullopt;
    const auto first =
        std::find_if(touching.begin(), touching.end(), [](const auto& each) { return each.size() == 2; });
    if (first == touching.end()) return std::nullopt;
    ClosedWalk cycle;
    int node = static_cast<int>(first - touching.begin());
    int edge = first->front();
    do {
        cycle.nodes.push_back(node);
        cycle.edges.push_back(edge);
        node = edges[at_index(edge)][0] == node ? edges[at_index(edge)][1] : edges[at_index(edge)][0];
        const std::vector<int>& here = touching[at_index(node)];
        if (here.size() != 2) return std::nullopt;
        edge = here[0] == edge ? here[1] : here[0];
    } while (node != cycle.nodes.front());
    if (cycle.edges.size() != count) return std::nullopt;
    return cycle;
}

std::vector<int> closing_edges(const Forest& forest, const GraphEdges& edges) {
    std::vector<int> closing;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto own = static_cast<int>(e);
        if (forest.edge[at_index(edges[e][0])] != own && forest.edge[at_index(edges[e][1])] != own)
            closing.push_back(own);
    }
    return closing;
}

}  // namespace

bool ClosedWalk::has_node(int node) const { return std::find(nodes.begin(), nodes.end(), node) != nodes.end(); }

ClosedWalk ClosedWalk::from(int node) const {
    const auto begin = std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
    ClosedWalk turned = *this;
    std::rotate(turned.nodes.begin(), turned.nodes.begin() + begin, turned.nodes.end());
    std::rotate(turned.edges.begin(), turned.edges.begin() + begin, turned.edges.end());
    return turned;
}

ClosedWalk ClosedWalk::reversed() const {
    ClosedWalk back = *this;
    std::reverse(back.nodes.begin() + 1, back.nodes.end());
    std::reverse(back.edges.begin(), back.edges.end());
    return back;
}

std::vector<ClosedWalk> cycles_of(int nodes, const GraphEdges& edges) {
    constexpr std::size_t few = 10;
    std::set<Bits> known;
    std::vector<ClosedWalk> cycles;
    const auto offer = [&](const Bits& bits) {
        if (!known.insert(bits).second) return;
        if (auto walk = walk_of(bits, nodes, edges)) cycles.push_back(*std::move(walk));
    };
    const Forest from_frame(nodes, edges, 0);
    const std::vector<int> closing = closing_edges(from_frame, edges);
    if (closing.size() <= few) {
        std::vector<Bits> own;
        for (const int edge : closing) own.push_back(from_frame.closed_by(edge, edges));
        for (std::size_t sum = 1; sum < (std::size_t{1} << own.size()); ++sum) {
            Bits bits(edges.size(), false);
            for (std::size_t i = 0; i < own.size(); ++i)
                if ((sum >> i & 1U) != 0) add(bits, own[i]);
            offer(bits);
        }
        return cycles;
    }
    for (int root = 0; root < nodes; ++root) {
        const Forest forest(nodes, edges, root);
        for (const int edge : closing_edges(forest, edges)) offer(forest.closed_by(edge, edges));
    }
    return cycles;
}

std::vector<ClosedWalk> independent_cycles(int nodes, const GraphEdges& edges,
                                           const std::function<std::array<int, 4>(const ClosedWalk&)>& cost,
                                           const std::function<void(const ClosedWalk&)>& taken) {
    std::vector<ClosedWalk> candidates = cycles_of(nodes, edges), chosen;
    const std::size_t wanted = closing_edges(Forest(nodes, edges, 0), edges).size();
    std::vector<Bits> basis;  // in echelon form: each has a leading edge that no earlier one contains
    std::vector<std::size_t> leading;
    const auto reduced = [&](Bits bits) {
        for (std::size_t i = 0; i < basis.size(); ++i)
            if (bits[leading[i]]) add(bits, basis[i]);
        return bits;
    };
    while (chosen.size() < wanted && !candidates.empty()) {
        std::size_t best = 0;
        std::array<int, 4> least = cost(candidates.front());
        for (std::size_t i = 1; i < candidates.size(); ++i)
            if (const std::array<int, 4> own = cost(candidates[i]); own < least) best = i, least = own;
        ClosedWalk cycle = std::move(candidates[best]);
        candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(best));
        Bits left = reduced(bits_of(cycle, edges.size()));
        const auto lead = std::find(left.begin(), left.end(), true);
        if (lead == left.end()) continue;
        leading.push_back(static_cast<std::size_t>(lead - left.begin()));
        basis.push_back(std::move(left));
        taken(cycle);
        chosen.push_back(std::move(cycle));
    }
    return chosen;
}

}  // namespace kinegraph
