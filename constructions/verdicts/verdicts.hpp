// What is said of a finished solution: ill-conditioning, noise, likely mistakes, worked arithmetic.
#pragma once

#include <vector>

#include "engine/equations/equations.hpp"
#include "engine/motion/mobility.hpp"
#include "engine/sentences/statement.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

// ----- Hairs: where nothing is degenerate, but a result hangs on a small difference of the data: which coincidence is
// nearly one, and what moving a point a little does. Changes nothing; a remark each.

/// Of the finished solution. A coincidence counts as nearly one where it is missed by less than a thousandth of what it
/// stands beside; a result hangs on a hair where a move of a given point by 1e-4 of the size changes it by a tenth and
/// more.
std::vector<Message> remarks_on_hairs(const Solution& solution);

// ----- Noise: what is zero within the precision of the data, or but for what the compass left over, is zero in
// everything that is told and drawn of a solution and of its equations. The record keeps its numbers. Decides by
// engine/mechanism/rounding.hpp and by a finer pose, as the board's predicates do; knows no mechanics.

/// Sets results that are zero within the data to zero, component by component, and marks drawn vectors that vanish.
/// Nothing where the data are exact. `finer`: the pose with twice its bits, asked for only where a result is
/// suspiciously small.
void forget_noise(Solution& solution, const FinerPose& finer);
/// The same of the values of its equations.
void forget_noise(Equations& equations, const Solution& solution, const FinerPose& finer);

// ----- Oversights: what the author of a file probably forgot, read off its structure where more is free than is driven
// or held. Knows no way of solving; a mechanism that is determined has none.

/// Points that two bodies share without a joint, bodies without a joint or with one only, groups that nothing connects
/// with the frame: a sentence each, with the joint that is likely to be missing. A body that one of them names has no
/// second one.
std::vector<Message> oversights(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility);

// ----- Workings: the arithmetic of the sentences, once the record has its values: v_A = ω·r, ω_3 = v_BA/AB, a_cor =
// 2·ω·v_rel, F_i = m·a_G. Each is told with the numbers that the drawing gives; none is a source of a result.

/// Adds to every statement of the finished solution what it works out, in the file's units and rounded by no one yet,
/// and takes out of its sentence what vanishes: ω² of a body that translates, a Coriolis term of none. A product that
/// does not come out to the value found is left unsaid.
void add_workings(Solution& solution);

}  // namespace kinegraph
