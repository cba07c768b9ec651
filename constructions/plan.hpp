// The planner: in which order the motion of a mechanism can be drawn, and by which rule each body is reached. It sees structure
// and directions only (predicates of the board), so that one plan serves velocities, accelerations and every speed of the
// drivers. It computes no number of its own.
//
// Where no rule reaches, one unknown is assumed (Step::assume) and drawn for two trial values; since everything is linear the
// closing condition gives the true value. Which condition the assumption moves is asked of the drawing itself, with all drivers
// at rest. Several unknowns are nested.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constructions/structure.hpp"
#include "engine/board.hpp"

namespace kinegraph {

/// A known vector between the tips of two nodes, over which a locus of the one becomes a locus of the other.
struct Carry {
    enum class Kind {
        image,  ///< both on `body`, whose ω is known: ω ∧ XY (Rivals)
        roll    ///< the points in contact of two bodies that roll on each other, `to` the one on `body`
    };
    Kind kind = Kind::image;
    BodyIndex body = -1;
    JointIndex joint = -1;
    NodeIndex from = -1, to = -1;
};

/// A line on which the tip of a node must lie: from a known base along one direction.
struct Locus {
    enum class Kind {
        rotation,      ///< the body turns about a node already known: ⟂ to their join (Rivals)
        sleeve,        ///< slides along a guide whose point there is known (Coriolis' theorem)
        slot,          ///< the same for a pin in a straight slot, or in one curved about a centre: ∥ the tangent
        link,          ///< on the equivalent link of a contact, whose other end is known: ⟂ to it (Rivals)
        tangent,       ///< slides on a body along a common tangent; nothing is known of the curvatures
        mesh,          ///< pitch curves roll on each other: ∥ their common normal
        component,     ///< a driver fixes the component along a direction
        image,         ///< closings alone: ω of the body is known, so the image fixes what lies ⟂ to the join: ∥ to it
        driven_slide,  ///< closings alone: a driver gives the component along the guide: ⟂ to it
        roll           ///< closings alone: in contact with a point of a body on which it rolls: any line through that point's tip
    };
    Kind kind = Kind::rotation;
    BodyIndex body = -1;  ///< the body that carries the node
    NodeIndex node = -1;  ///< whose tip it holds
    NodeIndex base = -1;
    JointIndex joint = -1;
    BodyIndex guide = -1;  ///< slides: the body with the guide
    bool inverse = false;  ///< the node is the guide's point, the base the slider's
    int driver = -1;
    DirectionHandle direction;
    std::vector<Carry> carries;  ///< one after the other, from `node` to the node sought

    /// The node whose tip the line holds once it is carried.
    NodeIndex holds() const { return carries.empty() ? node : carries.back().to; }
};

/// What must hold at the end of a trial: the tip of `locus->node` lies on the locus, or ω of `body` is that of `other` (held by a
/// joint, or set by a driver between them).
struct Closing {
    std::optional<Locus> locus;
    BodyIndex body = -1, other = -1;
    JointIndex joint = -1;
    int driver = -1;
    bool found() const { return locus.has_value() || body >= 0; }
};

struct Step {
    enum class Kind {
        spin_by_joint,        ///< ω of `body` equals that of `other`: a sleeve or weld holds them
        spin_by_driver,       ///< ω of `body` from that of `other` and the driver between them
        slide_by_driver,      ///< `node` from `base` and a driven slide
        image,                ///< `node` from `base` and ω of `body`
        roll,                 ///< `node` of `body` from `base` of `other`, in contact with it where they roll on each other
        meet,                 ///< `node` where two loci meet
        spin_from_pair,       ///< ω of `body` from `base` and `node`
        auxiliary,            ///< Assur's point `node` of `body`: where the perpendiculars to the loci of two nodes meet
        spin_from_parallels,  ///< ω of `body` from two parallel loci (auxiliary point at infinity)
        assume  ///< the last rule: the place of `node` on the line `first`, or (node −1) ω of `body`, by two trials
    };
    Kind kind = Kind::image;
    BodyIndex body = -1, other = -1;
    JointIndex joint = -1;
    int driver = -1;
    bool inverse = false;
    NodeIndex node = -1, base = -1;
    Locus first, second;
    std::vector<Step> trial;  ///< assume: what is drawn from each trial value, up to the closing
    Closing closing;          ///< assume
};

/// Two loci that should have met but are parallel: a dead point of the group.
struct DeadPoint {
    NodeIndex node = -1;
    Locus first, second;
};

struct Plan {
    std::vector<Step> steps;
    std::vector<bool> nodes;   ///< by NodeIndex: reached
    std::vector<bool> bodies;  ///< by BodyIndex: motion wholly known
    std::vector<bool> spins;   ///< by BodyIndex: ω known
    std::vector<DeadPoint> dead_points;
};

/// `drivers` tells which drivers to use (one that fixes nothing new is left out); `determined` which bodies' motion follows from
/// them by the rank, so that trials are made for those alone. The frame's nodes are known at the start.
Plan plan_motion(Structure& structure, Board& board, const std::vector<bool>& drivers, const std::vector<bool>& determined);

}  // namespace kinegraph
