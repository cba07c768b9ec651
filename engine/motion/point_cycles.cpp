#include "engine/motion/point_cycles.hpp"

#include <algorithm>
#include <utility>

#include "engine/number/index.hpp"

namespace kinegraph {
namespace {

/// Strongly connected components, by Tarjan's search with an explicit stack: files may be deep.
class Components {
public:
    explicit Components(const Dependencies& graph)
        : graph_(graph), number_(count(), unseen), low_(count(), 0), of_(count(), unseen) {
        for (std::size_t start = 0; start < count(); ++start)
            if (number_[start] == unseen) search(PointIndex(start));
    }

    std::size_t of(PointIndex point) const { return at_index(of_[at_index(point)]); }
    int size(std::size_t component) const { return sizes_[component]; }
    std::size_t number() const { return sizes_.size(); }

private:
    static constexpr int unseen = -1;
    std::size_t count() const { return graph_.first.size() - 1; }

    void search(PointIndex start) {
        std::vector<std::pair<PointIndex, std::size_t>> path{{start, 0}};
        while (!path.empty()) {
            auto& [point, edge] = path.back();
            if (edge == 0) {
                number_[at_index(point)] = low_[at_index(point)] = next_number_++;
                open_.push_back(point);
            }
            const auto targets = graph_.of(point);
            if (edge < targets.size()) {
                const PointIndex target = targets[edge++];
                if (number_[at_index(target)] == unseen)
                    path.emplace_back(target, 0);
                else if (of_[at_index(target)] == unseen)
                    low_[at_index(point)] = std::min(low_[at_index(point)], number_[at_index(target)]);
                continue;
            }
            const PointIndex done = point;
            path.pop_back();
            if (!path.empty()) {
                int& low = low_[at_index(path.back().first)];
                low = std::min(low, low_[at_index(done)]);
            }
            if (low_[at_index(done)] == number_[at_index(done)]) close(done);
        }
    }
    /// Everything opened since its first member forms a component.
    void close(PointIndex first) {
        const auto component = static_cast<int>(sizes_.size());
        sizes_.push_back(0);
        PointIndex member = none;
        do {
            member = open_.back();
            open_.pop_back();
            of_[at_index(member)] = component;
            ++sizes_.back();
        } while (member != first);
    }

    const Dependencies& graph_;
    std::vector<int> number_, low_, of_, sizes_;
    std::vector<PointIndex> open_;
    int next_number_ = 0;
};

/// A shortest cycle through a point, within its component.
std::vector<PointIndex> shortest_cycle(const Dependencies& graph, const Components& components, PointIndex first,
                                       std::vector<PointIndex>& reached_from) {
    std::vector<PointIndex> queue{first};
    PointIndex last = none;
    for (std::size_t i = 0; i < queue.size() && last == none; ++i) {
        for (const PointIndex target : graph.of(queue[i])) {
            if (target == first) {
                last = queue[i];
                break;
            }
            if (components.of(target) != components.of(first) || reached_from[at_index(target)] != none) continue;
            reached_from[at_index(target)] = queue[i];
            queue.push_back(target);
        }
    }
    std::vector<PointIndex> cycle;
    for (PointIndex point = last; point != first; point = reached_from[at_index(point)]) cycle.push_back(point);
    cycle.push_back(first);
    std::reverse(cycle.begin(), cycle.end());
    return cycle;
}

}  // namespace

std::vector<std::vector<PointIndex>> cycles(const Dependencies& graph) {
    const Components components(graph);
    std::vector<std::vector<PointIndex>> found;
    std::vector<bool> told(components.number(), false);
    std::vector<PointIndex> reached_from(graph.first.size() - 1, none);
    for (const PointIndex first : indices<PointIndex>(reached_from.size())) {
        const std::size_t own = components.of(first);
        const auto targets = graph.of(first);
        const bool knotted =
            components.size(own) > 1 || std::find(targets.begin(), targets.end(), first) != targets.end();
        if (!knotted || told[own]) continue;
        told[own] = true;
        found.push_back(shortest_cycle(graph, components, first, reached_from));
    }
    return found;
}

}  // namespace kinegraph
