// The numeric check of an impact: Newton's laws for both bodies, integrated in small steps of the normal impulse with
// Coulomb's friction at each; compression until the points in contact no longer approach, then e times as much again.
// In doubles, body by body; shares no formula with the construction.
#pragma once

#include <array>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/problem.hpp"

namespace kinegraph {

struct ImpactCheck {
    std::array<double, 2> impulse{};  ///< on the first body, N s
    struct Body {
        std::array<double, 2> velocity{}, reaction{};
        double omega = 0;
    };
    std::array<Body, 2> bodies;
    double energy_lost = 0;
};
/// `normal` from the second body to the first; bodies that approach.
ImpactCheck check_impact(const ImpactProblem& problem, const Vector& at, const Vector& normal, const Pose& pose);

}  // namespace kinegraph
