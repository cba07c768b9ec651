// The check's value for a quantity of motion, under the same name as the construction's.
#pragma once

#include <array>
#include <optional>

#include "engine/check/check.hpp"
#include "engine/sentences/quantity.hpp"

namespace kinegraph {

/// SI units; of ω and α the first number. None where the drivers do not determine it. Sliding at a joint: of its first
/// body relative to the second, with its Coriolis term apart.
std::optional<std::array<double, 2>> numeric_result(const NumericMotion& motion, const Mechanism& mechanism,
                                                    const Pose& pose, const Quantity& quantity);

/// The radius of curvature of a path at the point `beside`, from v and a there; the diameter of the inflection circle
/// with the pole `beside`, |a|/ω²; or the pole of accelerations, from those of `beside`. None: nothing moves there.
std::optional<std::array<double, 2>> numeric_curvature(const NumericMotion& motion, const Quantity& quantity,
                                                       const Vector& beside);

/// The place, m, where the two bodies of an instant centre have the same velocity. None where the drivers do not
/// determine it, or where they hardly turn against each other.
std::optional<std::array<double, 2>> numeric_centre(const NumericMotion& motion, const Quantity& centre);

}  // namespace kinegraph
