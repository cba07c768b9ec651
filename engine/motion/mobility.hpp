// Mobility: Grübler's count as in textbooks, and the effective (instantaneous) mobility from the exact rank of the
// constraints at this pose; where they differ, which constraints are redundant. Computes no velocities.
#pragma once

#include <string>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

struct Mobility {
    int bodies = 0;     ///< m, the frame counted
    int class_1 = 0;    ///< pairs with one freedom (revolute counted with its multiplicity, prismatic, rolling)
    int class_2 = 0;    ///< pairs with two (pin-slot, contact, gear)
    int welds = 0;      ///< clamped joints, with none
    int gruebler = 0;   ///< 3(m−1) − 2c₁ − c₂ − 3w
    int effective = 0;  ///< 3(m−1) − rank at this pose
    struct Redundant {
        JointIndex joint = none;
        int rows = 0;
    };
    std::vector<Redundant>
        redundant;   ///< joints (in the file's order) whose constraints depend on earlier ones, and how many
    int driven = 0;  ///< rank that the drivers add; the motion is determined when driven == effective
    std::vector<int> idle_drivers;       ///< drivers (by index) whose coordinate is already determined
    std::vector<bool> determined;        ///< by BodyIndex: the body's velocity follows from the drivers (by the rank)
    bool decided_by_finer_pose = false;  ///< a pivot was judged zero because it shrinks on the finer pose
    bool decided_by_precision = false;   ///< … because the precision of the givens explains it

    /// Number of redundant constraints.
    int repeated() const;
    /// The structure by the rank at this pose (instantaneous).
    enum class Verdict {
        mechanism,    ///< it moves, as Grübler's count predicts
        isostatic,    ///< it is rigid, without redundant constraints
        hyperstatic,  ///< it is rigid, with `repeated()` redundant constraints
        labile        ///< it moves although the count predicts that it is rigid
    };
    Verdict verdict() const;
};
/// The name in results: "mechanism", "isostatic", "hyperstatic", "labile".
const char* name_of(Mobility::Verdict verdict);

/// On an exact pose the rank is computed by exact arithmetic (residues modulo two large primes; never too high). On a
/// pose with a leftover, by elimination in 512-bit floating point; a suspiciously small pivot is decided on a pose with
/// twice the bits, or, where the data are rounded, on poses shifted within their precision. The finer pose is drawn
/// from the file, unless `finer` supplies one.
Mobility mobility_of(const Mechanism& mechanism, const Pose& pose, const FinerPose& finer = {});

/// Bodies that no motion allowed by the joints at this pose moves against each other; the drivers do not count. Both
/// lists are by BodyIndex and give the first body of the group, which is the body itself where it moves against all
/// others.
struct RelativeRest {
    std::vector<BodyIndex> here;    ///< at this pose, perhaps in passing (a slider at its dead centre)
    std::vector<BodyIndex> always;  ///< within these: joined by their own joints to one rigid body, in every position
};

/// By the same rank as `mobility`, which must be that of this pose: one motion with arbitrary values of all freedoms
/// moves all bodies against each other that can so move. In exact arithmetic with residues modulo a prime near 2^61.
RelativeRest relative_rest(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility,
                           const FinerPose& finer = {});

/// Joints, in the file's order, whose constraints are independent of earlier ones by less than a thousandth (lengths
/// over the drawing's size): in doubles, for a remark.
std::vector<JointIndex> nearly_redundant_joints(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility);

}  // namespace kinegraph
