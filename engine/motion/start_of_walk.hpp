// Where a walk starts: as drawn, along the one way in which the drivers lead; out of a change point along one of the
// branches that the second order allows.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/motion/branch_walk.hpp"
#include "engine/motion/branches.hpp"

namespace kinegraph::closing {

/// Where a change point is drawn: the branch that was taken, by its index in the results, and how many there are.
struct BranchTaken {
    std::size_t index = 0, of = 0;
};

class StartOfWalk {
public:
    explicit StartOfWalk(BranchWalk& walk) : walk_(walk), closure_(walk.closure()), drawn_(closure_.drawn()) {}

    /// The drivers (so many) lead from the drawn pose somewhere, in one way only. Bodies that nothing determines rest:
    /// their columns are frozen.
    bool start_as_drawn(std::size_t drivers);
    /// Of the branches that the second order allows, one that a step along it confirms: the one asked for, else the one
    /// on which the bodies move least. None: there is none.
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
