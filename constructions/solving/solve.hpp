// Solves a mechanism: pose, mobility, instant centres, velocities, accelerations and relative motion by construction,
// and the numeric check. The entry point from Mechanism to Solution.
#pragma once

#include "engine/file/error.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Whether the sentences include worked arithmetic (constructions/verdicts/verdicts.hpp), which takes a tenth of the
/// time. No result depends on it.
enum class Arithmetic { told, left_out };

/// Whether solving finds the instant centres: the file asks for them or for nothing in particular.
bool finds_centres(const Mechanism& mechanism);

/// Errors: only those of the pose (curves that do not meet, misfits). Results that the mechanism does not determine are
/// in Solution::unsolved, with the reason.
Result<Solution> solve(Mechanism mechanism, Arithmetic arithmetic = Arithmetic::told);
/// The same in a pose that is not drawn from the file; `finer` gives it with twice the bits.
Solution solve(Mechanism mechanism, Pose pose, const FinerPose& finer, Arithmetic arithmetic = Arithmetic::told);

/// Velocities only, with drivers at rate one or at rest, and the powers of the loads and of one unit of each input
/// force or couple: virtual displacements and works (Solution::virtual_work; none if the motion is not found). The
/// position is that of `pose`, which may have been drawn with other drivers and loads; `finer` as in `solve`, empty if
/// the pose is the file's.
Result<Solution> solve_displaced(Mechanism mechanism, const Pose& pose, const FinerPose& finer);

/// Finds the virtual displacements, and the input forces and couples for which the works vanish.
/// Uses the drivers of a solved mechanism if these determine its motion, else coordinates chosen in the file's order
/// (turns about hinges of the frame, slides on the frame, other turns, other slides, points). Adds the rows that
/// compare input forces with the check of forces, and remarks if displacements differ from the check of motion.
/// `finer`: its pose with twice the bits, if it is not drawn from the file.
void add_displacements(Solution& solution, const FinerPose& finer = {});

}  // namespace kinegraph
