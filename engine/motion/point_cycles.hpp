// Cycles of points: points that are placed by each other, so that none can be placed. Uses the dependencies only.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// The dependencies of each point: of point i, `targets[first[i]]` up to `targets[first[i + 1]]`.
struct Dependencies {
    std::vector<std::size_t> first;
    std::vector<PointIndex> targets;
    std::span<const PointIndex> of(PointIndex point) const {
        const auto i = at_index(point);
        return std::span(targets).subspan(first[i], first[i + 1] - first[i]);
    }
};

/// One shortest cycle through the first point of each strongly connected component (Tarjan, with an explicit stack, so
/// that long chains do not overflow the call stack).
std::vector<std::vector<PointIndex>> cycles(const Dependencies& graph);

}  // namespace kinegraph
