// Sliding at a joint: in which sense it counts positive, and how its vector is called. Knows no value of it.
#pragma once

#include <optional>
#include <string>

#include "engine/solution/solution.hpp"

namespace kinegraph {

/// X of a slide, or the common tangent of a contact or a curved slot, as a unit vector: along it relative velocities
/// are counted.
VectorOf<double> direction_of_sliding(const VectorOf<double>& guide, const VectorOf<double>& tangent,
                                      const VectorOf<double>& normal);
VectorOf<double> direction_of_sliding(const Pose& pose, JointIndex joint);

/// Name of a relative quantity's subscript: of X relative to A → "XA", with a comma where names would run together.
std::string relative_name(const std::string& of, const std::string& to);

/// Whether a vector of motion is the velocity of the joint's first body relative to its second, or (`second_order`) the
/// relative acceleration; where the second is the frame, that of the point.
bool is_of_sliding(const Quantity& vector, JointIndex joint, bool second_order, const Mechanism& mechanism);

/// What a solution calls that vector: v_AA*, a_AA*^rel; v_B where the second is the frame. Nothing where it draws no
/// such vector.
std::optional<Symbol> symbol_of_sliding(const Solution& solution, JointIndex joint, bool second_order);
/// The same, or the joint's own name where the solution draws none: v_cyl; v_D^rel, where that is the name of a point,
/// too.
Symbol name_of_sliding(const Solution& solution, JointIndex joint, bool second_order);
/// What a driver gives of a point: the component along its line, v_P∥, as solutions call it.
Symbol along_drive(Symbol::Letter letter, const PointDriver& driver, const Mechanism& mechanism);

}  // namespace kinegraph
