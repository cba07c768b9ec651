// Solving a mechanism: pose, mobility, instant centres, velocities, accelerations and relative motion by construction,
// and the numeric check beside them. The way through the house from Mechanism to Solution.
#pragma once

#include "engine/file/error.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Whether the sentences tell the arithmetic behind what they say (constructions/verdicts/workings.hpp), which takes a
/// tenth of the time. No result hangs on it.
enum class Arithmetic { told, left_out };

/// Errors: only those of the pose (curves that do not meet, misfits). What the mechanism cannot give is in
/// Solution::unsolved, with its reason.
Result<Solution> solve(Mechanism mechanism, Arithmetic arithmetic = Arithmetic::told);
/// The same in a pose that is not drawn from the file; `finer` gives it with twice the bits.
Solution solve(Mechanism mechanism, Pose pose, const FinerPose& finer, Arithmetic arithmetic = Arithmetic::told);

/// The velocities alone of a mechanism whose drivers move at the rate one or rest, and the powers of its loads and of
/// one unit of each effort in them: virtual displacements and works (Solution::virtual_work; none where the motion is
/// not found). In the place of `pose`, which may have been drawn with other drivers and loads; `finer` as of `solve`,
/// empty where the pose is the file's.
Result<Solution> solve_displaced(Mechanism mechanism, const Pose& pose, const FinerPose& finer);

}  // namespace kinegraph
