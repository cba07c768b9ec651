// The check of the forces: equilibrium of every body as one system of linear equations in doubles, with Eigen. Shares
// nothing with the constructions but Mechanism, Pose and the numeric motion (for inertia).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/check/check.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// Reactions and efforts from equilibrium; SI units.
struct NumericForces {
    /// The action of `from` on `on` at a joint, reduced to the joint's point. At a hinge of three bodies or more the
    /// pin acts on each: `from` is none then.
    struct Action {
        JointIndex joint = none;
        BodyIndex on = none, from = none;
        std::array<double, 2> force{};
        double couple = 0;
        bool known = false;  ///< determined by equilibrium
        /// Where the joint is not fully determined: whether the force, or the couple, has one value in every
        /// equilibrium; or, of the force, only its component along one direction, a unit vector (`component` N). An
        /// undetermined one is zero above.
        bool force_known = false, couple_known = false;
        std::optional<std::array<double, 2>> along;
        double component = 0;
    };
    std::vector<Action> actions;  ///< by joint, then by body of the joint; for two bodies both senses (3 on 2, 2 on 3)
    std::vector<double> efforts;  ///< by effort index: couple (N m), force (N)
    std::vector<bool> effort_known;
    int indeterminacy = 0;  ///< degree of static indeterminacy: number of unknowns left free by equilibrium
    bool balanced = true;   ///< false: no efforts and reactions can balance the loads (a free motion is unbalanced)
    /// The sum of all given loads on a body, reduced to the origin: N, N m.
    struct Sum {
        std::array<double, 2> force{};
        double couple = 0;
    };
    std::vector<Sum> given;  ///< by body; loads on the pin of a hinge are counted with the last of its bodies
    double residual = 0;     ///< largest unbalanced force relative to the largest load
};

/// Loads, weights, inertia (where the file requests it), springs; frictionless reactions by pair: revolute and rolling
/// two components through the point, prismatic a force ⟂ guide and a couple, pin-slot, contact and gear a force along
/// Pose::normals, weld force and couple.
NumericForces check_forces(const Mechanism& mechanism, const Pose& pose, const NumericMotion& motion);

}  // namespace kinegraph
