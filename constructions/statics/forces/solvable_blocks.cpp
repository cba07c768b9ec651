#include "constructions/statics/forces/solvable_blocks.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace kinegraph::statics {
namespace {

constexpr std::size_t unmatched = static_cast<std::size_t>(-1);

/// A largest matching of unknowns and equations, by augmenting paths (breadth first, so that no recursion is deep).
class Matching {
public:
    Matching(const std::vector<std::vector<std::size_t>>& unknowns_in, std::size_t unknowns)
        : unknowns_in_(unknowns_in), equation_of(unknowns, unmatched), unknown_of(unknowns_in.size(), unmatched) {
        for (std::size_t e = 0; e < unknowns_in_.size(); ++e) augment(e);
    }

private:
    void augment(std::size_t start) {
        std::map<std::size_t, std::size_t> reached_from;  // unknown → equation
        std::vector<std::size_t> queue{start};
        for (std::size_t next = 0; next < queue.size(); ++next)
            for (std::size_t u : unknowns_in_[queue[next]]) {
                if (!reached_from.emplace(u, queue[next]).second) continue;
                if (equation_of[u] != unmatched) {
                    queue.push_back(equation_of[u]);
                    continue;
                }
                while (u != unmatched) {
                    const std::size_t e = reached_from.at(u), previous = unknown_of[e];
                    equation_of[u] = e;
                    unknown_of[e] = u;
                    u = previous;
                }
                return;
            }
    }

    const std::vector<std::vector<std::size_t>>& unknowns_in_;

public:
    std::vector<std::size_t> equation_of, unknown_of;
};

}  // namespace

std::vector<SolvableBlock> solvable_blocks(const std::vector<std::vector<std::size_t>>& unknowns_in,
                                           const std::vector<std::size_t>& owner, std::size_t unknowns) {
    const Matching matching(unknowns_in, unknowns);
    std::map<std::size_t, std::vector<std::size_t>> equations_of;
    for (std::size_t e = 0; e < owner.size(); ++e) equations_of[owner[e]].push_back(e);
    // What an owner's equations need: the owners of the equations that its unknowns are matched to, and so on. An owner
    // with an unmatched equation has more equations than unknowns; an unknown without an equation is not determined.
    std::vector<std::pair<std::set<std::size_t>, SolvableBlock>> found;
    for (const auto& [first, own] : equations_of) {
        std::set<std::size_t> owners{first}, contained;
        std::vector<std::size_t> queue{first};
        bool solvable = true;
        for (std::size_t next = 0; next < queue.size() && solvable; ++next)
            for (const std::size_t e : equations_of.at(queue[next])) {
                solvable = solvable && matching.unknown_of[e] != unmatched;
                for (const std::size_t u : unknowns_in[e]) {
                    contained.insert(u);
                    if (matching.equation_of[u] == unmatched) {
                        solvable = false;
                    } else if (owners.insert(owner[matching.equation_of[u]]).second) {
                        queue.push_back(owner[matching.equation_of[u]]);
                    }
                }
            }
        if (!solvable) continue;
        SolvableBlock block;
        block.unknowns.assign(contained.begin(), contained.end());
        for (const std::size_t each : owners)
            block.equations.insert(block.equations.end(), equations_of.at(each).begin(), equations_of.at(each).end());
        found.emplace_back(std::move(owners), std::move(block));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first.size() < b.first.size(); });
    std::set<std::size_t> used;
    std::vector<SolvableBlock> smallest;
    for (auto& [owners, block] : found) {
        const bool contains_smaller =
            std::any_of(owners.begin(), owners.end(), [&](std::size_t each) { return used.count(each) > 0; });
        if (contains_smaller) continue;
        used.insert(owners.begin(), owners.end());
        smallest.push_back(std::move(block));
    }
    return smallest;
}

}  // namespace kinegraph::statics
