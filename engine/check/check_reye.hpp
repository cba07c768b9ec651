// The numeric check of a contact that wears by Reye's hypothesis: the face cut into strips, each pressed as far as it
// wears and never pulled; equilibrium of the strips solved for the motion of the body that wears. No closed form.
#pragma once

#include <array>

#include "engine/mechanism/problem.hpp"

namespace kinegraph {

/// As in ReyeSolution.
struct ReyeCheck {
    double first = 0, second = 0, greatest = 0, resultant = 0, begin = 0, end = 0, friction = 0, torque = 0;
    double uniform_pressure = 0, uniform_torque = 0, normal = 0, pressure_radius = 0, locking = 0;
    std::array<double, 2> worn{};
};
ReyeCheck check_reye(const ReyeProblem& problem);

}  // namespace kinegraph
