// The planner: in which order the motion of a mechanism can be drawn, and by which rule each body is reached. It uses
// structure and directions only (predicates of a scratch board). So one plan serves velocities, accelerations and all
// speeds of the drivers, and its search leaves nothing in the solution's record.
//
// If no rule applies, one unknown is assumed (Step::assume) and drawn for two trial values. The problem is linear, so
// the closing condition gives the true value. Which condition depends on the assumption is tested on the drawing
// itself, with all drivers at rest. Several unknowns are nested.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constructions/kinematics/locus.hpp"
#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"

namespace kinegraph {

/// Condition at the end of a trial: the tip of `locus->node` lies on the locus, or ω of `body` equals that of `other`
/// (coupled by a joint, or by a driver between them).
struct Closing {
    std::optional<Locus> locus;
    BodyIndex body = none, other = none;
    JointIndex joint = none;
    int driver = -1;
    bool found() const { return locus.has_value() || body != none; }
};

struct Step {
    enum class Kind {
        spin_by_joint,    ///< ω of `body` equals that of `other`: a sleeve or weld couples them
        spin_by_driver,   ///< ω of `body` from that of `other` and the driver between them
        slide_by_driver,  ///< `node` from `base` and a driven slide
        image,            ///< `node` from `base` and ω of `body`
        roll,             ///< `node` of `body` from `base` of `other`, its partner in a rolling contact
        meet,             ///< `node` where two loci meet
        spin_from_pair,   ///< ω of `body` from `base` and `node`
        auxiliary,        ///< Assur's point `node` of `body`: where the perpendiculars to the loci of two nodes meet
        spin_from_parallels,  ///< ω of `body` from two parallel loci (auxiliary point at infinity)
        assume  ///< trial values, if no other rule applies: `node` on the line `first`, or (node none) ω of `body`
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

/// Two loci that should meet but are parallel: a dead point of the group.
struct DeadPoint {
    NodeIndex node = none;
    Locus first, second;
};

struct Plan {
    std::vector<Step> steps;
    std::vector<bool> nodes;   ///< by NodeIndex: whether known
    std::vector<bool> bodies;  ///< by BodyIndex: whether the whole motion is known
    std::vector<bool> spins;   ///< by BodyIndex: whether ω is known
    std::vector<DeadPoint> dead_points;
};

/// Whether a locus is the direction that a guide, slot or slider on the observer's body allows to the point: a
/// direction of its velocity relative to that body.
bool is_seen_from(const Structure& structure, BodyIndex observer, PointIndex point, const Locus& locus);

/// `drivers`: which drivers to use (redundant ones are left out). `determined`: bodies whose motion is determined by
/// the rank; trials are made for those only. The frame's nodes are known at the start. Adds to the structure the nodes
/// that the plan needs.
Plan plan_motion(Structure& structure, Board& scratch, const std::vector<bool>& drivers,
                 const std::vector<bool>& determined);

}  // namespace kinegraph
