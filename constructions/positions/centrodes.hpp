// Centrodes: the paths of the pole of one body's motion against another's, on the one and on the other, traced by
// replaying the velocities along the travel of a driver, in steps as fine as their curvature asks. The moving one rolls
// on the fixed one, which it touches in the pole (Euler, Chasles). Knows no file and no figure.
#pragma once

#include <optional>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/file/error.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/sentences/column.hpp"

namespace kinegraph {

struct Centrodes {
    using Spot = VectorOf<double>;
    /// A piece without gaps; the three lists go together.
    struct Branch {
        std::vector<double> coordinates;  ///< of the driver, ascending
        std::vector<Spot> fixed, moving;  ///< m: on the first body and on the second, each as drawn
        bool comes_from_infinity = false, goes_to_infinity = false;
    };
    BodyIndex first = frame, second = none;
    std::vector<Branch> branches;
    std::vector<double>
        infinities;  ///< coordinates at which the pole is at infinity (the two do not turn against each other)

    /// Beyond this many sizes of the drawing a branch is cut, where it goes to infinity.
    static constexpr double cut_at = 25;
};

/// Of `second` against `first` over the travel of a driver (index), the other drivers at rest. Without branches: the
/// two never turn against each other, or their velocities are not determined. Errors: those of Positions::of.
Result<Centrodes> trace_centrodes(const Mechanism& mechanism, const Pose& pose, int driver, const Travel& travel,
                                  BodyIndex first, BodyIndex second);

}  // namespace kinegraph
