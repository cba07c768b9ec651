// The rows of a cycle beside the numeric check: its mechanism and its pose go along from position to position.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "constructions/verdicts/largest_difference.hpp"
#include "engine/check/check.hpp"
#include "engine/check/check_forces.hpp"
#include "engine/motion/moved.hpp"
#include "engine/motion/positions.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Along X of a slide, or the common tangent of a contact or a curved slot.
VectorOf<double> direction_of_sliding(const Places& places, JointIndex joint);

class RowCheck {
public:
    /// A row with the position that it is found in.
    struct Row {
        const std::vector<Column>& columns;
        const std::vector<double>& values;
        const Places& places;
        const Positions& positions;
        bool has_forces = false;
    };

    /// Of the mechanism as the file has it, which is kept by reference.
    explicit RowCheck(const Mechanism& drawn) : drawn_(drawn) {}

    /// The mechanism and pose of one position; those of others are put in their place.
    void begin(const Mechanism& mechanism, const Pose& pose) {
        mechanism_ = mechanism;
        pose_ = pose;
    }
    /// Which the driver's rates are put into before a row is compared.
    Mechanism& mechanism() { return mechanism_; }
    void compare(const Row& row);

    const LargestDifference& largest() const { return off_; }

private:
    void put_into_pose(const Row& row);
    /// What the check says to a column; nothing where it leaves it open.
    std::optional<double> numeric(const Row& row, const Column& column, const NumericMotion& motion,
                                  const NumericForces* forces) const;
    std::optional<double> numeric_sliding(const Row& row, const Quantity& q, const NumericMotion& motion) const;

    const Mechanism& drawn_;
    Mechanism mechanism_;
    Pose pose_;
    LargestDifference off_;
};

}  // namespace kinegraph
