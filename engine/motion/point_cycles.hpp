// Cycles of points: those that are placed by each other, so that none can be placed. Knows which points hang on which,
// not how.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// Which points each point is placed by: of point i, `targets[first[i]]` up to `targets[first[i + 1]]`.
struct Dependencies {
    std::vector<std::size_t> first;
    std::vector<PointIndex> targets;
    std::span<const PointIndex> of(PointIndex point) const {
        const auto i = at_index(point);
        return std::span(targets).subspan(first[i], first[i + 1] - first[i]);
    }
};

/// One shortest cycle through the first point of each knot of points that depend on each other (Tarjan's strongly
/// connected components, with a stack of our own so that no chain is too long).
std::vector<std::vector<PointIndex>> cycles(const Dependencies& graph);

}  // namespace kinegraph
