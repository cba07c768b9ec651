// The directions of joints, drivers, loads and given motions, computed once all points are placed. Also contacts, whose
// point is moved onto the profiles if its misfit is within rounding.
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
    /// The direction of a joint's bearing; empty, with a fault reported, where it has none. An irrational angle makes
    /// the pose inexact.
    std::optional<Vector> direction(const Bearing& bearing, const std::string& where);
    /// Checks that the profiles fit together, moves P onto them where it is off by less than 1e-9, and sets the
    /// directions.
    void read_contact(const Joint& joint, std::size_t index);
    bool claimed_twice(PointIndex point) const;
    /// Whether the misfit comes from the compass or from rounded data and is no fault of the file. A move too small for
    /// doubles counts as noise too.
    bool is_noise(double misfit) const;
    bool is_refused(double misfit) const;
    bool fits_radius(const Joint& joint, BodyIndex body, PointIndex centre);
    /// `centres`: one, the foot of whose perpendicular on the contact's line is `place`, or two, on whose line `place`
    /// lies.
    bool move(const Joint& joint, const Vector& place, const std::vector<PointIndex>& centres);

    Draft& draft_;
    const Mechanism& mechanism_;
};

}  // namespace kinegraph::drafting
