// Loci: the lines on which the tips of velocities and accelerations must lie, said by structure. Which line that is on
// a board, the space diagram knows (space_diagram.hpp).
#pragma once

#include <vector>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

struct Node;
using NodeIndex = ListIndex<Node>;

/// A known vector between the tips of two nodes, over which a locus of the one becomes a locus of the other.
struct Carry {
    enum class Kind {
        image,  ///< both on `body`, whose ω is known: ω ∧ XY (Rivals)
        roll    ///< the points in contact of two bodies that roll on each other, `to` the one on `body`
    };
    Kind kind = Kind::image;
    BodyIndex body = none;
    JointIndex joint = none;
    NodeIndex from = none, to = none;
};

/// A line on which the tip of a node must lie: from a known base along one direction.
struct Locus {
    enum class Kind {
        rotation,   ///< the body turns about a node already known: ⟂ to their join (Rivals)
        sleeve,     ///< slides along a guide whose point there is known (Coriolis' theorem)
        slot,       ///< the same for a pin in a straight slot, or in one curved about a centre: ∥ the tangent
        link,       ///< on the equivalent link of a contact, whose other end is known: ⟂ to it (Rivals)
        tangent,    ///< slides on a body along a common tangent; nothing is known of the curvatures
        mesh,       ///< pitch curves roll on each other: ∥ their common normal
        component,  ///< a driver fixes the component along a direction
        image,  ///< closings alone: ω of the body is known, so the image fixes what lies ⟂ to the join: ∥ to it
        driven_slide,  ///< closings alone: a driver gives the component along the guide: ⟂ to it
        roll  ///< closings alone: in contact with a point of a body on which it rolls: any line through that point's
              ///< tip
    };
    Kind kind = Kind::rotation;
    BodyIndex body = none;  ///< the body that carries the node
    NodeIndex node = none;  ///< whose tip it holds
    NodeIndex base = none;
    JointIndex joint = none;
    BodyIndex guide = none;  ///< slides: the body with the guide
    bool inverse = false;    ///< the node is the guide's point, the base the slider's
    int driver = -1;
    bool across = false;         ///< roll: along the common normal, else along the tangent
    std::vector<Carry> carries;  ///< one after the other, from `node` to the node sought

    /// The node whose tip the line holds once it is carried.
    NodeIndex holds() const { return carries.empty() ? node : carries.back().to; }
};

}  // namespace kinegraph
