// Moved: the mechanism as if it had been drawn in another of its positions, in exact numbers. Everything that reads a
// Mechanism and a Pose then solves that position as it solves the drawn one.
#pragma once

#include "engine/motion/positions.hpp"

namespace kinegraph {

/// Points are given by coordinates; guides, profiles and pushes are turned with their bodies. Loads and drivers stay
/// the file's.
struct Moved {
    Mechanism mechanism;
    Pose pose, finer;  ///< closed within 2^-bits, and with twice as many
};

/// Moves a drawn mechanism again and again to where its positions are.
class Mover {
public:
    /// `pose` is the drawn one. Both are kept by reference.
    Mover(const Mechanism& mechanism, const Pose& pose);

    /// `coordinate`, of the driver, is that of `positions`, which are not singular.
    Moved moved(Positions& positions, const Exact& coordinate) const;

private:
    struct Drawn {
        Pose pose;
        Closure closure;
    };
    Mechanism mechanism_at(const Drawn& drawn, const std::vector<BodyPlaceOf<Exact>>& places) const;
    Pose pose_of(const Mechanism& moved, int bits) const;

    const Mechanism& mechanism_;
    Drawn drawn_, finer_;
    std::vector<Carrier> carriers_;
};

}  // namespace kinegraph
