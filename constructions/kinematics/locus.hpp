// Loci: the lines on which the tips of velocities and accelerations lie, as structure. The space diagram gives their
// directions on a board (space_diagram.hpp).
#pragma once

#include <vector>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

struct Node;
using NodeIndex = ListIndex<Node>;

/// A known vector between the tips of two nodes, which carries a locus of one node to the other.
struct Carry {
    enum class Kind {
        image,  ///< both on `body`, whose ω is known: ω ∧ XY (Rivals)
        roll    ///< `from` and `to` in rolling contact, `to` on `body`
    };
    Kind kind = Kind::image;
    BodyIndex body = none;
    JointIndex joint = none;
    NodeIndex from = none, to = none;
};

/// A line on which the tip of a node lies: from a known base along one direction.
struct Locus {
    enum class Kind {
        rotation,   ///< the body turns about a known node: ⟂ to their join (Rivals)
        sleeve,     ///< slides along a guide whose coincident point is known (Coriolis)
        slot,       ///< pin in a slot, straight or curved about a centre: ∥ the tangent
        link,       ///< on the equivalent link of a contact, whose other end is known: ⟂ to it (Rivals)
        tangent,    ///< slides on a body along a common tangent; the curvatures are unknown
        mesh,       ///< pitch curves roll on each other: ∥ their common normal
        component,  ///< a driver gives the component along a direction
        image,      ///< closings only: ω of the body is known, so the image gives the part ⟂ to the join: ∥ to it
        driven_slide,  ///< closings only: a driver gives the component along the guide: ⟂ to it
        roll           ///< closings only: in rolling contact with a known point: any line through that point's tip
    };
    Kind kind = Kind::rotation;
    BodyIndex body = none;
    NodeIndex node = none;  ///< the node whose tip lies on the line
    NodeIndex base = none;
    JointIndex joint = none;
    BodyIndex guide = none;  ///< slides: the body with the guide
    bool inverse = false;    ///< the node is on the guide, the base on the slider
    int driver = -1;
    bool across = false;         ///< roll: along the common normal, else along the tangent
    std::vector<Carry> carries;  ///< in order, from `node` to the node sought

    /// The node whose tip lies on the line after all carries.
    NodeIndex holds() const { return carries.empty() ? node : carries.back().to; }
};

}  // namespace kinegraph
