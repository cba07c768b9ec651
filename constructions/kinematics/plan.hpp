// The planner: in which order the motion of a mechanism can be drawn, and by which rule each body is reached. It sees
// structure and directions only (predicates of a board of its own, its scratch paper), so that one plan serves
// velocities, accelerations and every speed of the drivers, and nothing of its search is in the solution's record. It
// computes no number of its own.
//
// Where no rule reaches, one unknown is assumed (Step::assume) and drawn for two trial values; since everything is
// linear the closing condition gives the true value. Which condition the assumption moves is asked of the drawing
// itself, with all drivers at rest. Several unknowns are nested.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constructions/kinematics/locus.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"

namespace kinegraph {

/// What must hold at the end of a trial: the tip of `locus->node` lies on the locus, or ω of `body` is that of `other`
/// (held by a joint, or set by a driver between them).
struct Closing {
    std::optional<Locus> locus;
    BodyIndex body = none, other = none;
    JointIndex joint = none;
    int driver = -1;
    bool found() const { return locus.has_value() || body != none; }
};

struct Step {
    enum class Kind {
        spin_by_joint,    ///< ω of `body` equals that of `other`: a sleeve or weld holds them
        spin_by_driver,   ///< ω of `body` from that of `other` and the driver between them
        slide_by_driver,  ///< `node` from `base` and a driven slide
        image,            ///< `node` from `base` and ω of `body`
        roll,             ///< `node` of `body` from `base` of `other`, in contact with it where they roll on each other
        meet,             ///< `node` where two loci meet
        spin_from_pair,   ///< ω of `body` from `base` and `node`
        auxiliary,        ///< Assur's point `node` of `body`: where the perpendiculars to the loci of two nodes meet
        spin_from_parallels,  ///< ω of `body` from two parallel loci (auxiliary point at infinity)
        assume  ///< the last rule: the place of `node` on the line `first`, or (node none) ω of `body`, by two trials
    };
    Kind kind = Kind::image;
    BodyIndex body = none, other = none;
    JointIndex joint = none;
    int driver = -1;
    bool inverse = false;
    NodeIndex node = none, base = none;
    Locus first, second;
    std::vector<Step> trial;  ///< assume: what is drawn from each trial value, up to the closing
    Closing closing;          ///< assume
};

/// Two loci that should have met but are parallel: a dead point of the group.
struct DeadPoint {
    NodeIndex node = none;
    Locus first, second;
};

struct Plan {
    std::vector<Step> steps;
    std::vector<bool> nodes;   ///< by NodeIndex: reached
    std::vector<bool> bodies;  ///< by BodyIndex: motion wholly known
    std::vector<bool> spins;   ///< by BodyIndex: ω known
    std::vector<DeadPoint> dead_points;
};

/// Whether a locus is what a guide, slot or slider of the observer's body lets through at the point: a direction of its
/// velocity as seen from there.
bool is_seen_from(const Structure& structure, BodyIndex observer, PointIndex point, const Locus& locus);

/// `drivers` tells which drivers to use (one that fixes nothing new is left out); `determined` which bodies' motion
/// follows from them by the rank, so that trials are made for those alone. The frame's nodes are known at the start.
/// Adds to the structure the nodes that the plan needs.
Plan plan_motion(Structure& structure, Board& scratch, const std::vector<bool>& drivers,
                 const std::vector<bool>& determined);

}  // namespace kinegraph
