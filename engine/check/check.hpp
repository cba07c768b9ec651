// The check: the velocities and accelerations of the same mechanism by plain linear algebra in doubles (Jacobian and
// its time derivative), with Eigen. It shares only Mechanism and Pose with the constructions, so that agreement is
// evidence. Only this check and that of the forces include Eigen.
#pragma once

#include <array>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// Planar motion of every body at this instant; SI units.
struct NumericMotion {
    struct BodyState {
        std::array<double, 2> reference{};     ///< a place of the body, m
        std::array<double, 2> velocity{};      ///< of that place
        std::array<double, 2> acceleration{};  ///< of that place
        double omega = 0, alpha = 0;
        bool velocity_known = false;  ///< determined by the drivers (not in the null space)
        bool acceleration_known = false;
    };
    std::vector<BodyState> bodies;  ///< by BodyIndex; the frame at rest

    /// From the body's reference to a place, m.
    std::array<double, 2> arm(BodyIndex body, const Vector& place) const;
    std::array<double, 2> velocity_at_arm(BodyIndex body, const std::array<double, 2>& arm) const;
    std::array<double, 2> acceleration_at_arm(BodyIndex body, const std::array<double, 2>& arm) const;
    std::array<double, 2> velocity(BodyIndex body, const Vector& place) const {
        return velocity_at_arm(body, arm(body, place));
    }
    std::array<double, 2> acceleration(BodyIndex body, const Vector& place) const {
        return acceleration_at_arm(body, arm(body, place));
    }
};

/// Velocities from J q̇ = b, accelerations from J q̈ = ḃ − J̇ q̇. A body whose motion the drivers do not determine is
/// marked as unknown. Lengths are scaled by the drawing's size. LU is used where the equations are square and regular,
/// otherwise rank-revealing QR. One step of refinement with residuals in twice the digits keeps the error near 1e-13 of
/// the largest velocity unless the mechanism is close to a dead point. If drivers contradict each other or the pose,
/// every body is unknown.
NumericMotion check_motion(const Mechanism& mechanism, const Pose& pose);

}  // namespace kinegraph
