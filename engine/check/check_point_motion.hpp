// The numeric checks of the motion of a point and of positions of a body. Of the point: the rules of differentiation
// carried along with the numbers (engine/file/expression.hpp, jets), so no derivative in symbols is used; the way by
// Simpson's rule. Of positions: complex numbers, a displacement being z′ = e^{iφ}z + c, and circles through three
// points by their equations.
#pragma once

#include <array>
#include <optional>

#include "engine/mechanism/problem.hpp"

namespace kinegraph {

struct PointCheck {
    VectorOf<double> place, velocity, acceleration;
    double way = 0, speed = 0, acceleration_length = 0;
    double along = 0, across = 0, radius = 0;  ///< no numbers where v or a_n vanishes
    VectorOf<double> centre;
    double r = 0, theta = 0;
    std::array<double, 2> polar_velocity{}, polar_acceleration{};
};
PointCheck check_point_motion(const PointProblem& problem);

struct DisplacementCheck {
    VectorOf<double> pole, way;
    double angle = 0;
};
DisplacementCheck check_displacement(const PositionsProblem& problem, std::size_t from, std::size_t to);
/// Of the point number `point` through the three positions: centre and radius.
std::pair<VectorOf<double>, double> check_pivot(const PositionsProblem& problem, std::size_t point);

}  // namespace kinegraph
