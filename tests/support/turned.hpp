// A mechanism as another program would write it: the whole drawing turned, every point a decimal of `digits` digits.
#pragma once

#include "engine/drawing/pose.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::tests {

/// The angle, rad. No drawing made by hand has it, so no coordinate stays a short decimal.
inline constexpr double turn = 0.3;

/// All points as coordinates of `digits` significant digits in the file's unit; directions and vectors have as many.
/// Constructed points become given ones. `precision` as the file would state it.
Mechanism turned(const Mechanism& mechanism, const Pose& pose, int digits);
/// Half a unit of the last digit of the largest coordinate, m.
Exact precision_of(const Mechanism& turned, int digits);

/// Both solutions have the same verdicts and the same unsolved results; values, turned back, agree within `tolerance`
/// of the largest of their kind. Unless `amplified`, the sentences and centres agree too. Random mechanisms amplify the
/// rounding of their data: with `amplified` a value may differ by four times the effect of the data's precision, and a
/// centre may come from other lines.
void expect_same_but_turned(const Solution& as_given, const Solution& turned, double tolerance, bool amplified = false);

/// The largest angular velocity, or velocity divided by the size of the drawing, relative to those of the drivers.
double excess_over_drivers(const Solution& solution);

}  // namespace kinegraph::tests
