// Remarks on a finished solution: ill-conditioning, noise, likely mistakes; and its worked arithmetic.
#pragma once

#include <vector>

#include "engine/equations/equations.hpp"
#include "engine/motion/mobility.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

struct Solution;

// ----- Ill-conditioning: nothing is degenerate, but a result depends on a small difference of the data. Reports near
// coincidences and the effect of moving a point a little. Adds remarks only.

/// For the finished solution. A coincidence is near if the distance is less than a thousandth of the neighbouring
/// lengths. A result is ill-conditioned if moving a given point by 1e-4 of the size changes it by a tenth or more.
std::vector<Message> remarks_on_ill_conditioning(const Solution& solution);

// ----- Noise: a value that is zero within the precision of the data, or except for rounding of the drawing, is shown
// as zero in a solution and its equations. The record keeps its numbers. Decides by engine/mechanism/rounding.hpp and
// by a finer pose, as the board's predicates do.

/// Sets results that are zero within the precision of the data to zero, component by component, and marks drawn vectors
/// that vanish. Does nothing if the data are exact. `finer` gives the pose with twice the bits; it is evaluated only if
/// a result is suspiciously small.
void forget_noise(Solution& solution, const FinerPose& finer);
/// The same for the values of the equations.
void forget_noise(Equations& equations, const Solution& solution, const FinerPose& finer);

// ----- Likely mistakes: what the author of a file probably forgot, seen in the structure if it has more freedoms than
// drivers. A mechanism whose motion and input forces are determined gives no remark.

/// Points that two bodies share without a joint, bodies with one joint or none, groups without connection to the frame:
/// a sentence for each, with the joint that is probably missing. At most one remark for each body.
/// Where there are none and `counted`, drivers and input forces are compared with the freedoms, if the file gives any.
std::vector<Message> likely_mistakes(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility,
                                     bool counted = true);

// ----- Worked arithmetic of the sentences, once the record has its values: v_A = ω·r, ω_3 = v_BA/AB, a_cor =
// 2·ω·v_rel, F_i = m·a_G. Uses the numbers that the drawing gives; no result depends on it.

/// Adds the arithmetic to every statement of the finished solution, in the file's units and not rounded. Removes terms
/// that vanish from the sentences: ω² of a body that translates, a zero Coriolis term. Omits a product that does not
/// give the value found.
void add_worked_arithmetic(Solution& solution);

}  // namespace kinegraph
