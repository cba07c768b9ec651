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
        /// Of what is not: the force, or the couple, is the same in every equilibrium; or of the force its component
        /// along one direction, a unit vector (`component` N). Where one is not, its value above is zero.
        bool force_known = false, couple_known = false;
        std::optional<std::array<double, 2>> along;
        double component = 0;
    };
    std::vector<Action> actions;  ///< by joint, then by body of the joint; for two bodies both senses (3 on 2, 2 on 3)
    std::vector<double> efforts;  ///< by effort index: couple (N m), force (N)
    std::vector<bool> effort_known;
    int indeterminacy = 0;  ///< unknowns left free by equilibrium: statically indeterminate by so many
    bool balanced = true;   ///< false: no effort or reaction can hold the loads (a free motion is not balanced)
    /// All that is given on a body, reduced to the origin: N, N m.
    struct Sum {
        std::array<double, 2> force{};
        double couple = 0;
    };
    std::vector<Sum> given;  ///< by body; what acts on the pin of a hinge counts with the last of its bodies
    double residual = 0;     ///< largest unbalanced force relative to the largest load
};

/// Loads, weights, inertia (where the file says so), springs; frictionless reactions by pair: revolute and rolling two
/// components through the point, prismatic a force ⟂ guide and a couple, pin-slot, contact and gear a force along
/// Pose::normals, weld force and couple.
NumericForces check_forces(const Mechanism& mechanism, const Pose& pose, const NumericMotion& motion);

}  // namespace kinegraph
