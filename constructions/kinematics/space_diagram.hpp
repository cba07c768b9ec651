// The space diagram: the mechanism in one position on one board. Gives the places of nodes and the directions of loci
// as operations of that board, so that a plan made on a scratch board can be drawn on another.
#pragma once

#include "constructions/kinematics/structure.hpp"
#include "engine/board/board.hpp"

namespace kinegraph {

class SpaceDiagram {
public:
    SpaceDiagram(const Structure& structure, Board& board) : structure_(structure), board_(board) {}

    /// An auxiliary point is constructed where the perpendiculars to its two loci, through their nodes, meet (Assur).
    PointOn<Plane::drawing> place(NodeIndex node);
    VectorOn<Plane::drawing> join(NodeIndex from, NodeIndex to) { return board_.vector(place(from), place(to)); }
    /// The line through a node ⟂ to its locus of velocity. An absolute centre of the body, or Assur's point, is on it.
    LineOn<Plane::drawing> perpendicular_at(const Locus& locus);
    /// The direction of a locus.
    DirectionHandle direction(const Locus& locus);

private:
    DirectionHandle across_join(NodeIndex a, NodeIndex b);

    const Structure& structure_;
    Board& board_;
};

}  // namespace kinegraph
