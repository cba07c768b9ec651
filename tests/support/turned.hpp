// A mechanism as a program would write it: its whole drawing turned, every point a decimal of so many digits.
#pragma once

#include "engine/solution/solution.hpp"

namespace kinegraph::tests {

/// By how much, rad: no angle of a drawing made by hand, so that no decimal comes back exact.
inline constexpr double turn = 0.3;

/// All points as coordinates of `digits` significant digits in the file's unit, directions and vectors with as many;
/// what was constructed is so no longer. `precision` as the file would state it.
Mechanism turned(const Mechanism& mechanism, const Pose& pose, int digits);
/// Half of the last digit of the largest coordinate, m.
Exact precision_of(const Mechanism& turned, int digits);

/// Verdicts and what is unsolved are the same; values, turned back, agree within `tolerance` of the largest of their
/// kind. So do the sentences and the centres, but where `amplified`: mechanisms drawn at random amplify what is
/// rounded, so that four times what shifting the data within their precision does to a value is allowed for, and other
/// lines may give a centre.
void expect_same_but_turned(const Solution& as_given, const Solution& turned, double tolerance, bool amplified = false);

/// The largest angular velocity and velocity over the drawing's size, over those of the drivers.
double excess_over_drivers(const Solution& solution);

}  // namespace kinegraph::tests
