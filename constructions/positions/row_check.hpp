// Compares the rows of a cycle with the numeric check. Moves the check's own mechanism and pose from position to
// position.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "constructions/verdicts/largest_difference.hpp"
#include "engine/check/check.hpp"
#include "engine/check/check_forces.hpp"
#include "engine/motion/positions.hpp"
#include "engine/motion/repositioned.hpp"

namespace kinegraph {

/// Along X of a slide, or the common tangent of a contact or a curved slot.
VectorOf<double> direction_of_sliding(const Places& places, JointIndex joint);

class RowCheck {
public:
    /// A row and its position.
    struct Row {
        const std::vector<Column>& columns;
        const std::vector<double>& values;
        const std::vector<double>& noise;  ///< by column: smaller values are compared as zero
        const std::vector<bool>& empty;    ///< by column: there is no value to compare
        const Places& places;
        const Positions& positions;
        bool has_forces = false;
    };

    /// `drawn`: the mechanism as in the file; keeps a reference.
    explicit RowCheck(const Mechanism& drawn) : drawn_(drawn) {}

    /// Sets the mechanism and pose; later positions modify them.
    void begin(const Mechanism& mechanism, const Pose& pose) {
        mechanism_ = mechanism;
        pose_ = pose;
    }
    /// To set the driver's rates before a row is compared.
    Mechanism& mechanism() { return mechanism_; }
    void compare(const Row& row);

    const LargestDifference& largest() const { return off_; }

private:
    void put_into_pose(const Row& row);
    /// The check's value for a column; none if it does not determine it.
    std::optional<std::array<double, 2>> numeric_on_request(const Quantity& q, const NumericMotion& motion) const;
    std::optional<double> numeric(const Row& row, const Column& column, const NumericMotion& motion,
                                  const NumericForces* forces) const;

    const Mechanism& drawn_;
    Mechanism mechanism_;
    Pose pose_;
    LargestDifference off_;
};

}  // namespace kinegraph
