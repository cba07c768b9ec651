// Sliding at a joint: its positive direction and the name of its vector. Contains no values.
#pragma once

#include <optional>
#include <string>

#include "engine/drawing/pose.hpp"
#include "engine/sentences/quantity.hpp"

namespace kinegraph {

struct Solution;

/// X of a slide, or the common tangent of a contact or a curved slot, as a unit vector: relative velocities are
/// measured along it.
VectorOf<double> direction_of_sliding(const VectorOf<double>& guide, const VectorOf<double>& tangent,
                                      const VectorOf<double>& normal);
VectorOf<double> direction_of_sliding(const Pose& pose, JointIndex joint);

/// Name of a relative quantity's subscript: of X relative to A → "XA", with a comma where names would run together.
std::string relative_name(const std::string& of, const std::string& to);

/// Whether a vector of motion is the velocity of the joint's first body relative to its second, or (`second_order`) the
/// relative acceleration; where the second body is the frame, that of the point.
bool is_of_sliding(const Quantity& vector, JointIndex joint, bool second_order, const Mechanism& mechanism);

/// Its symbol in a solution: v_AA*, a_AA*^rel; v_B where the second body is the frame. Empty where the solution draws
/// no such vector.
std::optional<Symbol> symbol_of_sliding(const Solution& solution, JointIndex joint, bool second_order);
/// The same, or the joint's own name where the solution draws none: v_cyl; v_D^rel, where that is also the name of a
/// point.
Symbol name_of_sliding(const Solution& solution, JointIndex joint, bool second_order);
/// Which of several drivers of one point it is, from 1; empty for the only one.
std::string number_of_drive(const PointDriver& driver, const Mechanism& mechanism);
/// The given component of a point driver along its line, v_P∥; v_P∥2 where it is the second of that point.
Symbol along_drive(Symbol::Letter letter, const PointDriver& driver, const Mechanism& mechanism);

}  // namespace kinegraph
