// Solution: all results as values in SI units, with the protocol that produced them and the numbers of the check. Input
// of the results file, the tables and the drawing. Computes nothing.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/board/protocol.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/branches.hpp"
#include "engine/motion/mobility.hpp"
#include "engine/solution/curvature.hpp"
#include "engine/solution/findings.hpp"
#include "engine/solution/forces.hpp"
#include "engine/solution/motion.hpp"

namespace kinegraph {

/// Results of a problem in place of joints, and of the contacts at joints (engine/solution/problem_solution.hpp).
struct ProblemSolution;
struct SolvedContacts;
/// The closure equations (engine/equations/equations.hpp).
struct Equations;
/// Virtual displacements and their work (engine/solution/displacements.hpp).
struct Displacements;

struct Solution : SolvedMotion, SolvedForces, Findings {
    Mechanism mechanism;
    Pose pose;
    Mobility mobility;
    std::optional<InstantMotion> instant_motion;  ///< where constraints are redundant or a driver drives nothing
    Protocol protocol;
    /// Numbers of strokes when these results were found. A program cut to them must keep the earlier verdicts.
    struct Settled {
        int velocities = 0, accelerations = 0, forces = 0;
    } settled;
    std::vector<Curvature> curvature;                    ///< if requested: of the moving bodies in the file's order
    std::shared_ptr<const ProblemSolution> problem;      ///< if the file states one: then it is the whole solution
    std::shared_ptr<const SolvedContacts> contacts;      ///< if joints have materials
    std::shared_ptr<const Equations> equations;          ///< if requested
    std::shared_ptr<const Displacements> displacements;  ///< if requested

    // Defined in one source file: inlining them in every user would cost seconds of compile time.
    Solution();
    Solution(const Solution&);
    Solution(Solution&&) noexcept;
    Solution& operator=(const Solution&);
    Solution& operator=(Solution&&) noexcept;
    ~Solution();
};

/// Reads the value of every element in the results from the values of a record: of the drawn pose, or of a replay.
void read_values(Solution& solution, const std::vector<Value>& values);

}  // namespace kinegraph
