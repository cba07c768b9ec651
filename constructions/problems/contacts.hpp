// Contacts at joints of a solved mechanism: the force found presses the bodies together, their profiles or the
// involutes of their teeth have their radii there, and Hertz's theory says the rest (constructions/problems/hertz.hpp).
// Knows no file and no sheet.
#pragma once

#include "engine/solution/problem_solution.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {

/// Enters Solution::problem where joints of the mechanism have materials; the solution's forces and their check are in
/// it already. The load Q is the part of the joint's force along the common normal (of teeth the force itself, which
/// lies along the line of action); radii are those of the profiles, of teeth at the pitch point r sin α. Of two
/// profiles that lie on one side of the contact the larger is concave. The check takes its own force, and its own
/// quadrature. What presses nothing (no force found, none there, a pull) or has no face of contact (equal radii) is a
/// remark.
void find_contacts(Solution& solution);

}  // namespace kinegraph
