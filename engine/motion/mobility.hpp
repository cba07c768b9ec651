// Mobility: Grübler's count as textbooks write it, and the effective (instantaneous) mobility from the exact rank of
// the constraints at this pose; where they differ, which constraints are redundant. Knows nothing of velocities.
#pragma once

#include <string>
#include <vector>

#include "engine/drawing/pose.hpp"
#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

struct Mobility {
    int bodies = 0;     ///< m, the frame counted
    int class_1 = 0;    ///< pairs that leave one freedom (revolute counted with its multiplicity, prismatic, rolling)
    int class_2 = 0;    ///< pairs that leave two (pin-slot, contact, gear)
    int welds = 0;      ///< clamped joints: none left
    int gruebler = 0;   ///< 3(m−1) − 2c₁ − c₂ − 3w
    int effective = 0;  ///< 3(m−1) − rank at this pose
    struct Redundant {
        JointIndex joint = none;
        int rows = 0;
    };
    std::vector<Redundant>
        redundant;   ///< joints (in the file's order) whose constraints depend on those before, and how many
    int driven = 0;  ///< rank that the drivers add; the motion is determined when driven == effective
    std::vector<int> idle_drivers;       ///< drivers (by index) that fix nothing that is not fixed already
    std::vector<bool> determined;        ///< by BodyIndex: the body's velocity follows from the drivers (by the rank)
    bool decided_by_finer_pose = false;  ///< a pivot was judged zero because it shrank on the finer pose
    bool decided_by_precision = false;   ///< … because the precision of the givens explains it

    /// How many constraints say what others say already.
    int repeated() const;
    /// What the rank makes of the structure, at this pose: instantaneous.
    enum class Verdict {
        mechanism,    ///< it moves, as the count lets expect
        isostatic,    ///< it stands, and no constraint is too many
        hyperstatic,  ///< it stands, with `repeated()` constraints too many
        labile        ///< it moves in spite of the count
    };
    Verdict verdict() const;
};
/// As results name it: "mechanism", "isostatic", "hyperstatic", "labile".
const char* name_of(Mobility::Verdict verdict);

/// Rank by exact arithmetic (residues modulo two large primes; never too high) on an exact pose; on a pose with a
/// leftover by elimination in 512-bit floating point, where a suspiciously small pivot is judged on a pose twice as
/// fine; where the data are rounded, on poses shifted within their precision. The finer pose is drawn from the file, or
/// `finer` where that gives one.
Mobility mobility_of(const Mechanism& mechanism, const Pose& pose, const FinerPose& finer = {});

/// Joints, in the file's order, whose constraints are independent of those before, but by less than a thousandth
/// (lengths over the drawing's size): in doubles, for a remark.
std::vector<JointIndex> nearly_redundant_joints(const Mechanism& mechanism, const Pose& pose, const Mobility& mobility);

}  // namespace kinegraph
