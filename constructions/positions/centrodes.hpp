// Centrodes: the paths of the instant centre of one body's motion relative to another's, on both bodies. Traced by
// replaying the velocities along the travel of a driver, in steps adapted to the curvature. The moving centrode rolls
// on the fixed one, which it touches in the instant centre (Euler, Chasles).
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
    /// A piece without gaps; the three lists have the same length.
    struct Branch {
        std::vector<double> coordinates;  ///< of the driver, ascending
        std::vector<Spot> fixed, moving;  ///< m; on the first body and on the second, each as drawn
        bool comes_from_infinity = false, goes_to_infinity = false;
    };
    BodyIndex first = frame, second = none;
    std::vector<Branch> branches;
    std::vector<double> infinities;  ///< coordinates with the pole at infinity (no relative rotation)

    /// A branch that goes to infinity is cut at this multiple of the size of the drawing.
    static constexpr double cut_at = 25;
};

/// Of `second` relative to `first` over the travel of a driver (index), with the other drivers at rest. No branches:
/// the two never turn relative to each other, or their velocities are not determined. Errors: those of Positions::of.
Result<Centrodes> trace_centrodes(const Mechanism& mechanism, const Pose& pose, int driver, const Travel& travel,
                                  BodyIndex first, BodyIndex second);

}  // namespace kinegraph
