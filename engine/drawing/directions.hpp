// The directions of joints, drivers, loads and given motions, once all points have their places; and contacts, whose
// point is moved onto their profiles where it misses them by a hair.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/drawing/draft.hpp"

namespace kinegraph::drafting {

class Directions {
public:
    explicit Directions(Draft& draft) : draft_(draft), mechanism_(draft.mechanism) {}

    void read_joints();

private:
    /// The direction of a joint's bearing; nothing, and said, where it is none. An irrational angle makes the pose
    /// inexact.
    std::optional<Vector> direction(const Bearing& bearing, const std::string& where);
    /// Checks the profiles against each other, moves P onto them where it is off by less than 1e-9, and sets the
    /// directions.
    void read_contact(const Joint& joint, std::size_t index);
    bool claimed_twice(PointIndex point) const;
    /// Compass noise or the data's own rounding, no fault of the file. A move that no double shows is none either.
    bool is_noise(double misfit) const;
    bool is_refused(double misfit) const;
    bool fits_radius(const Joint& joint, BodyIndex body, PointIndex centre);
    /// `centres`: one, whose foot on the contact's line `place` is, or two, on whose line it lies.
    bool move(const Joint& joint, const Vector& place, const std::vector<PointIndex>& centres);

    Draft& draft_;
    const Mechanism& mechanism_;
};

}  // namespace kinegraph::drafting
