// Start of a walk: as drawn, where the drivers determine the motion uniquely; or out of a change point along one of the
// branches that the second order allows.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/motion/branch_walk.hpp"
#include "engine/motion/branches.hpp"

namespace kinegraph::closing {

/// For a change point: the chosen branch, by its index in the results, and the number of branches.
struct BranchTaken {
    std::size_t index = 0, of = 0;
};

class StartOfWalk {
public:
    explicit StartOfWalk(BranchWalk& walk) : walk_(walk), closure_(walk.closure()), drawn_(closure_.drawn()) {}

    /// Whether the first `drivers` drivers determine a unique motion from the drawn pose. Bodies that nothing
    /// determines stay at rest: their columns are frozen.
    bool start_as_drawn(std::size_t drivers);
    /// Of the branches that the second order allows, one that a step along it confirms: the requested one, else the
    /// first, on which the bodies move least. None if there is no such branch.
    std::optional<BranchTaken> start_at_change_point(const Mechanism& mechanism, const Pose& pose,
                                                     std::optional<std::size_t> asked);

private:
    std::optional<std::vector<double>> tangent_of(const Branch& branch);
    bool contradicts_rows(const std::vector<double>& tangent) const;
    bool start_along(const std::vector<double>& tangent);

    BranchWalk& walk_;
    NumericClosure& closure_;
    State drawn_;
};

}  // namespace kinegraph::closing
