// Cycles of points, by their strongly connected components.
#include "engine/point_cycles.hpp"

#include <algorithm>
#include <utility>

namespace kinegraph {

std::vector<std::vector<PointIndex>> cycles(const Dependencies& graph) {
    const std::size_t count = graph.first.size() - 1;
    constexpr int unseen = -1;
    std::vector<int> number(count, unseen), low(count, 0), component(count, unseen);
    std::vector<PointIndex> open;
    std::vector<std::pair<PointIndex, std::size_t>> path;
    int next_number = 0;
    int components = 0;
    std::vector<int> sizes;
    const auto at = [](PointIndex point) { return static_cast<std::size_t>(point); };
    for (std::size_t start = 0; start < count; ++start) {
        if (number[start] != unseen) continue;
        path.emplace_back(static_cast<PointIndex>(start), 0);
        while (!path.empty()) {
            auto& [point, edge] = path.back();
            if (edge == 0) {
                number[at(point)] = low[at(point)] = next_number++;
                open.push_back(point);
            }
            const auto targets = graph.of(point);
            if (edge < targets.size()) {
                const PointIndex target = targets[edge++];
                if (number[at(target)] == unseen) {
                    path.emplace_back(target, 0);
                } else if (component[at(target)] == unseen) {
                    low[at(point)] = std::min(low[at(point)], number[at(target)]);
                }
                continue;
            }
            const PointIndex done = point;
            path.pop_back();
            if (!path.empty()) low[at(path.back().first)] = std::min(low[at(path.back().first)], low[at(done)]);
            if (low[at(done)] != number[at(done)]) continue;
            sizes.push_back(0);
            PointIndex member = -1;
            do {
                member = open.back();
                open.pop_back();
                component[at(member)] = components;
                ++sizes.back();
            } while (member != done);
            ++components;
        }
    }
    std::vector<std::vector<PointIndex>> found;
    std::vector<bool> told(static_cast<std::size_t>(components), false);
    std::vector<PointIndex> reached_from(count, -1);
    for (std::size_t start = 0; start < count; ++start) {
        const auto own = static_cast<std::size_t>(component[start]);
        const auto first = static_cast<PointIndex>(start);
        const auto targets = graph.of(first);
        const bool knotted = sizes[own] > 1 || std::find(targets.begin(), targets.end(), first) != targets.end();
        if (!knotted || told[own]) continue;
        told[own] = true;
        std::vector<PointIndex> queue{first};
        PointIndex last = -1;
        for (std::size_t i = 0; i < queue.size() && last < 0; ++i) {
            for (const PointIndex target : graph.of(queue[i])) {
                if (target == first) {
                    last = queue[i];
                    break;
                }
                if (component[at(target)] != component[start] || reached_from[at(target)] >= 0) continue;
                reached_from[at(target)] = queue[i];
                queue.push_back(target);
            }
        }
        std::vector<PointIndex> cycle;
        for (PointIndex point = last; point != first; point = reached_from[at(point)]) cycle.push_back(point);
        cycle.push_back(first);
        std::reverse(cycle.begin(), cycle.end());
        found.push_back(std::move(cycle));
    }
    return found;
}

}  // namespace kinegraph
