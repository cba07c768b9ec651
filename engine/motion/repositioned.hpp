// Repositioned: the mechanism as if drawn in another of its positions, in exact numbers. Code that reads a Mechanism
// and a Pose then solves that position like the drawn one.
#pragma once

#include "engine/motion/positions.hpp"

namespace kinegraph {

/// Points become coordinates; guides, profiles and pushes are rotated with their bodies. Loads and drivers are
/// unchanged.
struct Repositioned {
    Mechanism mechanism;
    Pose pose, finer;  ///< closed within 2^-bits, and with twice as many
};

/// Repositions a drawn mechanism repeatedly.
class Mover {
public:
    /// `pose` is the drawn one. Both are kept by reference.
    Mover(const Mechanism& mechanism, const Pose& pose);

    /// `coordinate`, the driver's, is that of `positions`. Precondition: `positions` is not singular. None where sizes
    /// are so far apart that the position closes in doubles and not as it is drawn.
    std::optional<Repositioned> moved(Positions& positions, const Exact& coordinate) const;
    /// The same where `positions` is singular. None where the driver stops beside it, too.
    std::optional<Repositioned> moved_across(const Positions& positions, const Exact& coordinate) const;

private:
    struct Drawn {
        Pose pose;
        Closure closure;
    };
    using PlacesOf = std::vector<BodyPlaceOf<Exact>>;
    std::optional<Repositioned> moved(const Positions& positions, const PlacesOf& places, const PlacesOf& finer) const;
    Mechanism mechanism_at(const Drawn& drawn, const std::vector<BodyPlaceOf<Exact>>& places) const;
    std::optional<Pose> pose_of(const Mechanism& moved, int bits) const;

    const Mechanism& mechanism_;
    Drawn drawn_, finer_;
    std::vector<Carrier> carriers_;
};

}  // namespace kinegraph
