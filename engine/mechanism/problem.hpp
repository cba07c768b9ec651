// A problem that a file states in place of joints. Each kind of problem has a folder in problems/; what the rest knows
// of a kind is in engine/solution/problem_kind.hpp. Values in SI units, angles in radians.
#pragma once

#include <any>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

struct ProblemKind;

struct Problem {
    const ProblemKind* kind = nullptr;
    std::any of;  ///< the kind's own data, which it reads from a file

    /// Precondition: the problem is of the kind with these data.
    template <class Data>
    const Data& as() const {
        return std::any_cast<const Data&>(of);
    }
};

/// Whether a problem replaces the joints.
inline bool stands_for_joints(const Mechanism& mechanism) { return mechanism.problem != nullptr; }
/// The name of a body in sentences: its label, where the file gives one.
inline Words called(const Body& body) { return body.label.empty() ? Words(body.name) : body.label; }

}  // namespace kinegraph
